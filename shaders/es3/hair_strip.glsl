// A wisp as a strip of triangles (Halen & Wester 2007, 5.4): six vertices a segment.
#include "common_hair.glsl"
#include "common_hair_point.glsl"

struct StripVertex {
  HairNode middle;
  vec3 position;
  vec3 across;  // from the strip's middle to its edge
  float side;   // -1 or 1
  float t;
  vec3 picture;  // xy: place in its picture, times z, so that it narrows with the strip over both of a segment's triangles alike
  vec3 shape;  // wispShape()
};

// The width of a wisp as a share of its own: far away fewer are drawn, and wider; the last of them thinner, so that none pops.
float wispShare(int wisp) { return wispWidening * clamp(10.0 - 10.0 * float(wisp) / wispsDrawn, 0.0, 1.0); }

// `eyeOrDirection`: the eye where `isPoint` is 1; where it is 0 the direction, any length, from which it is seen. A wisp has a depth
// as well: its strip lies in the cross-section along the diameter that is its outline from there, so that it never is seen edge-on.
StripVertex stripVertex(int vertex, int wisp, vec3 eyeOrDirection, float isPoint) {
  StripVertex v;
  int segment = vertex / 6 * int(pointStep), corner = vertex % 6;
  // Its two triangles share one diagonal or the other: the one that bends the plane less (Figure 5.4.4).
  uint splits = uint(texelFetch(wisps, ivec2(FUR_WISP_NORMAL, wisp), 0).w);
  bool other = (splits >> uint(segment) & 1u) != 0u;
  // Corners by height and side: 0 1 below, 2 3 above.
  const int kOne[6] = int[6](0, 1, 2, 2, 1, 3), kOther[6] = int[6](0, 1, 3, 0, 3, 2);
  int at = other ? kOther[corner] : kOne[corner];
  v.side = float(at & 1) * 2.0 - 1.0;
  v.t = float(segment + (at >> 1) * int(pointStep)) / float(FUR_WISP_SEGMENTS);
  v.shape = wispShape(wisp);
  v.shape.x *= wispShare(wisp);
  v.middle = wispPoint(wisp, v.t);
  float reach = halfWidth(v.shape.x, v.t, v.middle.wetness);
  vec3 a = turned(v.middle.turn, vec3(reach, 0.0, 0.0)), b = turned(v.middle.turn, vec3(0.0, 0.0, reach * hairDepth));
  vec3 along = turned(v.middle.turn, vec3(0.0, 1.0, 0.0));
  vec3 outline = cross(along, eyeOrDirection - isPoint * v.middle.position);
  outline *= inversesqrt(max(dot(outline, outline), 1e-12));
  float pa = dot(outline, a), pb = dot(outline, b);
  v.across = (a * pa + b * pb) * inversesqrt(max(pa * pa + pb * pb, 1e-12));
  // Without a jump where the strip turns over: its texture stays where the wisp's own left is.
  if (pa < 0.0) v.across = -v.across;
  v.position = v.middle.position + v.across * v.side * FUR_STRIP_REACH;
  float w = max(length(v.across), 1e-6);
  v.picture = vec3(vec2(0.5 + 0.5 * v.side, v.t) * w, w);
  return v;
}
