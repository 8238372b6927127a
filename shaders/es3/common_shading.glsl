// Light on strands and skin, in the surface's own frame: x along s, y along t, z along the normal.

// Linear to sRGB within 0.0015 without a power: a fit over square roots (I. Taylor 2009,
// "Simulating sRGB with sqrt").
vec3 encodeSrgb(vec3 linear) {
  vec3 c = clamp(linear, 0.0, 1.0);
  vec3 r1 = sqrt(c), r2 = sqrt(r1), r3 = sqrt(r2);
  return clamp(0.662002687 * r1 + 0.684122060 * r2 - 0.323583601 * r3 - 0.0225411470 * c, 0.0, 1.0);
}

// Filmic shoulder: straight up to 0.6, then towards 1, so that glints on wet fur keep their hue.
vec3 toneMap(vec3 linear) {
  vec3 x = linear * up.w;
  vec3 over = max(x - 0.6, 0.0);
  return min(x, 0.6) + 0.4 * over / (over + 0.4);
}

// Sheppard 2004 Eq. 3.3-3.4: F = 1 - N.L, S = clamp((4 h / d - 3 F) / F). F = 0 casts no shadow.
float furShadow(float h, float density, float nDotL) {
  float f = 1.0 - clamp(nDotL, 0.0, 1.0);
  return f < 1e-6 || density <= 0.0 ? 1.0 : clamp((4.0 * h / density - 3.0 * f) / f, 0.0, 1.0);
}

vec3 skyLight(float upness) { return mix(floorLight.rgb, sky.rgb, 0.5 + 0.5 * upness); }

// The model's own colour at its uv, by how much the settings ask for it; white where it has no picture.
#ifdef TEXTURED
vec3 modelColor(sampler2D picture, vec2 uv) { return mix(vec3(1.0), texture(picture, uv).rgb, coat.z); }
#else
vec3 modelColor(sampler2D picture, vec2 uv) { return vec3(1.0); }
#endif

// Colour of a strand at height h: root to tip, brighter or darker from strand to strand.
vec3 strandColor(float h, float strandVariance, vec3 model) {
  vec3 color = mix(rootColor.rgb, tipColor.rgb, h);
  return color * (1.0 + coat.y * 1.3 * (strandVariance - 0.5)) * model;
}

// sin(T, L), and the highlight on the cone T.V = -T.L (Sheppard Eq. 2.4), Kajiya & Kay 1989.
float kajiyaDiffuse(vec3 T, vec3 L) {
  float tl = dot(T, L);
  return sqrt(max(0.0, 1.0 - tl * tl));
}
float kajiyaSpecular(vec3 T, vec3 L, vec3 V, float exponent) {
  return pow(max(0.0, kajiyaDiffuse(T, L) * kajiyaDiffuse(T, V) - dot(T, L) * dot(T, V)), exponent);
}

// Kajiya & Kay 1989 with a small Lambert term (Sheppard 5.3.1) and the factors of Silva et al. 2010:
//   C = occ wet (C_d + C_s)                                  Eq. 2
//   exponent p (1 + sigma_spec (rho - 1))                    Eq. 3
//   occ = 1 + sigma_occ (h - 1), wet = 1 - sigma_wet rho     Eq. 5
// L and V point away from the strand. `lit` is the share of the light that reaches the spot.
vec3 shadeStrand(vec3 albedo, vec3 T, vec3 L, vec3 V, float h, float rho, float lit, float upness) {
  float exponent = max(shading.z * (1.0 + water.z * (rho - 1.0)), 1.0);
  // The lobe's energy falls as its exponent rises; sqrt(p) keeps a strand's total about even.
  float gloss = shading.y * sqrt(exponent / shading.z) * kajiyaSpecular(T, L, V, exponent);
  // The body shades its own far side: object over fur, clamp(N.L + 0.5).
  float body = clamp(L.z + 0.5, 0.0, 1.0);
  float key = light.w * lit * body * mix(1.0, furShadow(h, volume.z, L.z), shading.w);
  float diffuse = mix(kajiyaDiffuse(T, L), max(L.z, 0.0), shading.x);
  vec3 glossColor = mix(vec3(1.0), albedo, 0.6 * (1.0 - rho));
  vec3 color = albedo * (key * diffuse + skyLight(upness)) + glossColor * (key * gloss);
  return color * (1.0 + coat.x * (h - 1.0)) * (1.0 - water.y * rho);
}

// Fur is read from one mip level, picked per pixel by chance between the two that trilinear filtering
// would blend (Jimenez 2014, interleaved gradient noise): fur hides the grain, and a software
// rasteriser draws the frame in half the time.
float pickLevel(float lod) {
  float noise = fract(52.9829189 * fract(dot(gl_FragCoord.xy, vec2(0.06711056, 0.00583715))));
  return floor(max(lod, 0.0) + noise);
}
