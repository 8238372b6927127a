// What both bench pages share: the setting in the address, the mesh, the camera, how a frame is timed.

const query = new URLSearchParams(location.search);
export const setting = {
  model: query.get('mesh') ?? 'plain-bunny',
  layers: Number(query.get('shells') ?? 32),
  width: Number(query.get('width') ?? 800),
  height: Number(query.get('height') ?? 600),
  furLength: Number(query.get('length') ?? 0.06),
  antialias: query.get('aa') === '1',
};

/** The one view of every page: yaw and pitch in radians, the unit sphere fills 80 % of the height. */
export const view = { yaw: 0.34, pitch: 0.28, distance: 1 / Math.sin(Math.atan(0.8 * Math.tan(0.3))), fovY: 0.6 };

export function makeCanvas() {
  const canvas = document.createElement('canvas');
  canvas.width = setting.width;
  canvas.height = setting.height;
  canvas.style.cssText = `display:block;width:${setting.width}px;height:${setting.height}px`;
  document.body.append(canvas);
  return canvas;
}

/** { gl }: the last context that the element has made. What it draws in is not the canvas's own: it is noted as it is made. */
export function noteContext() {
  const noted = { gl: null };
  const { getContext } = OffscreenCanvas.prototype;
  OffscreenCanvas.prototype.getContext = function note(type, ...rest) {
    const context = getContext.call(this, type, ...rest);
    if (type === 'webgl2') noted.gl = context;
    return context;
  };
  return noted;
}

/** Defines window.bench(n): n times milliseconds, each until a pixel of the frame has been read back. */
export function install(gl, frame, info = {}, drawn = false) {
  const pixel = new Uint8Array(4);
  const finish = () => gl.readPixels(setting.width >> 1, setting.height >> 1, 1, 1, gl.RGBA, gl.UNSIGNED_BYTE, pixel);
  const timed = () => {
    const start = performance.now();
    frame();
    finish();
    return performance.now() - start;
  };
  drawn ? finish() : timed();
  window.firstFrameMs = performance.now();
  window.info = info;
  window.bench = (n) => Array.from({ length: n }, timed);
}

/** Positions, normals, uv and indices of a .glb as the project's own exporter writes it. */
export async function loadMesh(name) {
  const bytes = await (await fetch(`/models/${name}.glb`)).arrayBuffer();
  const head = new DataView(bytes);
  const jsonLength = head.getUint32(12, true);
  const gltf = JSON.parse(new TextDecoder().decode(new Uint8Array(bytes, 20, jsonLength)));
  const start = 28 + jsonLength;
  const arrays = { 5126: Float32Array, 5125: Uint32Array, 5123: Uint16Array };
  const read = (index, width) => {
    const accessor = gltf.accessors[index], part = gltf.bufferViews[accessor.bufferView];
    const from = start + (part.byteOffset ?? 0) + (accessor.byteOffset ?? 0);
    return new arrays[accessor.componentType](bytes.slice(from), 0, accessor.count * width);
  };
  const { attributes, indices } = gltf.meshes[0].primitives[0];
  const mesh = {
    positions: read(attributes.POSITION, 3), normals: read(attributes.NORMAL, 3), uvs: read(attributes.TEXCOORD_0, 2),
    indices: Uint32Array.from(read(indices, 1)),
  };
  fitToUnitSphere(mesh.positions);
  return mesh;
}

function fitToUnitSphere(p) {
  const low = [Infinity, Infinity, Infinity], high = low.map((x) => -x);
  p.forEach((x, i) => { low[i % 3] = Math.min(low[i % 3], x); high[i % 3] = Math.max(high[i % 3], x); });
  p.forEach((x, i) => { p[i] = x - (low[i % 3] + high[i % 3]) / 2; });
  let radius = 0;
  for (let i = 0; i < p.length; i += 3) radius = Math.max(radius, Math.hypot(p[i], p[i + 1], p[i + 2]));
  p.forEach((x, i) => { p[i] = x / radius; });
}
