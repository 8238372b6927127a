// wet-fur: createWetFur and what it returns.
import type { GroomEdit, Tool, WetFurMethods } from './tables.js';

export type { GroomEdit, Tool, WetFurMethods };

/** Why something failed; `message` names the thing and the limit. */
export type FurErrorCode =
  | 'webgl-unavailable' | 'wasm-blocked' | 'wasm-load' | 'out-of-memory'
  | 'bad-file' | 'too-large' | 'unsupported-version' | 'network';

export class FurError extends Error {
  readonly name: 'FurError';
  readonly code: FurErrorCode;
  constructor(code: FurErrorCode, message: string);
}

export type GroomType = '1' | '2' | '3' | '4';
export type FurType = 'bald' | 'rabbit' | 'chinchilla' | 'curlyDog' | 'thickNylon' | 'fineSparse' | 'otter' | 'shortCat' | 'persian' | 'shag' | 'velvet' | 'wool';
export type Quality = 'auto' | 'low' | 'medium' | 'high';
export type Motion = 'auto' | 'full' | 'reduced';
export type WheelManner = 'page' | 'focus' | 'zoom';
export type View = 'final' | 'skin' | 'shells' | 'fins' | 'layer' | 'exploded' | 'silhouette' | 'coverage' | 'tangents' |
  'normals' | 'dominance' | 'types' | 'offset' | 'wetness' | 'clumps' | 'shadow' | 'overdraw' | 'steps' |
  'bends' | 'forces' | 'layout';
/** Texels. */
export type TileSize = '64' | '128' | '256' | '512' | '1024';
export type FurMapping = 'charts' | 'cube';
export type Shadows = 'none' | 'depth' | 'layers';
export type BendCurve = 'arc' | 'polynomial';
export type BrushFalloff = 'smooth' | 'linear' | 'sharp' | 'flat';
export type Mirror = 'none' | 'x' | 'y' | 'z';
export type StrandModel = 'kajiya' | 'marschner';
/** "#rrggbb", sRGB. */
export type Color = string;
export type ModelBytes = ArrayBuffer | ArrayBufferView | Blob;

/** Everything a person can change. Out-of-range values are clamped with a warning. */
export interface FurSettings {
  /** How many strands grow; 0 is bald. */
  density: number;
  /** Root radius of a strand; thicker coats have fewer strands. */
  thickness: number;
  /** How much shorter than the longest a strand may be. */
  lengthVariation: number;
  /** Amplitude of the waves along a strand. */
  curl: number;
  /** Blunt strands at 0, needles at 1. */
  taper: number;
  /** Length of the longest strand. */
  furLength: number;
  /** How often 256 texels of the fur tile fit along one bounding radius: more is finer. */
  repeat: number;
  /** Texels along the fur tile: larger tiles hold more strands and repeat less visibly. */
  tileSize: TileSize;
  /** How the fur tile is put on the model: charts follow its shape, a cube projects it from six sides. A model with fur coordinates of its own keeps them. */
  furMapping: FurMapping;
  /** Layers of the fur volume: more are smoother and slower. */
  layers: number;
  /** The same seed grows the same coat. */
  seed: number;
  /** Draw strands side-on along the silhouette. */
  fins: boolean;
  /** Long waves that neighbouring strands share. */
  wave: number;
  /** Curls in three dimensions: from about a third up they fold back on themselves. */
  coil: number;
  /** Fine kinks of single strands. */
  frizz: number;
  /** How tightly strands gather into locks. */
  clump: number;
  /** Strands in a lock, from a few to a whole tuft. */
  lockSize: number;
  /** How far the strands of a lock wind round each other, as in yarn. */
  roll: number;
  /** Share of strands that no lock holds. */
  stray: number;
  /** How far locks open again at their tips. */
  tipBreak: number;
  /** Fine short strands between the guard hairs; 1 is three to two. */
  undercoat: number;
  /** Of the longest undercoat strand, as a share of the longest guard hair. */
  undercoatLength: number;
  /** Colour at the skin end of a strand. */
  rootColor: Color;
  /** Colour at the tip of a strand. */
  tipColor: Color;
  /** Colour of the skin between the strands. */
  skinColor: Color;
  /** Difference in brightness from strand to strand. */
  variance: number;
  /** How much of the model's own base colour tints the fur. */
  textureAmount: number;
  /** Compass direction the light comes from, 0 = +z. */
  lightYaw: number;
  /** Angle of the light above the horizon. */
  lightPitch: number;
  /** Brightness of the key light. */
  lightIntensity: number;
  /** Colour of the key light. */
  keyColor: Color;
  /** Light direction counts from where the camera looks. */
  lightFollowsCamera: boolean;
  /** White light from the camera that softens shadows. */
  fillLight: number;
  /** Light from behind the model that shines through the edge of the fur. */
  rimLight: number;
  /** Colour of the rim light. */
  rimColor: Color;
  /** Brightness of the light from sky and ground. */
  ambient: number;
  /** Tint of the light from above. */
  skyColor: Color;
  /** Tint of the light from below. */
  groundColor: Color;
  /** Share of plain surface shading beside the strands' own (Sheppard 5.3.1). */
  lambert: number;
  /** Strength of the highlight across the strands. */
  specular: number;
  /** Exponent p of the highlight on soaked fur (Kajiya and Kay); dry fur is blunter. */
  shininess: number;
  /** How a strand shines: as a dull thread with two highlights (Kajiya and Kay), or as a rod of tinted glass that light passes through (Marschner). */
  strandModel: StrandModel;
  /** How much strands darken what lies below them (Sheppard Eq. 3.4). */
  strandShadow: number;
  /** Shadow that fur casts on itself at a distance, softer with depth: by the depth below its outer surface, or by counting the strands on the way. */
  shadows: Shadows;
  /** sigma_occ: less light reaches the roots (Silva Eq. 5). */
  occlusion: number;
  /** Brightness of the whole picture. */
  exposure: number;
  /** Radius of the spray of droplets, and of all brushes. */
  brushRadius: number;
  /** Wetness that one droplet brings. */
  brushFlow: number;
  /** Radius of a single droplet, and so of the clump that it binds. */
  clumpSize: number;
  /** Wetness that half-wet fur loses in a second. */
  dryRate: number;
  /** Water dries only where it is wiped, blown or shaken off. */
  stayWet: boolean;
  /** How hard it rains on the model. */
  rain: number;
  /** w: 0 = straight leaning strands, 1 = strands bent in from the root (Silva Eq. 1). */
  clumpShape: number;
  /** sigma_wet: how much darker soaked fur is (Silva Eq. 5). */
  wetDarkening: number;
  /** sigma_spec: how much blunter the highlight of dry fur is than that of soaked fur (Silva Eq. 3). */
  wetGloss: number;
  /** How much one pass of the comb, the scissors or the type brush does. */
  groomStrength: number;
  /** How a brush that grooms fades from its middle to its rim. */
  brushFalloff: BrushFalloff;
  /** Brushes also work on the other side of the model, across its middle along this axis; x is left and right. */
  mirror: Mirror;
  /** What the brush Paint paints; Alt+click on the model picks the colour there. */
  paintColor: Color;
  /** What the brush Cut leaves of longer fur, as a share of the longest. */
  cutLength: number;
  /** The brushes Paint, Thin, Mask, Curl, Frizz and Locks take away instead. */
  brushErases: boolean;
  /** What the type brush paints; 1 takes the others away. */
  groomType: GroomType;
  /** The coat that grows where the type brush painted 2: its strands and colours, on the same tile, no longer than Length. */
  type2: FurType;
  /** The coat that grows where the type brush painted 3: its strands and colours, on the same tile, no longer than Length. */
  type3: FurType;
  /** The coat that grows where the type brush painted 4: its strands and colours, on the same tile, no longer than Length. */
  type4: FurType;
  /** Length of the longest hair of what the whisker tool plants; those that stand keep theirs, as with all below. */
  whiskerLength: number;
  /** Width of a hair at its root; it tapers to nothing. */
  whiskerWidth: number;
  /** Hairs that one click plants: more make a tuft. */
  whiskerHairs: number;
  /** How far the hairs of a tuft fan out. */
  whiskerSpread: number;
  /** How little a hair leans with the coat round it: 1 stands whatever wind and comb do. */
  whiskerStiffness: number;
  /** Colour of the hairs. */
  whiskerColor: Color;
  /** How far its own weight bends the fur. */
  gravity: number;
  /** How strongly a strand returns to its rest direction. */
  stiffness: number;
  /** Strength of the wind. */
  wind: number;
  /** Compass direction the wind blows to, 0 = +z. */
  windYaw: number;
  /** How much the wind comes and goes. */
  gust: number;
  /** Strength of the eddies that run along with the wind. */
  turbulence: number;
  /** How a strand is bent: an arc that keeps its length, or Sheppard's (2004) polynomial, which does not; for comparison. */
  bendCurve: BendCurve;
  /** How much idle fur stirs where no wind blows, for some seconds after somebody was there. */
  breath: number;
  /** Radius of the ball that the tool Ball presses into the fur. */
  ballSize: number;
  /** Which of the model's animations plays; 0: none. */
  animation: number;
  /** How fast it plays; 0 holds it. */
  animationSpeed: number;
  /** How strongly the fur answers to the model's own motion. */
  inertia: number;
  /** Upper colour of the gradient behind the model. */
  backgroundTop: Color;
  /** Lower colour of the gradient behind the model. */
  backgroundBottom: Color;
  /** Draw the soft shadow under the model. */
  ground: boolean;
  /** What is drawn: the picture, or one part of it for study. */
  view: View;
  /** Show: layer: how high that layer stands, from the skin to the tips. */
  viewLayer: number;
}

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

export type PresetName =
  | 'rabbit' | 'chinchilla' | 'curlyDog' | 'thickNylon' | 'fineSparse'
  | 'otter' | 'shortCat' | 'persian' | 'shag' | 'velvet' | 'wool';

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
  /** "bunny", "sphere", "torus", "plane", a scene as "five-coats", or the address of a {models}. */
  src?: string;
  /**
   * Chooses a coat, and settings that are given beside it stay over it. Read: '' when the coat is no preset's. The coat grows
   * beside the page's other work, for a second or more; the old one is shown until then.
   */
  preset?: PresetName | '';
  /** Sets the light; what is set after it stays over it. Undefined when it is read: see the settings that it sets. */
  lightRig?: LightRig;
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
  progress: CustomEvent<{ stage: 'program' | 'model' | 'fur' | 'editor' | 'coat'; loaded: number; total: number; fraction: number }>;
  error: CustomEvent<{ code: FurErrorCode; message: string }>;
  warning: CustomEvent<{ message: string }>;
  'camera-change': CustomEvent<{ orbit: CameraOrbit }>;
  'wetness-change': CustomEvent<{ wetness: number }>;
  /** Keys have moved the tool's cursor, or put the tool to work there; null: it is beside the model. */
  'cursor-move': CustomEvent<{ wetness: number | null }>;
  'stroke-start': CustomEvent<{ tool: Tool; u: number; v: number }>;
  'stroke-end': CustomEvent<{ tool: Tool }>;
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
  /** Letters as clumps of wet fur, round CSS pixels of the canvas (default: its middle), `size` pixels high, turned clockwise by `angle` radians. `amount`: how wet they are (default: 0.5; wetter ones run into each other in seconds). */
  stamp(text: string, options?: { x?: number; y?: number; size?: number; angle?: number; amount?: number }): void;
  /** What was done with water since the model came, by every tool: for replay() on the same model. */
  readonly recordedStrokes: string;
  /** Does it again, with the time that it took; exact where that went by in steps of 1/60 s. Throws a FurError for what is no recording of this model. */
  replay(strokes: string, options?: { undoable?: boolean }): void;
  /** The model as it came, dry, with the look that it brought or the default; one step of undo. */
  reset(settings?: Partial<FurSettings>): Promise<void>;
  /** Where the water is and went: painted + rained = held + film + drops + dripped + evaporated + removed. */
  readonly waterAccounts: WaterAccounts | null;
  /** The atlas coordinates under CSS pixels of the canvas; null beside the model. */
  pick(at: { x: number; y: number }): { u: number; v: number } | null;
  /**
   * Dresses the whole model, as one undo step; what `value` and `direction` are is told with each edit. What the mask protects
   * stays as it is. This, length maps and all that saves fetch the editor's program.
   */
  groom(edit: GroomEdit, value?: number, direction?: readonly [number, number, number]): Promise<void>;
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
   * A type set ({coats}, Sheppard 2004): its coat is drawn until a setting changes that grows another. Waits for
   * the model. Rejects with a FurError, and then the old coat stays.
   */
  loadTypeSet(typeSet: ModelBytes, options?: { name?: string }): Promise<void>;
  /** The coat as .fts. */
  saveTypeSet(): Promise<Uint8Array>;
  /** The model with its fur coordinates as .fo (Sheppard 2004). */
  saveFo(): Promise<Uint8Array>;
  /**
   * Model, groom, what is wet, settings and camera as .glb; other programs show it bare. What that leaves out of the
   * scene or of the model's file is told by an event `warning` each.
   */
  save(): Promise<Uint8Array>;
  /** What save() would leave out, each in some words, as "2 of 3 materials"; none when the saved scene has it all. */
  lostBySaving(): Promise<string[]>;
  /**
   * The picture of this moment drawn with everything, without panel and signs of tools; as shown or of its own size, of at
   * most 4096 pixels a side. `transparent`: without background and ground, with the alpha of strands at the outline (PNG and
   * WebP have one). The editor's panel saves up to 8192 pixels a side.
   */
  toBlob(options?: { mimeType?: string; quality?: number; width?: number; height?: number; transparent?: boolean }): Promise<Blob>;
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

/** Where the files lie when they are not beside the scripts; `coreWasmUrl` is what wet-fur/core loads. */
export function configure(places: { wasmUrl?: string | URL; editorWasmUrl?: string | URL; coreWasmUrl?: string | URL; modelsUrl?: string | URL }): void;

/** Whether this browser can draw it; false outside a browser. */
export function isSupported(): boolean;
