// The ring's coat: fields of the settings table are properties of the element.
import './element.js';

Object.assign(document.getElementById('ring').settings, {
  furLength: 0.1, density: 1, thickness: 0.2, curl: 0.6, rootColor: '#231d22', tipColor: '#7b6f80', skinColor: '#3a2f36',
});
