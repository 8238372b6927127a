// A gradient behind everything: one triangle that covers the screen.
#include "common.glsl"
#include "common_gradient.glsl"
flat out mat3 vGradient;

void main() {
  vGradient = gradientOfPicture();
  gl_Position = vec4(float((gl_VertexID & 1) << 2) - 1.0, float((gl_VertexID & 2) << 1) - 1.0, 1.0, 1.0);
}
