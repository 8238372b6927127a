// The fin test, edge by edge: yellow where a fin stands, blue where the shells' rays show the outline; brighter with
// opacity.
precision mediump float;
in vec4 vFin;
out vec4 fragColor;
void main() {
  fragColor = vec4(mix(vec3(0.25, 0.55, 1.0), vec3(1.0, 0.8, 0.1), vFin.y) * mix(0.35, 1.0, vFin.x), 1.0);
}
