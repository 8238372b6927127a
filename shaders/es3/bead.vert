// Beads of water on strands and whiskers that are a little wet: one point each, with a hair as whiskers are, of which it hangs near the tip.
// Drawn as a drop that clings (drop.frag).
#include "common.glsl"
#include "common_bend.glsl"
#include "common_clump.glsl"
uniform sampler2D mask;

layout(location = FUR_WHISKER_ROOT) in vec4 rootWidth;
layout(location = FUR_WHISKER_DIRECTION) in vec4 directionLength;  // length 0: as long as the coat is there
layout(location = FUR_WHISKER_CURVE) in vec4 curveGive;
layout(location = FUR_WHISKER_NORMAL) in vec4 normalShade;
layout(location = FUR_WHISKER_COLOR) in vec4 colorU;
layout(location = FUR_WHISKER_VERTICES) in vec4 verticesV;
layout(location = FUR_WHISKER_WEIGHTS) in vec3 weights;

// As drop.vert has them.
flat out float vReach;
flat out vec4 vSize;
flat out mat3 vFrame;
flat out float vPasses;

// Of the largest, model units; and as a share of the length of fur: those on short fur are as fine as its strands.
const float kRadius = 0.0036, kRadiusOfCoat = 0.045;

// The share of its height at which wet fur ends that is so far `aside`.
float standsTo(float held, float shortness, float aside) {
  float sheet = sheetOf(held, shortness);
  return wetTop(upright(held, sheet), aside, wetLean(vec2(aside, 0.0), held, sheet).x, sheet);
}

void main() {
  float chance = normalShade.w, other = fract(chance * 61.0), held = max(clumpAt(mask, vec2(colorU.w, verticesV.w)).a, 0.0);
  vec4 coatHere = bendOf(int(verticesV.x)) * weights.x + bendOf(int(verticesV.y)) * weights.y + bendOf(int(verticesV.z)) * weights.z;
  float coat = furLength * coatHere.w, radius = beadSize(held, chance) * mix(0.5, 1.0, other);
  bool ofCoat = directionLength.w == 0.0;
  radius *= ofCoat ? min(kRadius, kRadiusOfCoat * coat) : kRadius;
  vReach = 0.0;
  gl_PointSize = 1.0;
  vSize = vec4(0.0);
  vFrame = mat3(1.0);
  vPasses = 0.0;
  gl_Position = vec4(2.0, 2.0, 2.0, 1.0);
  if (radius <= 0.0) return;
  vec3 direction = directionLength.xyz;
  vec3 bend = curveGive.xyz + curveGive.w * (coatHere.xyz - direction * dot(direction, coatHere.xyz));
  float along = ofCoat ? mix(0.8, 1.0, fract(other * 7.0)) : mix(0.35, 0.95, other), len = ofCoat ? coat * standsTo(held, shortnessOf(coat), arcBend(length(bend), 1.0).y) : directionLength.w;
  along *= 1.0 - 0.7 * beadRun(held, chance);
  vec3 p = strandPoint(rootWidth.xyz, direction, bend, along, len), toEye = eye.xyz - p;
  float distance = length(toEye), pixels = pixelsPerUnit / distance;
  toEye /= distance;
  vFrame[2] = mat3(worldFromModel) * toEye;
  // As the point lies in the picture: across is level.
  vFrame[0] = normalize(cross(vec3(0.0, 1.0, 0.0), vFrame[2]));
  vFrame[1] = cross(vFrame[2], vFrame[0]);
  float drawn = max(radius, 0.5 / pixels);
  vReach = 1.0 + 1.0 / (drawn * pixels);
  gl_PointSize = 2.0 * vReach * drawn * pixels;
  // It shows the fur round it where no light makes it bright; far off beads are a sparkle.
  float bright = mix(0.25, 0.9, clamp(dot(normalShade.xyz, light.xyz) + 0.4, 0.0, 1.0));
  vSize = vec4(drawn * pixels, radius * radius / (drawn * drawn), 0.0, bright * smoothstep(0.1, 0.8, radius * pixels));
  // It stands before its strand, and shells have the depth of the coat's outside.
  vec3 nearer = p + toEye * (radius + (ofCoat ? 0.3 : 0.0) * coat);
  gl_Position = clipFromModel * vec4(p, 1.0);
  vec4 clip = clipFromModel * vec4(nearer, 1.0);
  gl_Position.z = clip.z / clip.w * gl_Position.w;
}
