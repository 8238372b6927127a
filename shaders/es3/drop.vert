// Water in the air: one instance each, a drop as long as the way that it goes while the picture is taken, or what it leaves
// where it lands.
#include "common.glsl"

layout(location = FUR_DROP_PLACE) in vec4 place;
layout(location = FUR_DROP_WAY) in vec4 way;
layout(location = FUR_DROP_KIND) in vec2 kind;

out vec2 vAt;         // across and along, in radii across, and a pixel more
flat out vec4 vSize;  // x: radius across in pixels  y: share of a pixel that what is smaller covers  z: half the way, in radii across
                      // w: how opaque
flat out mat3 vFrame; // across, along, towards the eye; world
flat out float vPasses; // 0: a ball  to 1: much longer than wide  -1: a piece of a jet  -2: a ring
void main() {
  vec3 toEye = (worldFromModel * vec4(eye.xyz, 1.0)).xyz - place.xyz;
  float distance = length(toEye), path = length(way.xyz), pixels = pixelsPerUnit / distance, radius = place.w;
  toEye /= distance;
  vec3 along = path > 1e-5 ? way.xyz / path : vec3(0.0, 1.0, 0.0), across;
  bool ring = kind.y > 0.0 && path == 0.0;
  if (ring) along = vec3(0.0, 0.0, 1.0), toEye = along.yzx, radius *= sqrt(kind.y);
  along -= toEye * dot(along, toEye);
  float slant = length(along);  // none when it comes straight at the eye
  along = slant > 1e-3 ? along / slant : normalize(cross(toEye, vec3(0.31, 0.2, 0.93)));
  across = cross(along, toEye);
  // Pieces of a jet draw together.
  float whole = clamp(kind.x - 1.0, 0.0, 1.0);
  if (kind.x > 0.0) path *= mix(0.6, 1.0, whole);
  // It keeps its volume.
  float wide = radius * inversesqrt(1.0 + 0.75 * path / radius), drawn = max(wide, 0.5 / pixels), halfWay = 0.5 * path * slant;
  if (whole > 0.0) halfWay += 0.5 * wide;  // and overlap
  vec2 margin = vec2(drawn, halfWay + drawn) + 1.0 / pixels, at = margin * (2.0 * vec2(float(gl_VertexID & 1), float(gl_VertexID >> 1)) - 1.0);
  vAt = at / drawn;
  vPasses = ring ? -2.0 : whole > 0.0 ? -1.0 : halfWay / (halfWay + wide);
  // Those that fly past the eye are out of focus; a jet comes out of nothing.
  float shows = way.w > 0.0 ? smoothstep(0.2, 1.0, distance) : 1.0;
  if (kind.x > 0.0) shows *= min(4.0 * (2.3 - kind.x), 1.0);
  vSize = vec4(drawn * pixels, wide / drawn * (halfWay + wide) / (halfWay + drawn), halfWay / drawn, shows * (1.0 - kind.y));
  vFrame = mat3(across, along, toEye);
  // Clinging to strands it stands out of the coat.
  gl_Position = clipFromWorld * vec4(place.xyz + across * at.x + along * at.y + toEye * radius, 1.0);
}
