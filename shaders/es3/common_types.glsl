// Where the fur types grow. Sheppard 2004, 3.3.2, with the presence e = 1 where a type is alone; C++ twin:
// furgen/Strand.h.

// r: length of the fur, a share; g, b, a: presence of the types 2 to 4. Of coats of one type a: the chart's number, see
// groom::withCharts().
uniform sampler2D groom;

// Shorter fur is none.
const float kBald = 0.004;

vec4 presences(vec3 others) { return vec4(max(1.0 - others.x - others.y - others.z, 0.0), others); }

// How much of a coat stands where the map has that texel: short or sparse fur lets the skin be seen.
float coatShare(vec4 texel) {
  float share = min(texel.r / 0.15, 1.0);
#ifdef TYPES
  share *= min(2.0 * dot(presences(texel.gba), typeGrows), 1.0);
#endif
  return share;
}

#ifdef TYPES
vec4 only(int type) { return vec4(equal(ivec4(type), ivec4(0, 1, 2, 3))); }
// Written out: a loop over types costs as much as a look-up on a software rasteriser.
vec3 skinColorOf(vec4 presences) {
  return presences.x * skinColors[0].rgb + presences.y * skinColors[1].rgb + presences.z * skinColors[2].rgb + presences.w * skinColors[3].rgb;
}
#endif

// Up to which height a strand stands; its dominance is 0.5..1.
float standsUpTo(float presence, float dominance) { return max(2.0 - 2.0 * (1.0 - presence) / dominance, 0.0); }
