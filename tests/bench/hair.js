// Long hair on a model: ?page=hair&hair={values of the scalp, and guides}&settings={settings}&plain=1&dt=seconds&distance=of the camera.
// plain: the same geometry without light and shadow, one texel a fragment (PLAIN in hair.frag).
import { createWetFur } from '/index.js';
import { install, makeCanvas, noteContext, setting, view } from './shared.js';

const query = new URLSearchParams(location.search);
const { guides, ...values } = JSON.parse(query.get('hair') ?? '{"guides":0}');
if (query.has('plain')) {
  const { shaderSource } = WebGL2RenderingContext.prototype;
  WebGL2RenderingContext.prototype.shaderSource = function plain(shader, source) {
    shaderSource.call(this, shader, source.replace(/\n/, '\n#define PLAIN 1\n'));
  };
}
const noted = noteContext(), canvas = makeCanvas();
const fur = await createWetFur(canvas, {
  src: new URL(`/models/${setting.model}.glb`, location).href, quality: setting.antialias ? 'medium' : 'low', paused: true, dryRate: 0, lie: 0,
  cameraOrbit: `${view.yaw}rad ${view.pitch}rad ${query.get('distance') ?? view.distance}m`,
  ...JSON.parse(query.get('settings') ?? '{}'), ...query.has('plain') && { shadows: 'none' },
});
if (guides) {
  await fur.hair('addScalp');
  for (const [name, value] of Object.entries(values)) fur.setHairValue(0, name, value);
  await fur.hair('cover', 1);
  await fur.hair('plant', guides);
  await fur.hair('hang', 0.7);
}
for (const warning of fur.warnings) console.warn(warning);
if (noted.gl.drawingBufferWidth !== setting.width) throw new Error(`the buffer is ${noted.gl.drawingBufferWidth} wide`);
const dt = Number(query.get('dt') ?? 0);
install(noted.gl, () => fur.step(dt, 1));
/** Bytes that went up with the last picture. */
window.uploaded = () => fur.stats.uploadedBytes;
/** Milliseconds for a change of the value to be seen. */
window.regrow = (name, value) => {
  const begun = performance.now();
  fur.setHairValue(0, name, value);
  fur.step(0, 1);
  return performance.now() - begun;
};
