// One triangle that covers the screen, behind everything, with the ray through every pixel.
#include "common.glsl"
out vec2 vScreen;
out vec3 vRay;  // world space, from the eye to the far plane
flat out vec3 vEye;
void main() {
  vec2 corner = vec2(float((gl_VertexID & 1) << 2), float((gl_VertexID & 2) << 1));
  vScreen = corner * 0.5;
  gl_Position = vec4(corner - 1.0, 1.0, 1.0);
  vec4 far = inverse(clipFromWorld) * gl_Position;
  vEye = (worldFromModel * vec4(eye.xyz, 1.0)).xyz;
  vRay = far.xyz / far.w - vEye;
}
