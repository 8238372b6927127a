// Layers of a fur tile and the tables of Marschner's model as pictures, by wet-fur/core when the pages are built.
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

const lobes = [0, 1, 2].map((p) => ({ p, shift: [-0.131, 0.0655, 0.1965][p], share: [1, 0.5, 2][p] }));  // R, TT, TRT: hair/Marschner.h

/**
 * Marschner's functions of two angles, R, TT and TRT as red, green and blue. `M` over sin theta_i and sin theta_r, -1 to 1 each, as a share of its
 * most; `N`, over cos phi_d, -1 to 1, and upwards cos theta_d, 0 to 1, is divided by cos^2 theta_d as in the sum; its root is shown.
 * @param {object} equations of wet-fur/core @param {'M' | 'N'} which @param {number} width of R, radians
 */
export function strandTablePng({ marschnerM, marschnerN }, which, { side = 128, width = 0.13 } = {}) {
  const png = new PNG({ width: side, height: side });
  const valueOfM = (x, y) => lobes.map(({ shift, share }) => {
    const theta = 0.5 * (Math.asin(x) + Math.asin(y)), beta = share * width;
    return marschnerM(theta, shift, beta) * beta * Math.sqrt(2 * Math.PI);
  });
  const valueOfN = (x, y) => lobes.map(({ p }) => {
    const cosine = Math.max(0.5 + 0.5 * y, 0.2);
    return Math.sqrt(marschnerN(p, Math.acos(cosine), Math.acos(x), 1.55, 0) / cosine ** 2);
  });
  const at = (i) => (2 * i) / (side - 1) - 1;
  for (let y = 0; y < side; ++y) {
    for (let x = 0; x < side; ++x) {
      const value = (which === 'M' ? valueOfM : valueOfN)(at(x), -at(y));
      png.data.set([...value.map((one) => 255 * Math.min(one, 1)), 255], 4 * (y * side + x));
    }
  }
  return PNG.sync.write(png, { colorType: 2 });
}
