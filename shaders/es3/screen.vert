// One triangle that covers the screen.
precision highp float;
out vec2 vScreen;
void main() {
  vec2 corner = vec2(float((gl_VertexID & 1) << 2), float((gl_VertexID & 2) << 1));
  vScreen = corner * 0.5;
  gl_Position = vec4(corner - 1.0, 1.0, 1.0);
}
