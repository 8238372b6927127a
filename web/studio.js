// Files of what the editor's section "Picture" draws, band by band: a PNG, or a film of one turn.
import { FurError } from './errors.js';

/** So that the panel shows how far it is, and hears a Cancel. */
const breathe = () => new Promise((resolve) => { requestAnimationFrame(() => setTimeout(resolve)); });
const sleep = (milliseconds) => new Promise((resolve) => { setTimeout(resolve, milliseconds); });

const filmTypes = ['video/webm;codecs=vp9', 'video/webm;codecs=vp8', 'video/webm', 'video/mp4'];
const bitsPerPixel = 0.35;
const [leastBitRate, mostBitRate] = [4e6, 80e6];
/** A recorder stamps frames with the time at which they come, so each is shown as long as it lasts. */
const settleMilliseconds = 80;

/** Draws the next frame on the canvas; false: it was given up. */
async function drawFrame(panel, canvas, context) {
  for (;;) {
    const band = panel.nextBand();
    if (!band) return null;
    const { width, height } = band;
    if (canvas.width !== width || canvas.height !== height) Object.assign(canvas, { width, height });
    context.putImageData(new ImageData(band.rgba, width, band.rows), 0, band.top);
    if (band.last) return band;
    await breathe();
  }
}

/** @param {import('./editor.js').EditorPanel} panel @returns {Promise<{ blob: Blob, name: string } | null>} null: given up */
export async function savePicture(panel, name) {
  const canvas = new OffscreenCanvas(1, 1);
  const band = await drawFrame(panel, canvas, canvas.getContext('2d'));
  if (!band) return null;
  const blob = await canvas.convertToBlob().catch(() => {
    throw new FurError('out-of-memory', `this browser has no memory for a picture of ${band.width} x ${band.height}`);
  });
  return { blob, name };
}

/** The same of one turn: each frame is drawn in full, whatever that takes, and shown to a recorder that stands still meanwhile. */
export async function saveTurntable(panel, name) {
  const type = globalThis.MediaRecorder && filmTypes.find((one) => MediaRecorder.isTypeSupported(one));
  const canvas = document.createElement('canvas');
  if (!type || !canvas.captureStream) throw new FurError('webgl-unavailable', 'this browser cannot record a video (it has no MediaRecorder for WebM or MP4)');
  const context = canvas.getContext('2d', { alpha: false });
  let band = await drawFrame(panel, canvas, context);
  if (!band) return null;
  const stream = canvas.captureStream(0);
  const [track] = stream.getVideoTracks();
  const chunks = [];
  const bitRate = Math.min(mostBitRate, Math.max(leastBitRate, band.width * band.height * band.rate * bitsPerPixel));
  const recorder = new MediaRecorder(stream, { mimeType: type, videoBitsPerSecond: bitRate });
  recorder.ondataavailable = ({ data }) => chunks.push(data);
  const stopped = new Promise((resolve, reject) => {
    recorder.onstop = resolve;
    recorder.onerror = ({ error }) => reject(error ?? new Error('the browser gave up recording'));
  });
  recorder.start();
  const shownFor = 1000 / band.rate;
  while (band) {
    if (recorder.state === 'paused') recorder.resume();
    const since = performance.now();
    (track.requestFrame ? track : stream).requestFrame();
    await sleep(Math.max(0, shownFor - (performance.now() - since)));
    if (band.frame + 1 === band.frames) break;
    recorder.pause();
    band = await drawFrame(panel, canvas, context);
  }
  await sleep(settleMilliseconds);
  recorder.stop();
  await stopped;
  track.stop();
  if (!band) return null;
  return { blob: new Blob(chunks, { type: type.split(';')[0] }), name: `${name}.${type.slice(6).split(';')[0]}` };
}
