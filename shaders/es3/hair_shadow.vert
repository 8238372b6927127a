// Strips as the light sees them, for the fur's own shadow map; or flattened on the ground, once for each of its channels.
#include "common.glsl"
#include "hair_strip.glsl"
out vec3 vPicture;  // xy: place in the strip's picture, times z
flat out float vKind;
#ifdef ON_GROUND
#include "common_ground.glsl"
out vec4 vShadow;
#endif

void main() {
  int perStrip = 6 * int(float(FUR_WISP_SEGMENTS) / pointStep);
  StripVertex v = stripVertex(gl_VertexID % perStrip, gl_VertexID / perStrip, light.xyz, 0.0);
  vPicture = v.picture;
  vKind = v.shape.z;
#ifdef ON_GROUND
  gl_Position = onGround((worldFromModel * vec4(v.position, 1.0)).xyz, gl_InstanceID, vShadow);
#else
  vec3 at = lightSpace(v.position);
  at.z = max(at.z - shadowLift(), 0.0);
  gl_Position = vec4(vec3(at.xy, at.z / shadowRange) * 2.0 - 1.0, 1.0);
#endif
}
