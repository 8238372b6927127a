// The light that comes to long hair.
#include "common_furshadow.glsl"

// How much of it comes through the fur, through hair further than through fur: a wisp is dark only where many lie before it.
float hairShadowAt(vec3 at) {
#if defined(SHADOW_LAYERS)
  return betweenTexels(at);
#elif defined(SHADOW_DEPTH)
  float first = unpack(textureLod(firstSurfaces, at.xy, 0.0).rg);
  return exp2(-hairExtinction * max(at.z - first * shadowRange - hairShadowBias, 0.0));
#else
  return 1.0;
#endif
}
