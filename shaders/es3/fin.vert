// Fins: one instance an edge, collapsed unless the edge lies on the silhouette.
#include "common.glsl"
#include "common_bend.glsl"
#ifdef CLASSIC
#include "common_shading.glsl"
#include "common_clump.glsl"
#include "common_furshadow.glsl"
#include "common_classic.glsl"
#ifdef TYPES
#include "common_types.glsl"
#endif
out vec4 vAround;  // both as LightOfShell has them
out vec2 vGlint;
out float vLit;    // share of the light that the fur's shadow leaves
#endif

layout(location = FUR_FIN_POSITION_A) in vec4 positionA;
layout(location = FUR_FIN_POSITION_B) in vec4 positionB;
layout(location = FUR_FIN_NORMAL_A) in vec4 normalA;
layout(location = FUR_FIN_NORMAL_B) in vec4 normalB;
layout(location = FUR_FIN_FACE_0) in vec4 face0;
layout(location = FUR_FIN_FACE_1) in vec4 face1;
layout(location = FUR_FIN_ATLAS) in vec4 atlas;
layout(location = FUR_FIN_ROOM) in vec2 room;

out vec4 vFin;    // x: along the fin map  y: height 0..1  z: opacity  w: mip level
out vec3 vLight;  // in the fin's frame (x along the edge, z along the normal)
out vec3 vUp;     // upwards in it
out vec3 vView;   // eye in the fin's frame
out vec2 vUv;
out vec2 vLean;
out vec3 vLightSpace;
#if defined(WET) || defined(GROOMED) || defined(PAINTED)
out vec2 vAtlas;
#endif
#ifdef GROOMED
out float vLength;  // of the coat here, a share of the fur length
#endif
#ifdef WET
flat out vec2 vAtlasAlong;  // atlas step along the edge for one turn of the fin map
#endif

const vec4 kNowhere = vec4(2.0, 2.0, 2.0, 1.0);

// How much of a fin an edge on the silhouette shows (Sheppard 2.1.3): (n1.v)(n2.v) below a threshold; 0 there, 1 edge-on, so
// that nothing pops. Sheppard's 0.3 (57 degrees off) covers a third of the model with fins that the shells show better; 0.06
// (76 degrees) is where shells begin to thin out.
float silhouette(vec3 toEye) {
  float facing = dot(face0.xyz, toEye) * dot(face1.xyz, toEye);
  float opacity = smoothstep(0.0, 1.0, (FUR_SILHOUETTE - facing) / FUR_SILHOUETTE);
  // Both faces turned away: the edge lies behind the horizon.
  return opacity * smoothstep(FUR_HORIZON, FUR_HORIZON + 0.3, max(dot(face0.xyz, toEye), dot(face1.xyz, toEye)));
}

#ifdef VIEW_EDGES
// The edge as a line on the skin: a quad of the strip, the others end where it does. Of one width in any picture.
void drawEdge(float opacity, float standsIn, vec3 toEye, float away) {
  vec3 end = gl_VertexID < 2 ? positionA.xyz : positionB.xyz;
  float width = 0.0022 * away;
  vec3 along = normalize(positionB.xyz - positionA.xyz), beside = normalize(cross(along, toEye));
  end += beside * (gl_VertexID % 2 == 0 ? width : -width) + along * (gl_VertexID < 2 ? -width : width);
  vFin = vec4(opacity, standsIn, 0.0, 0.0);
  // The skin would hide half of it.
  gl_Position = opacity > 0.0 ? clipFromModel * vec4(end, 1.0) : kNowhere;
  vec4 near = clipFromModel * vec4(end + 0.03 * toEye, 1.0);
  if (opacity > 0.0) gl_Position.z = near.z / near.w * gl_Position.w;
}
#endif

// Shells cover a pixel faintly and still write depth, on a round body well before its outline: fins are compared as if a third of a length
// of the coat there nearer. By more they showed through what lies on the coat, as a mane, and through whatever is before short fur.
vec4 inFrontOfShells(vec3 p, float coat) {
  vec4 nearer = clipFromModel * vec4(p + normalize(eye.xyz - p) * (0.3 * coat), 1.0);
  vec4 clip = clipFromModel * vec4(p, 1.0);
  clip.z = nearer.z / nearer.w * clip.w;
  return clip;
}

void standFin(float opacity) {
  float side = float(gl_VertexID & 1);
#ifdef CLASSIC
  float h = float(gl_VertexID >> 1) / float(FUR_CLASSIC_FIN_SEGMENTS);
#else
  float h = mix(FUR_FIN_FOOT, 1.0, float(gl_VertexID >> 1) / float(FUR_FIN_SEGMENTS));
#endif
  vec3 root = mix(positionA.xyz, positionB.xyz, side);
  vec3 normal = normalize(mix(normalA.xyz, normalB.xyz, side));
  vec4 groomed = bendOf(int(side < 0.5 ? positionA.w : positionB.w));
  vec3 bend = groomed.xyz;
  float coat = min(furLength * groomed.w, side < 0.5 ? room.x : room.y);
  vec3 p = strandPoint(root, normal, bend, h, coat);
#ifdef CLASSIC
  gl_Position = clipFromModel * vec4(p, 1.0);
#else
  gl_Position = inFrontOfShells(p, coat);
#endif
  vLightSpace = lightSpace(p);

  vec3 edge = positionB.xyz - positionA.xyz;
  float edgeLength = length(edge);
  vec3 axis = edge / max(edgeLength, 1e-6);
  axis = normalize(axis - normal * dot(axis, normal));
  vec3 across = cross(normal, axis);
  float texels = length(eye.xyz - p) / pixelsPerUnit * tilesPerUnit * tileTexels;
  vFin = vec4(normalA.w + side * edgeLength * tilesPerUnit, h, opacity, log2(texels));
  mat3 frame = mat3(axis, across, normal);
  vLight = light.xyz * frame;
  vUp = up.xyz * frame;
  vView = (eye.xyz - p) * frame;
#ifdef CLASSIC
  vView = normalize(vView);
  vLit = furShadowAt(vLightSpace);
#ifdef TYPES
  showShares(presences(textureLod(groom, mix(atlas.xy, atlas.zw, side), 0.0).gba));
#endif
  LightOfShell lit = lightOfShell(vLight, vView, h, vLit, vUp.z);
  vAround = lit.around;
  vGlint = lit.glint;
#endif
  // Sideways part of the arc's tangent: the bend turns it by theta h.
  float theta = length(bend);
  vec3 leanNow = bend * (theta > 1e-5 ? arcTangent(theta, h).y / theta : 0.0);
  vLean = vec2(dot(axis, leanNow), dot(across, leanNow));
  vUv = vec2(face0.w, face1.w);
#ifdef GROOMED
  vLength = groomed.w;
#endif
#if defined(WET) || defined(GROOMED) || defined(PAINTED)
  vAtlas = mix(atlas.xy, atlas.zw, side);
#endif
#ifdef WET
  vAtlasAlong = (atlas.zw - atlas.xy) / max(edgeLength * tilesPerUnit, 1e-6);
#endif
}

void main() {
#ifdef CLASSIC
  standFin(normalB.w);
#else
  vec3 middle = 0.5 * (positionA.xyz + positionB.xyz);
  float away = length(eye.xyz - middle);
  vec3 toEye = (eye.xyz - middle) / away;
  float opacity = silhouette(toEye);
  // Where the surface curves evenly the shells' rays show the outline, strand by strand. Fins stand in where it is
  // hollow, sharp or ends.
  float standsIn = 1.0 - smoothstep(FUR_FIN_FLAT, FUR_FIN_ROUND, normalB.w);
#ifdef VIEW_EDGES
  drawEdge(opacity, standsIn, toEye, away);
#else
  opacity *= standsIn * smoothstep(FUR_FIN_PIXELS, 2.0 * FUR_FIN_PIXELS, furLength * pixelsPerUnit / away);
  if (opacity > 0.0) standFin(opacity);
  else gl_Position = kNowhere;
#endif
#endif
}
