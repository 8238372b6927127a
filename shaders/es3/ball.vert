// The ball that is pressed into the fur, made of vertex numbers: six to a quad of longitude and latitude.
#include "common.glsl"
out vec3 vNormal;  // world
out vec3 vToEye;
void main() {
  int quad = gl_VertexID / 6, corner = gl_VertexID % 6;
  ivec2 at = ivec2(quad % FUR_BALL_AROUND, quad / FUR_BALL_AROUND);
  at += ivec2(corner == 1 || corner == 2 || corner == 4 ? 1 : 0, corner == 0 || corner == 1 || corner == 3 ? 1 : 0);
  vec2 angle = vec2(at) * vec2(6.2831853 / float(FUR_BALL_AROUND), 3.1415927 / float(FUR_BALL_DOWN));
  vNormal = vec3(sin(angle.x) * sin(angle.y), cos(angle.y), cos(angle.x) * sin(angle.y));
  vec3 position = ball.xyz + vNormal * ball.w;
  vToEye = (worldFromModel * vec4(eye.xyz, 1.0)).xyz - position;
  gl_Position = clipFromWorld * vec4(position, 1.0);
}
