// One triangle that covers the screen; the second of two when vertices begin at 3.
precision highp float;
out vec2 vScreen;
flat out int vSecond;
void main() {
  int vertex = gl_VertexID % 3;
  vSecond = gl_VertexID / 3;
  vec2 corner = vec2(float((vertex & 1) << 2), float((vertex & 2) << 1));
  vScreen = corner * 0.5;
  gl_Position = vec4(corner - 1.0, 1.0, 1.0);
}
