// Wet clumps (Silva et al. 2010, Eq. 1 and Algorithm 2), the inverse taken exactly. C++ twin: wet/Clump.h.

// f(h) = (1 - w) h + w (1 + ln h / ln N), h in [1/N, 1].
float clumpProfile(float h, float w, float layers) {
  return (1.0 - w) * h + w * (1.0 + log(max(h, 1.0 / layers)) / log(layers));
}

// The clump that the atlas point `a` lies in: centre u, v, radius, wetness. Unfiltered: centres do not mix.
vec4 clumpAt(sampler2D mask, vec2 a) {
  return texelFetch(mask, clamp(ivec2(a * water.w), ivec2(0), ivec2(int(water.w) - 1)), 0);
}
