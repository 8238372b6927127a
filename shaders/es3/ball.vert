#include "common.glsl"
#include "common_ball.glsl"
out vec3 vNormal;  // world
out vec3 vToEye;
void main() {
  vNormal = ballNormal(gl_VertexID);
  vec3 position = ballCentre.xyz + vNormal * ballRadius;
  vToEye = (worldFromModel * vec4(eye.xyz, 1.0)).xyz - position;
  gl_Position = clipFromWorld * vec4(position, 1.0);
}
