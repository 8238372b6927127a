// wet-fur: createWetFur and what it returns.
import type { Color, FurSettings, GroomEdit, HairEdit, HairValues, PictureUse, PresetName, Tool, WetFurMethods } from './tables.js';

export type * from './tables.js';

/** Why something failed; `message` names the thing and the limit. */
export type FurErrorCode =
  | 'webgl-unavailable' | 'wasm-blocked' | 'wasm-load' | 'out-of-memory'
  | 'bad-file' | 'too-large' | 'unsupported-version' | 'network' | 'program-failed';

export class FurError extends Error {
  readonly name: 'FurError';
  readonly code: FurErrorCode;
  constructor(code: FurErrorCode, message: string);
}

export type Quality = 'auto' | 'low' | 'medium' | 'high';
export type Motion = 'auto' | 'full' | 'reduced';
export type WheelManner = 'page' | 'focus' | 'zoom';
export type ModelBytes = ArrayBuffer | ArrayBufferView | Blob;

/** One row of the settings table. */
export type SettingsField = {
  readonly name: keyof FurSettings;
  readonly label: string;
  readonly group: string;
  readonly unit: string;
  /** What the field does, in a line: from wet-fur/core, and while the editor is open. */
  readonly tooltip?: string;
  /** Whether presets decide about it. */
  readonly coat: boolean;
  readonly ofType: boolean; // each fur type has its own: "type2.curl"
} & (
  | { readonly type: 'float' | 'int'; readonly default: number; readonly min: number; readonly max: number }
  | { readonly type: 'bool'; readonly default: boolean }
  | { readonly type: 'color'; readonly default: Color }
  | { readonly type: 'choice'; readonly default: string; readonly options: readonly string[] }
);

/** Angles in radians; lengths in bounding radii of the model. */
export interface CameraOrbit {
  yaw: number;
  pitch: number;
  distance: number;
  target: [number, number, number];
}

/** A light by its name: where the key light comes from, all lights' brightness and colours, exposure and background. */
export type LightRig = 'daylight' | 'studio' | 'sunset' | 'overcast' | 'backlit' | 'night';

/** A coat by its name: what it sets; the other settings of a coat take their defaults. */
export interface Preset {
  readonly name: PresetName;
  readonly label: string;
  readonly description: string;
  readonly settings: Readonly<Partial<FurSettings>>;
}

export interface WetFurOptions extends Partial<FurSettings> {
  /** "otter", "pony", "bunny", "sphere", "torus", "plane", a scene as "five-coats", or the address of a {models}. */
  src?: string;
  /**
   * Chooses a coat, and settings that are given beside it stay over it. Read: '' when the coat is no preset's. The coat grows
   * beside the page's other work, for a second or more; the old one is shown until then.
   */
  preset?: PresetName | '';
  /** Sets the light; what is set after it stays over it. Read: undefined when the light is no rig's. */
  lightRig?: LightRig;
  /** How wet the first model is when it comes, 0 to 1; set later it wets what is shown. '', the default: as its file has it. */
  wetness?: number | '';
  tool?: Tool;
  cameraControls?: boolean;
  /** "yaw pitch distance [x y z]", radians or with "deg". */
  cameraOrbit?: string | (Omit<CameraOrbit, 'target'> & { target?: [number, number, number] });
  /** "x y z": where the camera looks, in bounding radii of the model; stays over the target of `cameraOrbit`. */
  cameraTarget?: string;
  /** Of the picture's height, in degrees ("30deg" or 30), 10 to 90; "auto", the default, is 34. */
  fieldOfView?: string | number;
  /** The camera turns round the model once nobody has been there for three seconds, unless less motion is asked for. */
  autoRotate?: boolean;
  /** "auto" draws moving pictures with less where they would not hold `frameBudget`; pictures that stay, steps and saved ones not. */
  quality?: Quality;
  /** Milliseconds from one moving picture to the next, 4 to 1000; default 1000 / 60. */
  frameBudget?: number;
  /** One colour for the whole background; backgroundTop and backgroundBottom make a gradient. */
  background?: Color;
  /** Seconds that every frame advances, whatever the clock says; 0: the clock. */
  fixedDt?: number;
  paused?: boolean;
  wheel?: WheelManner;
  /** A CSS touch-action; without it the page scrolls by touch until the canvas has the focus. */
  touchAction?: string;
  motion?: Motion;
  editor?: boolean;
}

/**
 * 'suspended': nobody sees it, or the browser has no graphics context for it while others are in view. It draws nothing,
 * shows what it drew last, and does all it is told; it draws again when it is seen, or told something. 'lost': the browser
 * took its context and has not given another yet.
 */
export type WetFurState = 'idle' | 'loading' | 'ready' | 'suspended' | 'lost' | 'error' | 'unsupported' | 'disposed';

export interface WetFurStats {
  vertices: number;
  triangles: number;
  strands: number;
  layers: number;
  finEdges: number;
  cpuBytes: number;
  gpuBytes: number;
  /** By the last frame. */
  uploadedBytes: number;
  framesDrawn: number;
  /** Of the last picture: 0 is drawn with everything, up to 7 with ever less. */
  level: number;
  /** Drawn for the last picture: fewer than the canvas has when it was enlarged. */
  pixels: number;
  /** Median milliseconds from one moving picture to the next; 0: not known. */
  frameTime: number;
}

/** Amounts of water; 1 soaks the fur on a square of the model's radius. */
export interface WaterAccounts {
  held: number;
  film: number;
  drops: number;
  /** In long hair, and hanging from it. */
  hair: number;
  dripped: number;
  evaporated: number;
  removed: number;
  painted: number;
  rained: number;
}

export interface WetFurEventMap {
  /** `src` is null for a file that loadModel() was given. */
  load: CustomEvent<{ name: string; src: string | null }>;
  /** Bytes of a stage (total 0: unknown), and how far all of it is, 0..1. */
  progress: CustomEvent<{ stage: 'program' | 'model' | 'fur' | 'editor' | 'coat' | 'save'; loaded: number; total: number; fraction: number }>;
  error: CustomEvent<{ code: FurErrorCode; message: string }>;
  warning: CustomEvent<{ message: string }>;
  'camera-change': CustomEvent<{ orbit: CameraOrbit }>;
  'wetness-change': CustomEvent<{ wetness: number }>;
  /** Keys have moved the tool's cursor, or put the tool to work there; null: it is beside the model. */
  'cursor-move': CustomEvent<{ wetness: number | null }>;
  'stroke-start': CustomEvent<{ tool: Tool; u: number; v: number }>;
  'stroke-end': CustomEvent<{ tool: Tool }>;
  /** An animal begins to do something, of `actions`, and has gone on to something else. */
  'action-start': CustomEvent<{ action: string }>;
  'action-end': CustomEvent<{ action: string }>;
  /** `settings`: or the tool, or what can be undone, whoever changed it. */
  'state-change': CustomEvent<{ state: WetFurState; reason: 'loading' | 'settings' | 'editor' }>;
  /** The browser took its context. That it gave one back while nobody saw it is not told. */
  'context-lost': CustomEvent<Record<string, never>>;
  'context-restored': CustomEvent<Record<string, never>>;
  'model-visibility': CustomEvent<{ visible: boolean }>;
}

/** What the element and what createWetFur() returns have in common. */
export interface WetFurApi extends WetFurMethods {
  readonly loaded: boolean;
  /** Resolves when the first model is shown, rejects with a FurError when it cannot be. */
  readonly ready: Promise<void>;
  readonly state: WetFurState;
  /** null until the program is there. */
  readonly stats: WetFurStats | null;
  /** Live values; what is set before the program is there is kept for it. */
  readonly settings: FurSettings;
  readonly settingsTable: readonly SettingsField[] | null;
  /** null until the program is there. */
  readonly presets: readonly Preset[] | null;
  /** The newest hundred. */
  readonly warnings: string[];
  readonly modelName: string;
  readonly editorOpen: boolean;
  /** As the camera-orbit attribute takes it. */
  readonly cameraOrbitText: string;

  /** At atlas coordinates, or at CSS pixels of the canvas; whether it hit the model. */
  splash(at: { u: number; v: number } | { x: number; y: number }, options?: { radius?: number; amount?: number }): boolean;
  /** As `seconds` of drying would; all at once without. */
  dry(seconds?: number): void;
  /** Letters as clumps of wet fur, round CSS pixels of the canvas (default: its middle), `size` pixels high, turned clockwise by `angle` radians. `amount`: how wet they are (default: 0.7; wetter ones creep into each other). */
  stamp(text: string, options?: { x?: number; y?: number; size?: number; angle?: number; amount?: number }): void;
  /** What was done with water since the model came, by every tool: for replay() on the same model. */
  readonly recordedStrokes: string;
  /** Does it again, with the time that it took; exact where that went by in steps of 1/60 s. Throws a FurError for what is no recording of this model. */
  replay(strokes: string, options?: { undoable?: boolean }): void;
  /** The model as it came, dry, with the look that it brought or the default; one step of undo. */
  reset(settings?: Partial<FurSettings>): Promise<void>;
  /** Where the water is and went: painted + rained = held + film + drops + hair + dripped + evaporated + removed. */
  readonly waterAccounts: WaterAccounts | null;
  /** The atlas coordinates under CSS pixels of the canvas; null beside the model. */
  pick(at: { x: number; y: number }): { u: number; v: number } | null;
  /**
   * Dresses the whole model, as one undo step; what `value` and `direction` are is told with each edit. What the mask protects
   * stays as it is. `color`: of markings, "#rrggbb", in place of the setting `paintColor`. Rejects with a FurError where there is no
   * such edit. This, length maps and all that saves fetch the editor's program.
   */
  groom(edit: GroomEdit, value?: number, direction?: readonly [number, number, number], options?: { color?: string }): Promise<void>;
  /** The materials of the model, by their numbers: what it has several of is furry or bare, as its names say, until somebody says otherwise. */
  readonly materials: readonly { name: string; triangles: number; furry: boolean }[];
  /** Whether fur grows on one of several materials; one undo step. Throws a FurError for a number that is none of theirs. */
  setFurry(material: number, furry: boolean): void;
  /** The number of the material under CSS pixels of the canvas; -1 beside the model. */
  materialAt(at: { x: number; y: number }): number;
  /**
   * Long hair, as one undo step; what `value` and `direction` are is told with each edit. Warnings tell what could not be done; it
   * rejects with a FurError where there is no such edit. This fetches the editor's program.
   */
  hair(edit: HairEdit, value?: number, direction?: readonly [number, number, number]): Promise<void>;
  /**
   * Strands of a .hair file (Cem Yuksel's) as guides of the selected scalp, or of a new one; one undo step. Rejects with a FurError,
   * and then the hair stays as it was.
   */
  loadHair(hair: ModelBytes, options?: { name?: string }): Promise<void>;
  /** All strands of the selected scalp, as they hang at rest, as .hair. This fetches the editor's program. */
  saveHair(): Promise<Uint8Array>;
  /** A value of a scalp's hair, by its number; one undo step. Throws a FurError where there is no such scalp or value. */
  setHairValue<Name extends keyof HairValues>(scalp: number, name: Name | 'name', value: HairValues[Name] | string): void;
  /** The scalps of the model. */
  readonly scalps: readonly { name: string; guides: number; wisps: number; selected: boolean; values: HairValues }[];
  /**
   * A picture in the model's texture coordinates (over the atlas if it has none), as one undo step, and what it is; without `as`, a
   * dialog asks the person. Resolves to whether it was used. A File that the editor's "Save maps" wrote goes back where it came from.
   */
  loadPicture(picture: ModelBytes, options?: { as?: PictureUse }): Promise<boolean>;
  /**
   * An image in the model's texture coordinates: its brightness becomes the length of the fur. A File that the editor's "Save
   * maps" wrote (length, types, paint, mask or shape, by its name) goes back where it came from.
   */
  loadLengthMap(image: ModelBytes): Promise<void>;
  /** The same: red, green and blue become the presence of the fur types 2, 3 and 4. */
  loadTypeMap(image: ModelBytes): Promise<void>;
  play(): void;
  pause(): void;
  /**
   * n steps of dt seconds and one frame, at once, whatever the page's own clock does and whether anybody sees it. A coat that
   * still grows is grown first, while the page waits: after settings of a coat await a `progress` event of its last stage
   * (`coat`, fraction 1) to avoid that.
   */
  step(dt: number, n?: number): void;
  /** Leads back to the models that were shown before, too, each with all that was done on it, as far as they are kept. */
  undo(): boolean;
  redo(): boolean;
  /** JSON text: model name, settings that differ from the defaults, camera. */
  getState(): string;
  /** Throws a FurError when it cannot be used. */
  setState(state: string | object): void;
  /**
   * A {models}. Rejects with a FurError, and then the old scene stays. `files`: buffers and
   * images beside a .gltf.
   */
  loadModel(model: ModelBytes, options?: { name?: string; files?: Iterable<File> }): Promise<void>;
  /**
   * A coat ({coats}) for the fur type 1 to 4 (the one that the editor edits, else 1). Of a type set (.fts, Sheppard 2004) the strands are drawn until a setting
   * changes that grows others; a saved coat (.coat) is all of a type. Waits for the model. Rejects with a FurError, and then the old coat stays.
   */
  loadTypeSet(typeSet: ModelBytes, options?: { name?: string; type?: number }): Promise<void>;
  /** All of a fur type, 1 to 4 (1), under that name, by default its own, as .coat: values, strands of a .fts, colour map. */
  saveCoat(options?: { name?: string; type?: number }): Promise<Uint8Array>;
  /** The coat of a fur type, 1 to 4 (1), as .fts. */
  saveTypeSet(type?: number): Promise<Uint8Array>;
  /**
   * A picture as the colour map of a fur type, 1 to 4, or of the skin, in the model's texture coordinates (the atlas where it has none); null takes it away.
   * Other values of a type are settings such as "type2.curl", "type2.name" or "type2.preset".
   */
  setTypePicture(type: number | 'skin', picture: ModelBytes | null): Promise<void>;
  /** The model with its fur coordinates as .fo (Sheppard 2004). */
  saveFo(): Promise<Uint8Array>;
  /**
   * The whole scene as .glb; other programs show it bare. A model that came as glTF comes back with all that was in its file.
   * What the saved one still needs beside it is told by an event `warning` each.
   */
  save(): Promise<Uint8Array>;
  /** What save() would leave out, each in some words; none when the saved scene has it all. */
  lostBySaving(): Promise<string[]>;
  /**
   * The picture of this moment drawn with everything, without panel and signs of tools; as shown or of its own size, of at
   * most 4096 pixels a side. `transparent`: without background and ground, with the alpha of strands at the outline (PNG and
   * WebP have one). The editor's panel saves up to 8192 pixels a side. `samples`, 1 to 64: of how many the picture is the mean,
   * which takes as many times as long; default 16, and 1 without `refine`, paused and with `fixedDt`.
   */
  toBlob(options?: { mimeType?: string; quality?: number; width?: number; height?: number; transparent?: boolean; samples?: number }): Promise<Blob>;
  getCameraOrbit(): CameraOrbit | null;
  /** What lies over the picture at its edges, in CSS pixels: the model is shown in the middle of the rest. */
  setPadding(padding: { left?: number; top?: number; right?: number; bottom?: number }): void;
  openEditor(): Promise<void>;
  closeEditor(): Promise<void>;
  reload(): Promise<void>;
  dispose(): void;
}

/** One furry model on one canvas. */
export interface WetFur extends WetFurApi, EventTarget {
  readonly canvas: HTMLCanvasElement;
  src: string;
  get<Name extends keyof WetFurOptions>(name: Name): WetFurOptions[Name];
  set<Name extends keyof WetFurOptions>(name: Name, value: NonNullable<WetFurOptions[Name]>): void;
  addEventListener<Type extends keyof WetFurEventMap>(
    type: Type, listener: (event: WetFurEventMap[Type]) => void, options?: boolean | AddEventListenerOptions): void;
  addEventListener(type: string, listener: EventListenerOrEventListenerObject | null, options?: boolean | AddEventListenerOptions): void;
}

/** Draws a model (default: the bunny) on the canvas; resolves when it is there, rejects with a FurError. */
export function createWetFur(canvas: HTMLCanvasElement, options?: WetFurOptions): Promise<WetFur>;

/** Fetches and compiles the program before it is needed. */
export function preload(onBytes?: (loaded: number, total: number) => void): Promise<void>;

/**
 * Where the files lie when they are not beside the scripts; `coreWasmUrl` is what wet-fur/core loads. `gpuBudget`: bytes on the
 * graphics processor beyond which figures out of view give theirs back, by default 256 MB.
 */
export function configure(places: { gpuBudget?: number; wasmUrl?: string | URL; hairWasmUrl?: string | URL; editorWasmUrl?: string | URL; coreWasmUrl?: string | URL; modelsUrl?: string | URL }): void;

/** Whether this browser can draw it; false outside a browser. */
export function isSupported(): boolean;
