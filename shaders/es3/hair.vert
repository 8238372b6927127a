// Long hair: strips; or strands one by one. All of them are one instance: some drivers take long for each.
#include "common.glsl"
#include "common_hair.glsl"
#include "common_hair_point.glsl"
#ifdef STRIPS
#include "hair_strip.glsl"
#else
#include "common_hair_member.glsl"
#include "common_line.glsl"
#endif
#include "common_furshadow.glsl"
#include "common_shading.glsl"

invariant gl_Position;  // with hair_depth.frag as with hair.frag
out vec4 vBand;     // strands: y: pixels that it is wide; strips: xy: place in the picture, times vStrand.y
                    // z: height, 0 root to 1 tip  w: wetness
out vec4 vStrand;   // x: its random number  z: share of the light from all around
                    // y: how near to the front of its wisp, 0..1; of strips that by which vBand.xy is divided, and w: what a slope of
                    // their strands is in the model
// All that light on a strand depends on is cosines, which change little from vertex to vertex.
out vec4 vAlong;    // of its tangent: to the light, to the eye; of strips, of the unit vector across them as well
out vec4 vTurned;   // of the way that it is turned, across it and unit: to the light, to the eye, to above; w: of the light to the eye
out vec4 vLight;    // shares that come there: of the key light; of it as gloss; of it through edges; of the light behind, as its root
#ifdef STRIPS
flat out float vKind;
#endif

// How much light comes there; through hair further than through fur: a wisp is dark only where many lie before it.
float hairShadowAt(vec3 at) { return lightThrough(at - vec3(0.0, 0.0, shadowLift()), hairExtinction, hairShadowBias); }

// A strand's tangent and the light at p. Hair is turned the way of the skin that it grows from; where it stands up from it, towards
// the light.
void lightAt(vec3 p, vec3 tangent, vec3 V, int wisp) {
  vec3 L = light.xyz, way = wispNormal(wisp) + 0.35 * L + 1e-4 * V;
  way = normalize(way - tangent * dot(tangent, way));
  vAlong = vec4(dot(tangent, L), dot(tangent, V), 0.0, 0.0);
  vTurned = vec4(dot(way, L), dot(way, V), dot(way, up.xyz), dot(L, V));
  float lit = hairShadowAt(lightSpace(p));
  vLight = vec4(lit * bodyShare(vTurned.x), hairGloss * glossShare(vTurned.x), lit * rimLight(vTurned.w, vTurned.y, 1.0), rimLight(-1.0, vTurned.y, 1.0));
}

#ifdef STRIPS
#ifdef BLENDED
uniform highp sampler2D wispOrder;  // from back to front, two bytes each

int wispDrawn(int i) { return int(dot(texelFetch(wispOrder, ivec2(i, 0), 0).rg, vec2(255.0, 65280.0)) + 0.5); }
#else
int wispDrawn(int i) { return i; }
#endif

// Half the wisp's width over its length: what a slope of its strands is in the model.
float slopeScale(StripVertex v, int wisp) {
  float near = v.t < 0.5 ? v.t + 1.0 / float(FUR_WISP_SEGMENTS) : v.t - 1.0 / float(FUR_WISP_SEGMENTS);
  float reach = halfWidth(v.shape.x, v.t, v.middle.wetness);
  return reach / max(distance(wispPoint(wisp, near).position, v.middle.position) * float(FUR_WISP_SEGMENTS), 1e-4);
}
#else
// A ribbon begins and ends with a vertex twice: triangles of no area between it and the next.
void strand() {
  float segments = float(FUR_WISP_SEGMENTS) / pointStep;
  int each = 2 * int(segments) + 4, strands = int(strandsDrawn), instance = gl_VertexID / each;
  int vertex = clamp(gl_VertexID % each - 1, 0, each - 3), wisp = int(firstWisp) + instance / strands, member = instance % strands;
  vec3 shape = wispShape(wisp);
  vec4 ends = texelFetch(memberStrands, ivec2(2 * member, int(shape.z)), 0), waves = texelFetch(memberStrands, ivec2(2 * member + 1, int(shape.z)), 0);
  float t = min(float(vertex >> 1) / segments, waves.x);
  HairNode middle = wispPoint(wisp, t);
  vec2 at = memberOffset(ends, waves, t);
  vec3 p = memberPoint(middle, at, shape.x, t);
  vec3 tangent = turned(middle.turn, vec3(0.0, 1.0, 0.0));

  vec3 toEye = eye.xyz - p;
  float pixel = length(toEye) / pixelsPerUnit;
  float width = widening * strandWidth * memberWidth(waves.x, t) / pixel;
  // As wide as it is, and a pixel at least: then samples find out what it covers, each where it lies. As alpha all strands would
  // get the same samples, and hair would be seen through.
  float reach = (float(vertex & 1) - 0.5) * max(width, 1.0);
  gl_Position = clipFromModel * vec4(lineEdge(p, tangent, toEye, reach, pixel), 1.0);
  vBand = vec4(0.0, width, t, middle.wetness);
#ifndef PLAIN
  vec3 V = normalize(toEye), z = turned(middle.turn, vec3(at.x, 0.0, at.y));
  lightAt(p, tangent, V, wisp);
  vStrand = vec4(waves.w, 0.5 + 0.5 * clamp(dot(z, V), -1.0, 1.0), middle.visible, 0.0);
#endif
}
#endif

void main() {
#ifdef STRIPS
  int perStrip = 6 * int(float(FUR_WISP_SEGMENTS) / pointStep), wisp = wispDrawn(int(firstWisp) + gl_VertexID / perStrip);
  StripVertex v = stripVertex(gl_VertexID % perStrip, wisp, eye.xyz, 1.0);
  gl_Position = clipFromModel * vec4(v.position, 1.0);
  vBand = vec4(v.picture.xy, v.t, v.middle.wetness);
  vStrand.y = v.picture.z;
#ifndef PLAIN
  vec3 V = normalize(eye.xyz - v.position), across = v.across / v.picture.z;
  lightAt(v.position, turned(v.middle.turn, vec3(0.0, 1.0, 0.0)), V, wisp);
  vAlong.zw = vec2(dot(across, light.xyz), dot(across, V));
  vStrand.xzw = vec3(v.shape.y, v.middle.visible, slopeScale(v, wisp));
#endif
  vKind = v.shape.z;
#else
  strand();
#endif
}
