// Pictures of one figure as it would be with other values: set, drawn out of sight and taken back within one task, so that nobody sees
// the figure change, its water, camera and time are those of the moment, and undo leads where it led before.
import { setQuietly, valueIn } from './values.js';

const samples = 4;

/** @returns {Promise<Blob>} of the figure with these values, seen from `cameraOrbit` if that is among them */
export function pictureWith(figure, { cameraOrbit, ...values }) {
  const orbit = figure.cameraOrbitText;
  if (cameraOrbit) figure.cameraOrbit = cameraOrbit;
  const before = Object.entries(values).map(([name]) => [name, valueIn(figure, name)]);
  let steps = 0;
  for (const [name, value] of Object.entries(values)) {
    const had = valueIn(figure, name);
    if (had === value) continue;
    setQuietly(figure, name, value);
    if (valueIn(figure, name) !== had) ++steps;
  }
  try {
    return figure.toBlob({ mimeType: 'image/webp', quality: 0.92, samples });  // the surface is copied now
  } finally {
    while (steps-- > 0) figure.undo();
    // A step that had joined a person's own has taken that back as well: it is done again.
    for (const [name, value] of before) if (valueIn(figure, name) !== value) setQuietly(figure, name, value);
    if (cameraOrbit) figure.cameraOrbit = orbit;
  }
}
