// The animals: { name, file(program) } each; `program`: wet-fur-make-assets. file() gives { file: bytes of a .glb, triangles }.
import { otter } from './otter/otter.mjs';
import { pony } from './pony/pony.mjs';

export const animals = [otter, pony];
