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

// A clump's own colour; grey where it is dry. Views only.
vec3 clumpColor(vec4 clump) {
  vec2 chance = fract(clump.xy * vec2(37.3, 91.7) + clump.yx * vec2(61.1, 23.9));
  vec3 hue = clamp(abs(fract(chance.x + vec3(0.0, 2.0 / 3.0, 1.0 / 3.0)) * 6.0 - 3.0) - 1.0, 0.0, 1.0);
  return clump.a > 0.0 ? mix(hue, vec3(0.95), 0.6 * chance.y) : vec3(0.45);
}

// The clump that the atlas point `a` lies in: centre u, v, radius, wetness. Unfiltered: centres do not mix.
vec4 clumpAt(sampler2D mask, vec2 a) {
  return texelFetch(mask, clamp(ivec2(a * water.w), ivec2(0), ivec2(int(water.w) - 1)), 0);
}
