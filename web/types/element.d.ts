// wet-fur/element: registers <wet-fur>.
import type { FurSettings, LightRig, Motion, PresetName, Quality, Tool, WetFurApi, WetFurEventMap, WheelManner } from './index.js';

export interface WetFurElementEventMap extends WetFurEventMap {
  /** The picture has taken the place of the poster. */
  'poster-dismissed': CustomEvent<null>;
}

export class WetFurElement extends HTMLElement {
  src: string;
  alt: string;
  poster: string;
  loading: 'auto' | 'lazy' | 'eager';
  /** 'interaction': nothing is loaded before the poster is pressed; 'manual': before dismissPoster(). */
  reveal: 'auto' | 'interaction' | 'manual';
  /** Whether the poster of reveal="interaction" shows that it can be pressed; the slot of that name takes another cue. */
  interactionPrompt: 'auto' | 'none';
  preset: PresetName | '';
  wetness: number | '';
  /** Attribute light-rig. */
  lightRig: LightRig | undefined;
  tool: Tool;
  cameraControls: boolean;
  cameraOrbit: string;
  cameraTarget: string;
  fieldOfView: string;
  autoRotate: boolean;
  quality: Quality;
  frameBudget: number;
  background: string;
  fixedDt: number;
  paused: boolean;
  wheel: WheelManner;
  touchAction: string;
  motion: Motion;
  editor: boolean;
  /** Loads what the poster stands for, whatever `reveal` waits for. */
  dismissPoster(): void;
  addEventListener<Type extends keyof WetFurElementEventMap>(
    type: Type, listener: (event: WetFurElementEventMap[Type]) => void, options?: boolean | AddEventListenerOptions): void;
  addEventListener(type: string, listener: EventListenerOrEventListenerObject, options?: boolean | AddEventListenerOptions): void;
}
/** Every field of the settings table is a property too, once the program is loaded; `settings` takes them at once. */
export interface WetFurElement extends WetFurApi, FurSettings {}

declare global {
  interface HTMLElementTagNameMap {
    'wet-fur': WetFurElement;
  }
}
