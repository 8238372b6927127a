// The programs of dist/ under the scripts of web/, which reach more of them than the package shows.
import { instantiateProgram, setGlue, setWasmUrl } from '../../web/runtime.js';

/** @param {'viewer'|'core'} which */
export function start(which) {
  const file = { viewer: 'wet-fur', core: 'wet-fur-core' }[which];
  setGlue(which, () => import(`../../dist/${file}.mjs`));
  setWasmUrl(which, new URL(`../../dist/${file}.wasm`, import.meta.url));
  return instantiateProgram(which);
}
