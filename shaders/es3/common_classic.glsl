// Of the technique `shells`, in fins as well: light on a strand, by the march's formulas or by the papers' as they are printed.
// C++ twins in hair/StrandShading.h and wet/Clump.h. What does not differ from strand to strand vertices work out, as Sheppard's do:
// there are as many fragments as shells.

// around: rgb: from all round, and through the coat's edge  w: the key light's share
// glint:  x: strength of dry fur's highlights  y: of the light behind, its share
struct LightOfShell {
  vec4 around;
  vec2 glint;
};
// At height h, where `lit` of the key light comes.
LightOfShell lightOfShell(vec3 L, vec3 V, float h, float lit, float upness) {
  LightOfShell light;
  light.around = vec4(skyLight(upness), lightShare(lit, h, L.z));
#ifndef MARSCHNER
  light.around.rgb += keyLight.rgb * (1.6 * lit * rimLight(dot(L, V), V.z, h));
#endif
  float edge = rimLight(-1.0, V.z, h), dry = max(dryShininessShown(), 1.0);
  light.glint = vec2(specularShown() * glossShare(L.z) * sqrt(dry / shininessShown()), edge * edge);
  return light;
}

// f(h) rho: of the way to the clump's middle, by which Silva Eq. 1 moves the look-up.
float clumpDisplacement(float h, float rho) { return clumpProfile(h) * rho; }

#ifdef PRINTED_LIGHT
// Silva Eq. 2, 3 and 5: occ wet (K_color max(0, L.n) + K_s I_s), with n the surface's normal. `key`: what arrives of the light
// that they know; `around`: the sky, which they do not.
vec3 printedLight(vec3 albedo, vec3 key, vec3 around, float nDotL, float cosine, float h, float rho) {
  float exponent = mix(dryShininessShown(), shininessShown(), rho);
  vec3 color = albedo * (key * max(nDotL, 0.0) + around) + key * (specularShown() * kajiyaPower(cosine, exponent));
  return color * (1.0 + occlusionShown() * (h - 1.0)) * (1.0 - wetDarkening * rho);
}
#endif

#if !defined(WET) && !defined(MARSCHNER) && !defined(PRINTED_LOBE) && !defined(PRINTED_LIGHT)
#define DRY_LIGHT 1
#endif
#if defined(DRY_LIGHT) || defined(FUNCTION)
// shadeStrand() for dry fur, with less to do for each strand.
vec3 dryLight(LightOfShell light, vec3 albedo, vec2 along, vec2 normal, float h, float strand) {
  vec2 across = sqrt(max(vec2(0.0), 1.0 - along * along)), diffuse = mix(across, max(normal, 0.0), lambert), shifts = lobeShifts(strand);
  vec2 cosines = (across.x * across.y - along.x * along.y) * (1.0 - 0.5 * shifts * shifts) + (along.x * across.y + along.y * across.x) * shifts;
  vec2 lobes = max(vec2(0.0), 1.0 - vec2(0.125, 0.0625) * max(dryShininessShown(), 1.0) * (1.0 - cosines));
  lobes *= lobes;
  lobes *= lobes;
  lobes *= lobes * light.glint.x;
  vec3 key = keyLight.rgb * light.around.w, rim = backLight.rgb * light.glint.y;
  vec3 color = albedo * (key * (diffuse.x + lobes.y) + light.around.rgb + rim + fillLight * diffuse.y) + key * (0.7 * lobes.x) + 0.3 * rim;
  return color * (1.0 + occlusionShown() * (h - 1.0));
}
#endif

// `upwards`, `held`, `sheet`, `outward` and `strand`: as clumpLight() has them.
vec3 litStrand(LightOfShell light, vec3 albedo, vec3 T, vec3 L, vec3 V, vec3 upwards, float h, float lit, float strand, float held, float sheet, vec2 outward) {
  vec2 along = vec2(dot(T, L), dot(T, V)), normal = vec2(L.z, V.z);
#ifdef DRY_LIGHT
  return dryLight(light, albedo, along, normal, h, strand);
#else
  float rho = min(held, 1.0);
#ifdef PRINTED_LIGHT
  vec2 across = sqrt(max(vec2(0.0), 1.0 - along * along));
  return printedLight(albedo, keyLight.rgb * lit, skyLight(upwards.z), L.z, across.x * across.y - along.x * along.y, h, rho);
#else
#ifdef WET
  albedo = wetCoatAlbedo(albedo, rho);
#endif
  StrandLight lights = StrandLight(keyLight.rgb * light.around.w, vec3(0.0), backLight.rgb * light.glint.y, light.around.rgb);
  float exponent = max(mix(dryShininessShown(), shininessShown(), rho), 1.0);
  vec3 color = shadeStrand(lights, albedo, along, normal, dot(L, V), h, rho, strand, exponent, specularShown() * glossShare(L.z));
#ifdef WET
  color = clumpLight(color, albedo, T, clumpNormal(outward, sheet), L, V, h, held, sheet, lit, upwards, strand, 1.0);
#endif
  return color;
#endif
#endif
}
