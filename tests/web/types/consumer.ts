// What a strict TypeScript user writes; tsc reads it, nothing runs it.
import { configure, createWetFur, FurError, isSupported, preload } from 'wet-fur';
import type { CameraOrbit, FurErrorCode, SettingsField, WetFur } from 'wet-fur';
import { WetFurSliderElement } from 'wet-fur/companions';
import { loadCore } from 'wet-fur/core';
import { closeEditor, openEditor, preloadEditor } from 'wet-fur/editor';
import { WetFurElement } from 'wet-fur/element';

export async function onACanvas(canvas: HTMLCanvasElement): Promise<number> {
  if (!isSupported()) throw new FurError('webgl-unavailable', 'no');
  configure({ wasmUrl: new URL('https://example.org/wet-fur.wasm') });
  await preload((loaded, total) => console.log(loaded / total));
  const fur: WetFur = await createWetFur(canvas, { src: 'otter.glb', tool: 'droplet', wind: 0.3, tipColor: '#ffffff', fins: true });
  fur.addEventListener('wetness-change', ({ detail }) => console.log(detail.wetness.toFixed(2)));
  fur.addEventListener('error', ({ detail: { code } }) => { const known: FurErrorCode = code; console.warn(known); });
  fur.settings.furLength = 0.2;
  fur.settings.view = 'wetness';
  fur.set('cameraOrbit', '20deg 10deg 3');
  fur.set('fieldOfView', 40);
  const spot = fur.pick({ x: 10, y: 20 });
  if (spot) fur.splash(spot, { radius: 0.1 });
  fur.set('preset', 'wool');
  const coats: string[] = (fur.presets ?? []).map(({ label, settings }) => `${label} ${settings.tipColor}`);
  console.log(coats.join(', '));
  fur.step(1 / 60, 30);
  const orbit: CameraOrbit | null = fur.getCameraOrbit();
  const blob: Blob = await fur.toBlob({ width: 640, height: 480, transparent: true });
  await fur.loadModel(new Uint8Array(4), { name: 'a.glb', files: [new File([], 'a.bin')] });
  await fur.loadTypeSet(await fur.saveTypeSet(), { name: 'fox.fts' });
  await fur.loadTypeSet(await fur.saveCoat({ name: 'Fox' }), { type: 2 });
  await fur.setTypePicture('skin', null);
  const saved: Uint8Array = await fur.saveFo();
  fur.set('tool', 'comb');
  await fur.groom('comb', 1, [0, -1, 0.3]);
  await fur.loadLengthMap(new Blob([]));
  await fur.loadTypeMap(new Blob([]));
  await fur.loadModel(await fur.save(), { name: 'scene.glb' });
  fur.setState(fur.getState());
  const bounds = (fur.settingsTable ?? []).map((field: SettingsField) => (field.type === 'float' ? field.max : 0));
  // @ts-expect-error there is no such setting
  fur.settings.furLenght = 1;
  // @ts-expect-error nor such a tool
  await createWetFur(canvas, { tool: 'hammer' });
  // @ts-expect-error read only
  fur.stats = null;
  fur.dispose();
  return blob.size + saved.length + (orbit?.yaw ?? 0) + Math.max(...bounds);
}

export async function onAPage(): Promise<void> {
  const element: WetFurElement = document.createElement('wet-fur');
  element.src = 'otter.glb';
  element.loading = 'lazy';
  element.behaviour = 'none';
  element.addEventListener('action-end', ({ detail: { action } }) => console.log(action));
  if (element.actions.includes('sit')) element.act('sit');
  element.preset = 'chinchilla';
  // @ts-expect-error there is no such coat
  element.preset = 'fox';
  element.reveal = 'interaction';
  element.interactionPrompt = 'none';
  element.fieldOfView = '30deg';
  element.cameraTarget = '0 0.2 0';
  element.autoRotate = true;
  element.setPadding({ bottom: 80 });
  element.addEventListener('poster-dismissed', () => element.resetCamera());
  element.dryRate = 0.1;
  element.furLength = 0.1;
  element.addEventListener('load', ({ detail }) => console.log(detail.name, detail.src));
  element.addEventListener('click', () => element.setWetness(1));
  await element.ready;
  await preloadEditor();
  await openEditor(element);
  await closeEditor(element);
  // @ts-expect-error not a manner of loading
  element.loading = 'never';
}

export async function withoutAPicture(): Promise<number> {
  const core = await loadCore();
  const volume = core.generateFur({ size: 128, density: 0.5 });
  const tangent: Float32Array = volume.tangent;
  const mask = core.createWetnessMask(256);
  mask.addDroplet({ u: 0.5, v: 0.5, radius: 0.05, wetness: 0.6 });
  mask.dry(1, { rate: 0.1 });
  const model = core.importModel(new ArrayBuffer(8), { name: 'fox.glb' });
  const [along, across] = core.equations.arcBend(0.4, 1);
  const [x, y, z]: [number, number, number] = core.equations.verletStep([0, 1, 0], [0, 1, 0], [0, -9.8, 0], 0.98, 1 / 120);
  const stiffness: number = core.equations.springStiffness(200, 0.3, 6, 2) + core.equations.tiltStiffness(1, 0.35, 0.5);
  // @ts-expect-error a vector has three parts
  core.equations.kajiyaDiffuse([0, 1], [0, 1, 0]);
  return tangent.length + mask.data.length + model.vertexCount + along + across + x + y + z + stiffness + mask.hash().length;
}

export function withCompanions(): void {
  const slider: WetFurSliderElement = document.createElement('wet-fur-slider');
  slider.setting = 'curl';
  slider.addEventListener('change', () => console.log(slider.value.toFixed(2), slider.figure?.loaded));
  document.createElement('wet-fur-choice').value = 'final';
  document.createElement('wet-fur-compare').position = 30;
  const current: number = document.createElement('wet-fur-steps').current;
  // @ts-expect-error read only
  document.createElement('wet-fur-steps').current = current;
}
