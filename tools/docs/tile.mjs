// Layers of a fur tile as pictures, cut by wet-fur/core when the pages are built.
import { PNG } from 'pngjs';

/**
 * A corner of `side` texels of one layer, enlarged: strands white, or with `colours` each in a colour of its own.
 * @param {import('../../web/types/core.js').FurVolume} fur @param {number} layer 0 at the skin
 */
export function layerPng(fur, layer, { side = 128, scale = 2, colours = false } = {}) {
  const png = new PNG({ width: side * scale, height: side * scale, colorType: 2 });
  for (let y = 0; y < side * scale; ++y) {
    for (let x = 0; x < side * scale; ++x) {
      const at = (layer * fur.size + Math.floor(y / scale)) * fur.size + Math.floor(x / scale);
      const cover = fur.coverage[at] / 255, id = fur.strandId[at];
      const hue = [0, 1, 2].map((c) => (colours ? 0.55 + 0.45 * Math.cos(2.4 * id + 2.1 * c) : 1));
      hue.forEach((value, c) => { png.data[4 * (y * side * scale + x) + c] = Math.round(255 * (0.07 + 0.93 * cover * value)); });
      png.data[4 * (y * side * scale + x) + 3] = 255;
    }
  }
  return PNG.sync.write(png, { colorType: 2 });
}
