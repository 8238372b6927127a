// How much light comes through the fur to a point: render/FurShadow.h draws the maps, hair/VolumeShadow.h has the
// formulas. Without SHADOW_DEPTH or SHADOW_LAYERS all of it does.

#if defined(SHADOW_DEPTH) || defined(SHADOW_LAYERS)
uniform sampler2D firstSurfaces;  // rg: depth of the first surface, 16 bits over shadowRange  ba: of the skin (layers)

#ifdef SHADOW_LAYERS
uniform mediump sampler2DArray opacities;  // 16 layers of opacity on the way so far, four to a texel
#endif

int shadowSize() { return textureSize(firstSurfaces, 0).x; }

vec4 packedDepths(ivec2 at) { return texelFetch(firstSurfaces, at, 0); }
float unpack(vec2 depth) { return dot(depth, vec2(1.0, 1.0 / 255.0)); }

#ifdef SHADOW_LAYERS
// T at that depth: sigma(z), z in layers from the texel's first surface; of 16 weights max(0, 1 - |z - i|) two
// are not 0.
float shadowTexel(ivec2 at, float depth) {
  vec4 depths = packedDepths(at);
  // A layer less deep than it lies: strands do not shade themselves, nor the skin itself.
  float z = (depth - unpack(depths.rg) * shadowRange) / shadowLayerDepth - 1.0;
  float inSkin = (depth - unpack(depths.ba) * shadowRange) / shadowLayerDepth - 1.0;
  z = clamp(z, 0.0, float(4 * FUR_SHADOW_TARGETS - 1));
  const vec4 four = vec4(0.0, 1.0, 2.0, 3.0);
  int low = int(z) / 4, high = (int(z) + 1) / 4;
  float sigma = dot(max(vec4(0.0), 1.0 - abs(four + (float(4 * low) - z))), texelFetch(opacities, ivec3(at, low), 0));
  if (high > low && high < FUR_SHADOW_TARGETS)
    sigma += dot(max(vec4(0.0), 1.0 - abs(four + (float(4 * high) - z))), texelFetch(opacities, ivec3(at, high), 0));
  // A body is dark half a fur length deep.
  return exp2(-shadowExtinction * (sigma + 0.4 * max(inSkin, 0.0)));
}

// Between four texels by hand: layers begin elsewhere in each.
float betweenTexels(vec3 at) {
  vec2 texel = clamp(at.xy * float(shadowSize()) - 0.5, 0.0, float(shadowSize()) - 1.01);
  ivec2 i = ivec2(texel);
  vec2 part = texel - vec2(i);
  vec2 left = vec2(shadowTexel(i, at.z), shadowTexel(i + ivec2(0, 1), at.z));
  vec2 right = vec2(shadowTexel(i + ivec2(1, 0), at.z), shadowTexel(i + ivec2(1, 1), at.z));
  vec2 between = mix(left, right, part.x);
  return mix(between.x, between.y, part.y);
}
#endif
#endif

// at: lightSpace() of the point (common.glsl). By depth: of so much extinction, from so far behind the first surface on.
float lightThrough(vec3 at, float extinction, float bias) {
#if defined(SHADOW_LAYERS)
  return betweenTexels(at);
#elif defined(SHADOW_DEPTH)
  // The mean that shadow_blur.frag prepared. What is packed so is a sum, which filters as its parts do.
  float first = unpack(textureLod(firstSurfaces, at.xy, 0.0).rg);
  return exp2(-extinction * max(at.z - first * shadowRange - bias, 0.0));
#else
  return 1.0;
#endif
}

// Skin looks its shadow up so far above itself. Opacity layers are thinner than a texel of the map is deep on a slope, and skin would
// shade itself in rings. Depth maps are blurred and begin further behind.
vec3 shadowOffset(vec3 normal) {
#ifdef SHADOW_LAYERS
  return normal * (1.5 * shadowRange / float(shadowSize()));
#else
  return vec3(0.0);
#endif
}

float furShadowAt(vec3 at) { return lightThrough(at, shadowExtinction, shadowBias); }
