// Numbers of the light in the coat that shaders and the reference (src/truth) share: valid as GLSL ES 3.00 and as C++.
#ifdef __cplusplus
#pragma once
#endif

// How dark the shadow of one strand is, at the setting's 1.
#define FUR_SHADE_OF_ONE 0.65
// A strand is shaded by those so far above it, a share of the fur length.
#define FUR_SHADE_RISE 0.1
// Below this cosine the way of the light through the coat grows no longer.
#define FUR_LOWEST_LIGHT 0.35
