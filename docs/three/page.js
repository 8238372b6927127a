// Fur of wet-fur/core on a mesh of three.js: shells in one instanced draw, and a wetness mask whose clumps the shader draws.
import {
  BufferAttribute, DataArrayTexture, DataTexture, DirectionalLight, DoubleSide, FloatType, GLSL3, HemisphereLight, InstancedBufferGeometry, LinearFilter,
  LinearMipmapLinearFilter, Mesh, MeshStandardMaterial, NearestFilter, PerspectiveCamera, Raycaster, RepeatWrapping, RGBAFormat, Scene, ShaderMaterial,
  TorusGeometry, Vector2, Vector3, WebGLRenderer,
} from 'three';
import { OrbitControls } from 'three/addons/controls/OrbitControls.js';
import { loadCore } from '../../core.js';
import { fragmentShader, vertexShader } from './shaders.js';

const layers = 32, size = 256, repeat = new Vector2(6, 4);

/** The layers of a tile as one texture: tangent x and y, variance, coverage. */
function furTexture(fur) {
  const data = new Uint8Array(4 * size * size * layers);
  for (let i = 0; i < size * size * layers; ++i) {
    data[4 * i] = 127.5 + 127.5 * fur.tangent[3 * i];
    data[4 * i + 1] = 127.5 + 127.5 * fur.tangent[3 * i + 1];
    data[4 * i + 2] = fur.variance[i];
    data[4 * i + 3] = fur.coverage[i];
  }
  const texture = new DataArrayTexture(data, size, size, layers);
  Object.assign(texture, { format: RGBAFormat, wrapS: RepeatWrapping, wrapT: RepeatWrapping, magFilter: LinearFilter, minFilter: LinearMipmapLinearFilter, generateMipmaps: true, needsUpdate: true });
  return texture;
}

/** The mask as it is: clump centre u and v, radius, wetness. Never filtered: the mean of two centres is the centre of nothing. */
function maskTexture(mask) {
  const texture = new DataTexture(mask.data, mask.size, mask.size, RGBAFormat, FloatType);
  Object.assign(texture, { magFilter: NearestFilter, minFilter: NearestFilter, needsUpdate: true });
  return texture;
}

/** As many copies of the surface as there are layers, in one draw: the number of the copy is gl_InstanceID. */
function shellsOf(geometry) {
  const shells = new InstancedBufferGeometry();
  shells.index = geometry.index;
  for (const name of ['position', 'normal', 'uv']) shells.setAttribute(name, geometry.attributes[name]);
  geometry.computeTangents();
  shells.setAttribute('surfaceTangent', new BufferAttribute(geometry.attributes.tangent.array, 4));
  shells.instanceCount = layers;
  return shells;
}

async function main() {
  const canvas = document.getElementById('canvas');
  const core = await loadCore();
  const fur = core.generateFur({ size, layers, density: 0.9, thickness: 0.35, curl: 0.25, lengthVariation: 0.3, seed: 1 });
  const mask = core.createWetnessMask(256);

  const renderer = new WebGLRenderer({ canvas, antialias: true, alpha: true });
  const scene = new Scene(), camera = new PerspectiveCamera(34, 1, 0.1, 20);
  camera.position.set(0.8, 1.5, 4.2);
  const toLight = new Vector3(-0.5, 0.8, 0.55).normalize();
  const sun = new DirectionalLight(0xffffff, 2);
  sun.position.copy(toLight);
  scene.add(sun, new HemisphereLight(0xffffff, 0x8a7a6a, 1));

  const geometry = new TorusGeometry(0.75, 0.42, 48, 96);
  const skin = new Mesh(geometry, new MeshStandardMaterial({ color: 0x3a2a20, roughness: 1 }));
  const uniforms = {
    fur: { value: furTexture(fur) }, mask: { value: maskTexture(mask) }, repeat: { value: repeat }, layers: { value: layers }, furLength: { value: 0.17 },
    toLight: { value: toLight }, clumpShape: { value: 0.6 },
  };
  const coat = new Mesh(shellsOf(geometry), new ShaderMaterial({
    glslVersion: GLSL3, uniforms, vertexShader, fragmentShader, transparent: true, depthWrite: false, side: DoubleSide,
  }));
  coat.frustumCulled = false;  // the shader makes it larger than the geometry
  skin.rotation.x = coat.rotation.x = -1.1;
  scene.add(skin, coat);

  const draw = () => {
    const { clientWidth, clientHeight } = canvas;
    renderer.setPixelRatio(Math.min(devicePixelRatio, 2));
    renderer.setSize(clientWidth, clientHeight, false);
    camera.aspect = clientWidth / Math.max(clientHeight, 1);
    camera.updateProjectionMatrix();
    renderer.render(scene, camera);
  };
  const wet = (droplets) => {
    for (const droplet of droplets) mask.addDroplet(droplet);
    uniforms.mask.value.image.data = mask.data;
    uniforms.mask.value.needsUpdate = true;
    draw();
  };

  const controls = new OrbitControls(camera, canvas);
  controls.enableZoom = controls.enablePan = false;  // the wheel is the page's
  controls.addEventListener('change', draw);
  controls.listenToKeyEvents(canvas);
  new ResizeObserver(draw).observe(canvas);
  document.getElementById('length').addEventListener('input', ({ target }) => {
    uniforms.furLength.value = Number(target.value);
    draw();
  });
  document.getElementById('soak').addEventListener('click', () => wet(Array.from({ length: 160 }, () => ({ u: Math.random(), v: Math.random(), radius: 0.03, wetness: 0.75 }))));
  document.getElementById('dry').addEventListener('click', () => {
    mask.clear();
    wet([]);
  });
  const ray = new Raycaster();
  canvas.addEventListener('click', ({ offsetX, offsetY }) => {
    ray.setFromCamera(new Vector2(2 * offsetX / canvas.clientWidth - 1, 1 - 2 * offsetY / canvas.clientHeight), camera);
    const [hit] = ray.intersectObject(skin);
    if (hit) wet([{ u: hit.uv.x, v: hit.uv.y, radius: 0.05, wetness: 0.7 }]);
  });
  draw();
  document.documentElement.dataset.ready = '';
}

main().catch((error) => { document.getElementById('message').textContent = `It could not be drawn: ${error.message}`; });
