// Layers of a fur tile as pictures, cut by wet-fur/core when the pages are built.
import { PNG } from 'pngjs';

/**
 * A corner of `side` texels of one layer in grey: its coverage, or with `channel` another one, where strands are or with `filled` everywhere.
 * @param {object} fur a FurVolume @param {number} layer 0 at the skin @param {{ side?: number, channel?: 'coverage' | 'dominance' | 'variance', filled?: boolean }} look
 */
export function layerPng(fur, layer, { side = 128, channel = 'coverage', filled = channel === 'coverage' }) {
  const png = new PNG({ width: side, height: side });
  for (let y = 0; y < side; ++y) {
    for (let x = 0; x < side; ++x) {
      const at = (layer * fur.size + y) * fur.size + x, grey = 18 + 0.93 * fur[channel][at] * (filled ? 1 : fur.coverage[at] / 255);
      png.data.set([grey, grey, grey, 255], 4 * (y * side + x));
    }
  }
  return PNG.sync.write(png, { colorType: 0 });
}
