// Long hair (src/hair/Wisps.h): where a wisp runs, how thick it is, and where its strands are in it.
#include "shared/Hair.h"

// A node of a guide or a point of a wisp: 16 bytes a texel (render/passes/hair/HairScalp.cpp).
struct HairNode {
  vec3 position;   // model space
  float wetness;   // 0..1, in 255 steps as is the next
  float visible;   // share of the light from all around that comes there; of points alone
  vec4 turn;       // a quaternion: takes x, y, z to across, along and out of the hair
};

HairNode unpackNode(uvec4 texel) {
  vec2 xy = unpackUnorm2x16(texel.x), shares = vec2(texel.y >> 24u, texel.y >> 16u & 255u) / 255.0;
  return HairNode(nodesLow.xyz + nodesSpan.xyz * vec3(xy, unpackUnorm2x16(texel.y).x), shares.x, shares.y, vec4(unpackSnorm2x16(texel.z), unpackSnorm2x16(texel.w)));
}

uvec4 packNode(HairNode node) {
  vec3 at = clamp((node.position - nodesLow.xyz) / nodesSpan.xyz, 0.0, 1.0);
  uvec2 shares = uvec2(255.0 * clamp(vec2(node.wetness, node.visible), 0.0, 1.0) + 0.5);
  return uvec4(packUnorm2x16(at.xy), packUnorm2x16(vec2(at.z, 0.0)) | shares.x << 24u | shares.y << 16u, packSnorm2x16(node.turn.xy), packSnorm2x16(node.turn.zw));
}

vec3 turned(vec4 q, vec3 v) { return v + 2.0 * cross(q.xyz, cross(q.xyz, v) + q.w * v); }

// In the fur's shadow map hair lies nearer to the light by that much, model units: coat and skin get darker from some way behind
// the first surface on, and would be lit as in the open right under a wisp. One takes about half of the light.
float shadowLift() { return shadowLayerDepth > 0.0 ? shadowLayerDepth : shadowBias + 1.1 / shadowExtinction; }

// Half the width of a wisp whose width at the root is `width`, at height t; its depth is hairDepth of that. Water draws its strands
// together, the more the nearer the tip.
float halfWidth(float width, float t, float wetness) { return 0.5 * width * mix(1.0, tipWidth, t) * (1.0 - FUR_WET_GATHERS * wetness * t * (2.0 - t)); }

// By how much a strand's tangent leans to the way that it is turned, -0.12 to 0.12. C++ twin in hair/StrandShading.h.
float strandTilt(float strand, float h) { return 0.48 * abs(fract(strand + 3.0 * h) - 0.5) - 0.12; }
