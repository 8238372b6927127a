// A strand as Marschner et al. (2003) have it, from tables; hair/Marschner.h tells what is in them.
uniform sampler2D strandM;
uniform sampler2D strandN;

// pi S cos theta_i. along: T.L, T.V; across: their sines.
vec3 marschnerStrand(vec3 albedo, vec2 along, vec2 across, float lightDotView, float exponent) {
  const float kM = 0.5 * (FUR_STRAND_M - 1.0) / FUR_STRAND_M;
  vec4 m = texture(strandM, along * kM + 0.5);
  vec3 lobes = m.rgb;
#ifdef WET
  // A power of a normal distribution is a narrower one: wet strands are smoother.
  float sharpen = exponent / max(dryShininessShown(), 1.0);
  lobes = pow(lobes, vec3(sharpen)) * sqrt(sharpen);
#endif
  float cosPhi = (lightDotView - along.x * along.y) * inversesqrt(max(across.x * across.x * across.y * across.y, 1e-6));
  const vec2 kSize = vec2(FUR_STRAND_N_X, FUR_STRAND_N_Y);
  vec4 n = texture(strandN, (vec2(0.5 * clamp(cosPhi, -1.0, 1.0) + 0.5, m.a) * (kSize - 1.0) + 0.5) / kSize);
  // colour^way for ways near 1 (0.8 to 1.3), without a power.
  vec3 once = sqrt(albedo);
  once *= 1.0 + (n.a - 1.0) * (once - 1.0);
  // Widths 1, 1/2, 2 of R's: heights 1, 2, 1/2. lobePeak: 1 / (beta_R sqrt(2 pi)).
  vec3 each = lobes * n.rgb * vec3(1.0, 2.0, 0.5);
  return (each.r + once * (each.g + once * each.b)) * (1.5707963 * lobePeak * across.x);
}
