// Evaluates functions of long hair, one a pixel, and writes the bits of what they return: how the tests hold them against their C++
// twins. Never drawn on screen.
#include "common.glsl"
#include "hair_strip.glsl"
#include "common_hair_member.glsl"
out uvec4 fragColor;

void main() {
  ivec2 at = ivec2(gl_FragCoord.xy);
#if FUNCTION < 4
  // A column a point, a row a wisp.
  float t = float(at.x) / float(FUR_WISP_SEGMENTS);
  HairNode point = wispPoint(at.y, t);
  vec3 shape = wispShape(at.y);
#if FUNCTION == 0
  vec4 value = vec4(point.position, point.wetness);
#elif FUNCTION == 1
  vec4 value = vec4(turned(point.turn, vec3(0.0, 1.0, 0.0)), shape.y);
#elif FUNCTION == 2
  vec4 value = vec4(turned(point.turn, vec3(1.0, 0.0, 0.0)), shape.z);
#else
  vec4 value = vec4(memberPoint(point, vec2(0.7, -0.4), shape.x, t), 0.0);
#endif
#elif FUNCTION == 4
  // A column a height, a row a strand of all sets.
  float t = float(at.x) / float(FUR_TWIN_SIZE - 1);
  ivec2 texel = ivec2(2 * (at.y % int(strandsDrawn)), at.y / int(strandsDrawn));
  vec4 ends = texelFetch(memberStrands, texel, 0), waves = texelFetch(memberStrands, texel + ivec2(1, 0), 0);
  vec4 value = vec4(memberOffset(ends, waves, t), memberWidth(waves.x, t), 0.0);
#else
  // A column a vertex, a row a wisp.
  StripVertex v = stripVertex(at.x, at.y, eye.xyz, 1.0);
#if FUNCTION == 5
  vec4 value = vec4(v.position, v.t);
#else
  vec4 value = vec4(v.across, v.side);
#endif
#endif
  fragColor = floatBitsToUint(value);
}
