// Of the technique `shells`, in fins as well: light on a strand, by the march's formulas or by the papers' as they are printed.
// C++ twins in hair/StrandShading.h and wet/Clump.h.

// f(h) rho: of the way to the clump's middle, by which Silva Eq. 1 moves the look-up.
float clumpDisplacement(float h, float rho) { return clumpProfile(h, clumpShape, layers) * rho; }

#ifdef PRINTED_LIGHT
// Silva Eq. 2, 3 and 5: occ wet (K_color max(0, L.n) + K_s I_s), with n the surface's normal. `key`: what arrives of the light
// that they know; `around`: the sky, which they do not.
vec3 printedLight(vec3 albedo, vec3 key, vec3 around, float nDotL, float cosine, float h, float rho) {
  float exponent = mix(dryShininess, shininess, rho);
  vec3 color = albedo * (key * max(nDotL, 0.0) + around) + key * (specular * kajiyaPower(cosine, exponent));
  return color * (1.0 + occlusion * (h - 1.0)) * (1.0 - wetDarkening * rho);
}
#endif

// `held`, `sheet`, `outward` and `strand`: as clumpLight() has them; `lit`: the share of the light that reaches the spot.
vec3 litStrand(vec3 albedo, vec3 T, vec3 L, vec3 V, float h, float rho, float lit, float upness, float strand, float held, float sheet, vec2 outward) {
#if defined(PRINTED_LIGHT)
  vec2 along = vec2(dot(T, L), dot(T, V)), across = sqrt(max(vec2(0.0), 1.0 - along * along));
  return printedLight(albedo, keyLight.rgb * lit, skyLight(upness), L.z, across.x * across.y - along.x * along.y, h, rho);
#else
#ifdef WET
  albedo = wetAlbedo(albedo, rho);
#endif
  vec3 color = shadeStrand(albedo, T, L, V, h, rho, lit, upness, strand);
#ifdef WET
  color = clumpLight(color, T, clumpNormal(outward, sheet), L, V, h, held, sheet, lit, upness, strand);
#endif
  return color;
#endif
}
