// A strand in its wisp. Twins: the functions of these names in hair/MemberStrands.cpp and hair/Wisps.cpp.
uniform highp sampler2D memberStrands;  // two texels a strand, a row a set: root and tip; length, phase, frizz, random number

// `ends` and `waves` are those two.
vec2 memberOffset(vec4 ends, vec4 waves, float t) {
  vec2 middle = mix(ends.xy, ends.zw, t * t * (3.0 - 2.0 * t));
  float turns = 1.2 + 1.6 * waves.y, grown = waves.z * t * (2.0 - t);
  float x = sin(6.2831853 * (turns * t + waves.y)) + 0.5 * sin(6.2831853 * (2.3 * turns * t + 3.0 * waves.y));
  float z = sin(6.2831853 * (turns * t + waves.y + 0.3));
  return clamp(middle + grown * vec2(x, z), vec2(-FUR_STRIP_REACH), vec2(FUR_STRIP_REACH));
}

float memberWidth(float len, float t) {
  float u = t / len;
  return u < 1.0 ? (1.0 - 0.3 * u) * (1.0 - u * u * u * u) : 0.0;
}

vec3 memberPoint(HairNode middle, vec2 member, float width, float t) {
  float reach = halfWidth(width, t, middle.wetness);
  return middle.position + turned(middle.turn, vec3(member.x * reach, 0.0, member.y * reach * hairDepth));
}
