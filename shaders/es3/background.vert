// The screen, behind everything: strips from its foot to its top, two triangles each, with the gradient's colours.
#include "common.glsl"
out vec3 vColor;
out vec3 vRay;          // world space, from the eye to the far plane
flat out vec4 vGround;  // xy + z vRay.xz / vRay.y is a spot of ground, 0..1 over the shadow map  w: how dark shadows are
const vec2 kCorners[6] = vec2[6](vec2(0.0, 0.0), vec2(1.0, 0.0), vec2(0.0, 1.0), vec2(0.0, 1.0), vec2(1.0, 0.0), vec2(1.0, 1.0));
void main() {
  vec2 corner = kCorners[gl_VertexID % 6];
  float y = (float(gl_VertexID / 6) + corner.y) / float(FUR_BACKGROUND_STRIPS);
  gl_Position = vec4(corner.x * 2.0 - 1.0, y * 2.0 - 1.0, 1.0, 1.0);
  vColor = mix(backgroundBottom.rgb, backgroundTop.rgb, smoothstep(0.0, 1.0, y));
  vec4 far = inverse(clipFromWorld) * gl_Position;
  vec3 from = (worldFromModel * vec4(eye.xyz, 1.0)).xyz;
  vRay = far.xyz / far.w - from;
  float above = from.y - groundPlane.x;
  vGround.xyz = vec3((from.xz - groundCentre.xy) / groundPlane.y, -above / groundPlane.y) * 0.5 + vec3(0.5, 0.5, 0.0);
  // From below the ground would hide the model.
  vGround.w = above > 0.0 ? groundPlane.z : 0.0;
}
