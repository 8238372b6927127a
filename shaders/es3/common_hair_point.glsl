// A point of a wisp, from the texture that hair_points.frag has filled.
uniform highp usampler2D hairPoints;
uniform highp sampler2D wisps;  // FUR_WISP_TEXELS a row, see render/passes/hair/HairScalp.cpp

// x: width at the root  y: its random number  z: which set of member strands
vec3 wispShape(int wisp) {
  float width = texelFetch(wisps, ivec2(FUR_WISP_OFFSET, wisp), 0).w, chance = texelFetch(wisps, ivec2(FUR_WISP_GUIDES, wisp), 0).w;
  return vec3(width, chance, min(floor(chance * float(FUR_WISP_KINDS)), float(FUR_WISP_KINDS - 1)));
}
vec3 wispNormal(int wisp) { return texelFetch(wisps, ivec2(FUR_WISP_NORMAL, wisp), 0).xyz; }

HairNode wispPoint(int wisp, float t) {
  float at = t * float(FUR_WISP_SEGMENTS), part = fract(at);
  HairNode here = unpackNode(texelFetch(hairPoints, ivec2(int(at), wisp), 0));
  if (part > 0.0) {
    HairNode next = unpackNode(texelFetch(hairPoints, ivec2(int(at) + 1, wisp), 0));
    if (dot(here.turn, next.turn) < 0.0) next.turn = -next.turn;
    here = HairNode(mix(here.position, next.position, part), mix(here.wetness, next.wetness, part), mix(here.visible, next.visible, part), mix(here.turn, next.turn, part));
  }
  here.turn = normalize(here.turn);
  return here;
}
