// Long hair: strips, an instance a wisp; or strands one by one, an instance a strand.
#include "common.glsl"
#include "common_hair.glsl"
#include "common_hair_point.glsl"
#ifdef STRIPS
#include "hair_strip.glsl"
#else
#include "common_hair_member.glsl"
#include "common_line.glsl"
#endif

out vec4 vBand;     // strands: y: pixels that it is wide; strips: xy: place in the picture, times w
                    // z: height, 0 root to 1 tip  w: wetness
out vec4 vTangent;  // model space; w: its random number
out vec4 vView;     // to the eye; w: strips: that by which vBand.xy is divided; strands: how near to the front of its wisp, 0..1
out vec4 vNormal;   // of the skin at its root; w: share of the light from all around
out vec3 vLightSpace;
#ifdef STRIPS
out vec4 vAcross;   // unit; w: what a slope of its strands is in the model
flat out float vKind;
#endif

#ifdef STRIPS
// Half the wisp's width over its length: what a slope of its strands is in the model.
float slopeScale(StripVertex v, int wisp) {
  float near = v.t < 0.5 ? v.t + 1.0 / float(FUR_WISP_SEGMENTS) : v.t - 1.0 / float(FUR_WISP_SEGMENTS);
  float reach = halfWidth(v.shape.x, v.t, v.middle.wetness);
  return reach / max(distance(wispPoint(wisp, near).position, v.middle.position) * float(FUR_WISP_SEGMENTS), 1e-4);
}
#else
void strand(int instance) {
  int strands = int(strandsDrawn), wisp = int(firstWisp) + instance / strands, member = instance % strands;
  vec3 shape = wispShape(wisp);
  vec4 ends = texelFetch(memberStrands, ivec2(2 * member, int(shape.z)), 0), waves = texelFetch(memberStrands, ivec2(2 * member + 1, int(shape.z)), 0);
  float segments = float(FUR_WISP_SEGMENTS) / pointStep;
  float t = min(float(gl_VertexID >> 1) / segments, waves.x);
  HairNode middle = wispPoint(wisp, t);
  vec2 at = memberOffset(ends, waves, t);
  vec3 p = memberPoint(middle, at, shape.x, t);
  vec3 tangent = turned(middle.turn, vec3(0.0, 1.0, 0.0));

  vec3 toEye = eye.xyz - p;
  float pixel = length(toEye) / pixelsPerUnit;
  float width = widening * strandWidth * memberWidth(waves.x, t) / pixel;
  // As wide as it is, and a pixel at least: then samples find out what it covers, each where it lies. As alpha all strands would
  // get the same samples, and hair would be seen through.
  float reach = (float(gl_VertexID & 1) - 0.5) * max(width, 1.0);
  gl_Position = clipFromModel * vec4(lineEdge(p, tangent, toEye, reach, pixel), 1.0);
  vBand = vec4(0.0, width, t, middle.wetness);
  vTangent = vec4(tangent, waves.w);
  vec3 outward = normalize(toEye);
  vec3 z = turned(middle.turn, vec3(at.x, 0.0, at.y));
  vView = vec4(toEye, 0.5 + 0.5 * clamp(dot(z, outward), -1.0, 1.0));
  vNormal = vec4(wispNormal(wisp), middle.visible);
  vLightSpace = lightSpace(p);
}
#endif

void main() {
#ifdef STRIPS
  int wisp = int(firstWisp) + gl_InstanceID;
  StripVertex v = stripVertex(gl_VertexID, wisp, eye.xyz, 1.0);
  gl_Position = clipFromModel * vec4(v.position, 1.0);
  vBand = vec4(v.picture.xy, v.t, v.middle.wetness);
  vTangent = vec4(turned(v.middle.turn, vec3(0.0, 1.0, 0.0)), v.shape.y);
  vView = vec4(eye.xyz - v.position, v.picture.z);
  vNormal = vec4(wispNormal(wisp), v.middle.visible);
  vLightSpace = lightSpace(v.position);
  vAcross = vec4(v.across / v.picture.z, slopeScale(v, wisp));
  vKind = v.shape.z;
#else
  strand(gl_InstanceID);
#endif
}
