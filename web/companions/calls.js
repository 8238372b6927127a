// Methods of a figure that markup may call. A page's markup can come from others than its scripts: what is not here, such as the
// methods that every element has, is not called.
import { MarkupError, tellOthers } from './companion.js';

const callable = new Set([
  'act', 'closeEditor', 'dismissPoster', 'dry', 'groom', 'hair', 'openEditor', 'pause', 'play', 'redo', 'reload', 'replay', 'reset', 'resetCamera', 'setFurry', 'setHairValue',
  'setPadding', 'setState', 'setWetness', 'shake', 'splash', 'sprinkle', 'stamp', 'step', 'undo',
]);
/** These do not need a model. */
const beforeModel = new Set(['dismissPoster', 'pause', 'play', 'reload']);

export const needsModel = (method) => !beforeModel.has(method);

/** Throws a MarkupError for what is none of them. */
export function checkMethod(name) {
  if (!callable.has(name)) throw new MarkupError(name ? `There is no method “${name}” to call.` : 'It needs method="…".');
}

/** Calls it; what it throws, at once or later, rejects. */
export async function callIn(figure, method, args) {
  checkMethod(method);
  await figure[method](...args);
  tellOthers(figure);
}
