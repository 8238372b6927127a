// Wet clumps (Silva et al. 2010, Eq. 1 and Algorithm 2), the inverse taken exactly. C++ twin: wet/Clump.h.

// ln x for x > 0 within 1e-5. GPUs may be a thousandth off in log(), and a clump magnifies that tenfold.
float naturalLog(float x) {
  int bits = floatBitsToInt(x);
  float mantissa = intBitsToFloat((bits & 0x7fffff) | 0x3f800000);
  float z = (mantissa - 1.0) / (mantissa + 1.0), y = z * z;
  return float((bits >> 23) - 127) * 0.69314718 +
         2.0 * z * (1.0 + y * (1.0 / 3.0 + y * (1.0 / 5.0 + y * (1.0 / 7.0 + y * (1.0 / 9.0)))));
}

// f(h) = (1 - w) h + w (1 + ln h / ln N), h in [1/N, 1].
float clumpProfile(float h, float w, float layers) {
  return (1.0 - w) * h + w * (1.0 + naturalLog(max(h, 1.0 / layers)) / naturalLog(layers));
}

// s: the share of the way to the clump's centre that a strand of a clump of wetness rho has gone at height h.
float clumpPull(float h, float rho) { return min(clumpProfile(h, water.x, shape.z) * rho, FUR_MAX_SHIFT); }

// The clump that the atlas point `a` lies in: centre u, v, radius, wetness. Unfiltered: centres do not mix.
vec4 clumpAt(sampler2D mask, vec2 a) {
  return texelFetch(mask, clamp(ivec2(a * water.w), ivec2(0), ivec2(int(water.w) - 1)), 0);
}
