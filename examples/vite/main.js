import 'wet-fur/element';
import 'wet-fur/companions';
// The file becomes one of the build; its address goes into src.
import bunny from 'wet-fur/models/bunny.glb?url';

document.querySelector('wet-fur').src = bunny;
