// Layers of a fur tile as pictures, cut by wet-fur/core when the pages are built.
import { PNG } from 'pngjs';

/** A corner of `side` texels of one layer: strands are white. @param {{ size: number, coverage: Uint8Array }} fur @param {number} layer 0 at the skin */
export function layerPng(fur, layer, side) {
  const png = new PNG({ width: side, height: side });
  for (let y = 0; y < side; ++y) {
    for (let x = 0; x < side; ++x) {
      const grey = 18 + 0.93 * fur.coverage[(layer * fur.size + y) * fur.size + x];
      png.data.set([grey, grey, grey, 255], 4 * (y * side + x));
    }
  }
  return PNG.sync.write(png, { colorType: 0 });
}
