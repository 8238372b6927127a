// Drops: one instance each, a disc that faces the eye, longer along the way that it flies.
#include "common.glsl"

layout(location = FUR_DROP_PLACE) in vec4 place;  // world; w: radius
layout(location = FUR_DROP_WAY) in vec3 way;      // world, model units a second

out vec2 vDisc;        // -1..1 over the drop, and a pixel more
out vec2 vSize;        // x: radius across in pixels  y: the share of a pixel that one smaller than that covers
flat out float vFlies; // 0: it clings to strands
flat out mat3 vFrame;   // across, along, towards the eye; world
void main() {
  vec3 toEye = (worldFromModel * vec4(eye.xyz, 1.0)).xyz - place.xyz;
  float distance = length(toEye), speed = length(way);
  toEye /= distance;
  vec3 along = speed > 1e-4 ? way / speed : vec3(0.0, 1.0, 0.0);
  along -= toEye * dot(along, toEye);
  float slant = length(along);  // none when it comes straight at the eye
  along = slant > 1e-3 ? along / slant : normalize(cross(toEye, vec3(0.31, 0.2, 0.93)));
  vec3 across = cross(along, toEye);
  // It keeps its volume.
  float stretch = 1.0 + min(0.8 * speed, 3.0) * slant, pixels = eye.w / distance;
  vec2 size = place.w * vec2(inversesqrt(stretch), stretch), drawn = max(size, 0.5 / pixels);
  vec2 corner = 2.0 * vec2(float(gl_VertexID & 1), float(gl_VertexID >> 1)) - 1.0;
  vDisc = corner * (1.0 + 1.0 / (drawn * pixels));
  vSize = vec2(drawn.x * pixels, size.x * size.y / (drawn.x * drawn.y));
  vFlies = min(speed, 1.0);
  vFrame = mat3(across, along, toEye);
  vec2 at = vDisc * drawn;
  // Clinging to strands it stands out of the coat.
  gl_Position = clipFromWorld * vec4(place.xyz + across * at.x + along * at.y + toEye * place.w, 1.0);
}
