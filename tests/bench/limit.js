// The practical lower bound for shells: N layers of the same mesh in one instanced draw, inner to
// outer, one fetch from an R8 texture array per fragment, discard, blend. No light, no fins, no water.
import { install, loadMesh, makeCanvas, setting, view } from './shared.js';

const vertexSource = `#version 300 es
layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal;
layout(location = 2) in vec2 uv;
uniform mat4 clipFromModel;
uniform vec3 shape;  // fur length, layers, tiles along the uv square
out vec3 at;
out float light;
void main() {
  float layer = float(gl_InstanceID), h = layer / shape.y;
  gl_Position = clipFromModel * vec4(position + normal * (h * shape.x), 1.0);
  at = vec3(uv * shape.z, layer);
  light = (0.3 + 0.7 * h) * (0.7 + 0.3 * normal.y);
}`;
const fragmentSource = `#version 300 es
precision mediump float;
precision mediump sampler2DArray;
uniform sampler2DArray fur;
in vec3 at;
in float light;
out vec4 color;
void main() {
  float alpha = texture(fur, at).r;
  if (alpha < 0.05) discard;
  color = vec4(vec3(0.75, 0.55, 0.35) * light, alpha);
}`;

const canvas = makeCanvas();
const gl = canvas.getContext('webgl2', { antialias: setting.antialias, alpha: false });

function makeProgram() {
  const program = gl.createProgram();
  for (const [type, source] of [[gl.VERTEX_SHADER, vertexSource], [gl.FRAGMENT_SHADER, fragmentSource]]) {
    const shader = gl.createShader(type);
    gl.shaderSource(shader, source);
    gl.compileShader(shader);
    gl.attachShader(program, shader);
  }
  gl.linkProgram(program);
  if (!gl.getProgramParameter(program, gl.LINK_STATUS)) throw new Error(gl.getProgramInfoLog(program));
  return program;
}

/** Square strands of 2 x 2 texels with random heights; mipmapped and filtered as ours is. */
function makeFurTexture(layers, size = 256) {
  const heights = Float32Array.from({ length: (size / 2) ** 2 }, Math.random);
  const texels = new Uint8Array(size * size * layers);
  for (let i = 0; i < texels.length; ++i) {
    const layer = Math.floor(i / (size * size)), y = Math.floor(i / size) % size, x = i % size;
    texels[i] = layer === 0 || heights[(y >> 1) * (size / 2) + (x >> 1)] > layer / layers ? 255 : 0;
  }
  gl.bindTexture(gl.TEXTURE_2D_ARRAY, gl.createTexture());
  gl.texImage3D(gl.TEXTURE_2D_ARRAY, 0, gl.R8, size, size, layers, 0, gl.RED, gl.UNSIGNED_BYTE, texels);
  gl.generateMipmap(gl.TEXTURE_2D_ARRAY);
}

function clipFromModel() {
  const { yaw, pitch, distance, fovY } = view;
  const back = [Math.sin(yaw) * Math.cos(pitch), Math.sin(pitch), Math.cos(yaw) * Math.cos(pitch)];
  const right = [Math.cos(yaw), 0, -Math.sin(yaw)];
  const up = [back[1] * right[2], back[2] * right[0] - back[0] * right[2], -back[1] * right[0]];
  const f = 1 / Math.tan(fovY / 2), near = 0.1, far = 20, aspect = setting.width / setting.height;
  const columns = [0, 1, 2].flatMap((k) => [
    (f / aspect) * right[k], f * up[k], ((far + near) / (near - far)) * back[k], -back[k],
  ]);
  return [...columns, 0, 0, ((far + near) / (near - far)) * -distance + (2 * far * near) / (near - far), distance];
}

const mesh = await loadMesh(setting.model);
const program = makeProgram();
gl.useProgram(program);
[[mesh.positions, 3], [mesh.normals, 3], [mesh.uvs, 2]].forEach(([data, width], location) => {
  gl.bindBuffer(gl.ARRAY_BUFFER, gl.createBuffer());
  gl.bufferData(gl.ARRAY_BUFFER, data, gl.STATIC_DRAW);
  gl.enableVertexAttribArray(location);
  gl.vertexAttribPointer(location, width, gl.FLOAT, false, 0, 0);
});
gl.bindBuffer(gl.ELEMENT_ARRAY_BUFFER, gl.createBuffer());
gl.bufferData(gl.ELEMENT_ARRAY_BUFFER, mesh.indices, gl.STATIC_DRAW);
makeFurTexture(setting.layers);
gl.uniformMatrix4fv(gl.getUniformLocation(program, 'clipFromModel'), false, clipFromModel());
gl.uniform3f(gl.getUniformLocation(program, 'shape'), setting.furLength, setting.layers, 10);
gl.viewport(0, 0, setting.width, setting.height);
gl.clearColor(0.16, 0.17, 0.2, 1);
gl.enable(gl.DEPTH_TEST);
gl.depthFunc(gl.LEQUAL);
gl.enable(gl.CULL_FACE);
gl.enable(gl.BLEND);
gl.blendFunc(gl.SRC_ALPHA, gl.ONE_MINUS_SRC_ALPHA);

install(gl, () => {
  gl.clear(gl.COLOR_BUFFER_BIT | gl.DEPTH_BUFFER_BIT);
  gl.drawElementsInstanced(gl.TRIANGLES, mesh.indices.length, gl.UNSIGNED_INT, 0, setting.layers);
}, { triangles: mesh.indices.length / 3 });
