// wet-fur/editor: the panel with every setting, on demand.
import type { WetFurApi } from './index.js';

/** Loads the editor and moves the scene into it. */
export function openEditor(fur: WetFurApi): Promise<void>;
export function closeEditor(fur: WetFurApi): Promise<void>;
/** Fetches and compiles it before it is needed. */
export function preloadEditor(onBytes?: (loaded: number, total: number) => void): Promise<void>;
