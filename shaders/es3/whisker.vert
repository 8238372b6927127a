// Whiskers: one instance a hair, bent as the coat round its root is (twin: hairPoints() in groom/Whiskers.h).
#include "common.glsl"
#include "common_bend.glsl"
#include "common_line.glsl"
#ifdef WET
#include "common_clump.glsl"
uniform sampler2D mask;
#endif

layout(location = FUR_WHISKER_ROOT) in vec4 rootWidth;
layout(location = FUR_WHISKER_DIRECTION) in vec4 directionLength;
layout(location = FUR_WHISKER_CURVE) in vec4 curveGive;
layout(location = FUR_WHISKER_NORMAL) in vec4 normalShade;
layout(location = FUR_WHISKER_COLOR) in vec4 colorU;
layout(location = FUR_WHISKER_VERTICES) in vec4 verticesV;
layout(location = FUR_WHISKER_WEIGHTS) in vec3 weights;

out vec4 vBand;     // x: pixels from the middle line  y: pixels that it is wide  z: share of it above the coat  w: wetness
out vec4 vTangent;  // w: its random number
out vec4 vView;     // to the eye  w: share of the light that the body leaves to it
out vec3 vColor;
out vec3 vLightSpace;

void main() {
  float t = float(gl_VertexID >> 1) / float(FUR_WHISKER_POINTS - 1);
  vec3 direction = directionLength.xyz, normal = normalShade.xyz;
  vec4 coatHere = bendOf(int(verticesV.x)) * weights.x + bendOf(int(verticesV.y)) * weights.y + bendOf(int(verticesV.z)) * weights.z;
  vec3 bend = curveGive.xyz + curveGive.w * (coatHere.xyz - direction * dot(direction, coatHere.xyz));
  float theta = length(bend);
  vec3 p = strandPoint(rootWidth.xyz, direction, bend, t, directionLength.w);
  vec2 slope = arcTangent(theta, t);
  vec3 tangent = direction * slope.x + bend * (theta > 1e-5 ? slope.y / theta : 0.0);

  vec3 toEye = eye.xyz - p;
  float pixel = length(toEye) / pixelsPerUnit;
  float width = rootWidth.w * (1.0 - t) / pixel;
  float reach = lineReach(gl_VertexID, width);
  vec3 edge = lineEdge(p, tangent, toEye, reach, pixel);
  // Shells have the depth of the coat's outside and not of the strands that are seen: as much nearer, it comes out from
  // among those.
  float depth = furLength * coatHere.w;
  vec4 nearer = clipFromModel * vec4(edge + toEye * min(0.6 * depth / length(toEye), 0.5), 1.0);
  vec4 clip = clipFromModel * vec4(edge, 1.0);
  clip.z = nearer.z / nearer.w * clip.w;
  gl_Position = clip;
  vLightSpace = lightSpace(p);

  // One that leaves the skin flatly comes out further on, where a round body falls away below it.
  float above = max(dot(p - rootWidth.xyz, normal), 0.4 * t * directionLength.w) / max(depth, 1e-4);
  vBand = vec4(reach, width, above, 0.0);
#ifdef WET
  vBand.w = clamp(clumpAt(mask, vec2(colorU.w, verticesV.w)).a, 0.0, 1.0);
#endif
  vTangent = vec4(tangent, normalShade.w);
  vView = vec4(toEye, mix(clamp(dot(normal, light.xyz) + 0.5, 0.0, 1.0), 1.0, t));
  vColor = colorU.rgb;
}
