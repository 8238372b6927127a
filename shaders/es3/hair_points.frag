// Brings the points of all wisps up to date (Halen & Wester 2007, 5.5): a column a point from root to tip, a row a wisp.
#include "common.glsl"
#include "common_hair.glsl"
uniform highp usampler2D hairNodes;  // a column a node, a row a guide
uniform highp sampler2D wisps;
uniform mediump sampler2D ambient;  // hair/AmbientOcclusion.h
out uvec4 fragColor;

vec4 wispTexel(int at) { return texelFetch(wisps, ivec2(at, int(gl_FragCoord.y)), 0); }

HairNode nodeOf(float guide, int node) { return unpackNode(texelFetch(hairNodes, ivec2(node, int(guide)), 0)); }

// Twins of all below: the functions of these names in hair/Wisps.cpp.
struct GuidePoint {
  vec3 position, way;  // way: what one node more adds to it
  vec4 turn;
  float wetness;
};

GuidePoint guidePoint(float guide, float node) {
  float first = clamp(floor(node), 0.0, guideNodes - 2.0), f = node - first;
  HairNode a = nodeOf(guide, int(first)), b = nodeOf(guide, int(first) + 1);
  if (dot(a.turn, b.turn) < 0.0) b.turn = -b.turn;
  vec3 way = b.position - a.position;
  float len = length(way);
  vec3 from = turned(a.turn, vec3(0.0, len, 0.0)), to = turned(b.turn, vec3(0.0, len, 0.0));
  GuidePoint p = GuidePoint(a.position + way * f, mix(from, to, f), mix(a.turn, b.turn, f), mix(a.wetness, b.wetness, f));
  if (cubicGuides > 0.0) {
    p.position = a.position + way * (f * f * (3.0 - 2.0 * f)) + (f * (1.0 - f)) * (from * (1.0 - f) - to * f);
    p.way = way * (6.0 * f * (1.0 - f)) + from * ((1.0 - f) * (1.0 - 3.0 * f)) + to * (f * (3.0 * f - 2.0));
  }
  return p;
}

// The shares of three guides where hair is wet: its nearest guide takes most of it.
vec3 drawnWeights(vec3 weights) {
  vec3 squares = max(weights, 0.0) * max(weights, 0.0);
  return squares * squares / dot(squares, squares);
}

vec4 blendFrames(vec4 a, vec4 b, vec4 c, vec3 weights) {
  return normalize(a * weights.x + b * (dot(a, b) < 0.0 ? -weights.y : weights.y) + c * (dot(a, c) < 0.0 ? -weights.z : weights.z));
}

// The quaternion that takes x, y, z there; unit vectors, perpendicular.
vec4 quaternionOf(vec3 x, vec3 y, vec3 z) {
  float trace = x.x + y.y + z.z;
  vec4 q;
  if (trace > 0.0) q = vec4(y.z - z.y, z.x - x.z, x.y - y.x, 1.0 + trace);
  else if (x.x > y.y && x.x > z.z) q = vec4(1.0 + x.x - y.y - z.z, y.x + x.y, z.x + x.z, y.z - z.y);
  else if (y.y > z.z) q = vec4(y.x + x.y, 1.0 - x.x + y.y - z.z, z.y + y.z, z.x - x.z);
  else q = vec4(z.x + x.z, z.y + y.z, 1.0 - x.x - y.y + z.z, x.y - y.x);
  return normalize(q);
}

HairNode wispPoint(float t) {
  const float kCurlGrown = 0.4;
  vec4 offsetWidth = wispTexel(FUR_WISP_OFFSET), weightsLength = wispTexel(FUR_WISP_WEIGHTS);
  vec4 magnetRotation = wispTexel(FUR_WISP_MAGNET), guides = wispTexel(FUR_WISP_GUIDES);
  float perHeight = weightsLength.w * (guideNodes - 1.0), width = offsetWidth.w;
  vec3 dry = weightsLength.xyz + magnetRotation.xyz * t, position = vec3(0.0), way = vec3(0.0);
  GuidePoint points[3];
  vec4 roots[3];
  float wetness = 0.0;
  for (int k = 0; k < 3; ++k) {
    points[k] = guidePoint(guides[k], perHeight * t);
    roots[k] = nodeOf(guides[k], 0).turn;
    wetness += points[k].wetness * dry[k];
  }
  vec3 drawn = drawnWeights(dry) - dry, weights = dry + drawn * (FUR_WET_DRAWS * wetness * t * (2.0 - t));
  vec3 changes = magnetRotation.xyz + drawn * (FUR_WET_DRAWS * wetness * (2.0 - 2.0 * t));
  for (int k = 0; k < 3; ++k) {
    position += points[k].position * weights[k];
    way += points[k].way * (weights[k] * perHeight) + points[k].position * changes[k];
  }
  vec4 turn = blendFrames(points[0].turn, points[1].turn, points[2].turn, weights);
  float cosine = cos(magnetRotation.w), sine = sin(magnetRotation.w);
  vec3 x = turned(turn, vec3(cosine, 0.0, sine)), z = turned(turn, vec3(-sine, 0.0, cosine));

  float u = clamp(t / kCurlGrown, 0.0, 1.0), radius = curl * u * u * (3.0 - 2.0 * u), grows = curl * 6.0 * u * (1.0 - u) / kCurlGrown;
  float rate = 6.2831853 * curls, angle = rate * t + 6.2831853 * guides.w;
  vec2 circle = vec2(cos(angle), sin(angle)), moves = grows * circle + radius * rate * vec2(-circle.y, circle.x);
  position += turned(blendFrames(roots[0], roots[1], roots[2], weightsLength.xyz), offsetWidth.xyz) +
              width * radius * (x * circle.x + z * circle.y);
  way += width * (x * moves.x + z * moves.y);

  float squared = dot(way, way);
  vec3 along = squared > 1e-24 ? way * inversesqrt(squared) : turned(turn, vec3(0.0, 1.0, 0.0));
  vec3 across = x - along * dot(x, along);
  squared = dot(across, across);
  across = squared > 1e-24 ? across * inversesqrt(squared) : z;
  return HairNode(position, wetness, texelFetch(ambient, ivec2(gl_FragCoord), 0).r, quaternionOf(across, along, cross(across, along)));
}

void main() { fragColor = packNode(wispPoint((gl_FragCoord.x - 0.5) / float(FUR_WISP_SEGMENTS))); }
