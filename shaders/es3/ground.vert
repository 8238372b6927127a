// The square of ground that the shadow map covers.
#include "common.glsl"
out vec2 vGround;  // -1..1 over the shadow map
const vec2 kCorners[6] = vec2[6](vec2(-1.0, -1.0), vec2(-1.0, 1.0), vec2(1.0, 1.0),
                                 vec2(-1.0, -1.0), vec2(1.0, 1.0), vec2(1.0, -1.0));
void main() {
  vGround = kCorners[gl_VertexID];
  vec2 spot = groundCentre.xy + vGround * groundPlane.y;
  gl_Position = clipFromWorld * vec4(spot.x, groundPlane.x, spot.y, 1.0);
  gl_Position.z = gl_Position.w;  // behind everything, before the background
}
