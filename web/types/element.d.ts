// wet-fur/element: registers <wet-fur>.
import type { FurSettings, Motion, PresetName, Quality, Tool, WetFurApi, WetFurEventMap, WheelManner } from './index.js';

export class WetFurElement extends HTMLElement {
  src: string;
  alt: string;
  poster: string;
  loading: 'auto' | 'lazy' | 'eager';
  reveal: 'auto' | 'interaction';
  preset: PresetName | '';
  tool: Tool;
  cameraControls: boolean;
  cameraOrbit: string;
  quality: Quality;
  frameBudget: number;
  background: string;
  fixedDt: number;
  paused: boolean;
  wheel: WheelManner;
  touchAction: string;
  motion: Motion;
  editor: boolean;
  addEventListener<Type extends keyof WetFurEventMap>(
    type: Type, listener: (event: WetFurEventMap[Type]) => void, options?: boolean | AddEventListenerOptions): void;
  addEventListener(type: string, listener: EventListenerOrEventListenerObject, options?: boolean | AddEventListenerOptions): void;
}
/** Every field of the settings table is a property too, once the program is loaded; `settings` takes them at once. */
export interface WetFurElement extends WetFurApi, FurSettings {}

declare global {
  interface HTMLElementTagNameMap {
    'wet-fur': WetFurElement;
  }
}
