// wet-fur/editor: the panel with every setting, on demand.
import type { WetFurApi } from './index.js';

/**
 * Loads the editor and moves the scene into it. While it is open the document has the CSS variable
 * `--wet-fur-panel-width`: how far the panel reaches in from the right edge of the element, for what lies beside it; 0px
 * while it is closed to its title or a sheet at the bottom. What size a person gave it is kept in `localStorage`.
 */
export function openEditor(fur: WetFurApi): Promise<void>;
export function closeEditor(fur: WetFurApi): Promise<void>;
/** Fetches and compiles it before it is needed. */
export function preloadEditor(onBytes?: (loaded: number, total: number) => void): Promise<void>;
