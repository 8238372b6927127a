// Files of what the editor's section "Picture" draws, band by band: a PNG, or a film of one turn.
import { FurError } from './errors.js';
import { webm } from './webm.js';

/** So that the panel shows how far it is, and hears a Cancel. */
const breathe = () => new Promise((resolve) => { requestAnimationFrame(() => setTimeout(resolve)); });
const sleep = (milliseconds) => new Promise((resolve) => { setTimeout(resolve, milliseconds); });

const codecs = [['vp09.00.51.08', 'V_VP9'], ['vp8', 'V_VP8']];
const recordedTypes = ['video/webm;codecs=vp9', 'video/webm;codecs=vp8', 'video/webm', 'video/mp4'];
const bitsPerPixel = 0.35;
const bitRateOf = ({ width, height, rate }) => Math.min(80e6, Math.max(4e6, width * height * rate * bitsPerPixel));
/** Frames that wait for the encoder hold memory. */
const mostWaiting = 4;
/** A recorder is given the time to take the last frame. */
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

async function usableCodec(film) {
  if (!globalThis.VideoEncoder) return null;
  for (const [codec, name] of codecs) {
    const config = { codec, width: film.width, height: film.height, framerate: film.rate, bitrate: bitRateOf(film) };
    const answer = await VideoEncoder.isConfigSupported(config).catch(() => null);
    if (answer?.supported) return { config, name };
  }
  return null;
}

/** Each frame has its own time, however long it took: WebCodecs. `next` draws one. */
async function encode(film, { config, name }, canvas, next) {
  const frames = [];
  let failure = null;
  const encoder = new VideoEncoder({
    output: (chunk) => {
      const data = new Uint8Array(chunk.byteLength);
      chunk.copyTo(data);
      frames.push({ data, isKey: chunk.type === 'key' });
    },
    error: (error) => { failure = error; },
  });
  encoder.configure(config);
  for (let band = film; band; band = band.frame + 1 < band.frames && await next()) {
    const frame = new VideoFrame(canvas, { timestamp: Math.round(1e6 * band.frame / film.rate) });
    if (!failure) encoder.encode(frame, { keyFrame: band.frame % film.rate === 0 });
    frame.close();
    while (!failure && encoder.encodeQueueSize > mostWaiting) await sleep(2);
    if (failure) throw failure;
  }
  await encoder.flush();
  encoder.close();
  return { blob: new Blob([webm(frames, { codec: name, ...film })], { type: 'video/webm' }), count: frames.length };
}

/** The same by a recorder that stands still while a frame is drawn: as even as timers are. */
async function record(film, canvas, next) {
  const type = globalThis.MediaRecorder && recordedTypes.find((one) => MediaRecorder.isTypeSupported(one));
  if (!type || !canvas.captureStream)
    throw new FurError('webgl-unavailable', 'this browser can make no video: it has neither VideoEncoder nor MediaRecorder for WebM or MP4');
  const stream = canvas.captureStream(0);
  const [track] = stream.getVideoTracks();
  const chunks = [];
  const recorder = new MediaRecorder(stream, { mimeType: type, videoBitsPerSecond: bitRateOf(film) });
  recorder.ondataavailable = ({ data }) => chunks.push(data);
  const stopped = new Promise((resolve, reject) => {
    recorder.onstop = resolve;
    recorder.onerror = ({ error }) => reject(error ?? new Error('the browser gave up recording'));
  });
  recorder.start();
  let count = 0;
  for (let band = film; band;) {
    if (recorder.state === 'paused') recorder.resume();
    (track.requestFrame ? track : stream).requestFrame();
    count++;
    await sleep(1000 / film.rate);
    if (band.frame + 1 === band.frames) break;
    recorder.pause();
    band = await next();
  }
  await sleep(settleMilliseconds);
  recorder.stop();
  await stopped;
  track.stop();
  return { blob: new Blob(chunks, { type: type.split(';')[0] }), count };
}

/** The same of one turn, each frame drawn in full whatever that takes. */
export async function saveTurntable(panel, name) {
  const canvas = document.createElement('canvas');
  const context = canvas.getContext('2d', { alpha: false });
  const next = async () => {
    await breathe();
    return drawFrame(panel, canvas, context);
  };
  const film = await next();
  if (!film) return null;
  const codec = await usableCodec(film);
  const { blob, count } = await (codec ? encode(film, codec, canvas, next) : record(film, canvas, next));
  if (count < film.frames) return null;
  return { blob, name: `${name}.${blob.type === 'video/mp4' ? 'mp4' : 'webm'}` };
}
