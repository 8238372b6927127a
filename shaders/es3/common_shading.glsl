#include "shared/Light.h"
// Light on strands and skin, in the surface's own frame: x along s, y along t, z along the normal.

// The coat's values that each fur type has, of what is shown: mixed once, as a software rasteriser takes as long for each member of a
// block as for a dozen products.
#ifdef TYPES
vec4 typeShares;  // of the types in it
vec4 shownShade;  // density, shadow, occlusion, specular
vec3 shownGloss;  // shininess, dry shininess, variance
vec3 shownRoot, shownTip;
void showShare(int type, float share) {
  if (share > 0.0) {
    shownShade += share * vec4(typeDensity[type], typeShadow[type], typeOcclusion[type], typeSpecular[type]);
    shownGloss += share * vec3(typeShininess[type], typeDryShininess[type], typeVariance[type]);
    shownRoot += share * rootColors[type].rgb;
    shownTip += share * tipColors[type].rgb;
  }
}
void showShares(vec4 shares) {
  typeShares = shares;
  shownShade = vec4(0.0);
  shownGloss = shownRoot = shownTip = vec3(0.0);
  showShare(0, shares.x);
  showShare(1, shares.y);
  showShare(2, shares.z);
  showShare(3, shares.w);
}
float densityShown() { return shownShade.x; }
float shadowShown() { return shownShade.y; }
float occlusionShown() { return shownShade.z; }
float specularShown() { return shownShade.w; }
float shininessShown() { return shownGloss.x; }
float dryShininessShown() { return shownGloss.y; }
#else
float densityShown() { return typeDensity.x; }
float shadowShown() { return typeShadow.x; }
float occlusionShown() { return typeOcclusion.x; }
float specularShown() { return typeSpecular.x; }
float shininessShown() { return typeShininess.x; }
float dryShininessShown() { return typeDryShininess.x; }
#endif

// Linear to sRGB within 0.0015 without a power: a fit over square roots (I. Taylor 2009,
// "Simulating sRGB with sqrt").
vec3 encodeSrgb(vec3 linear) {
  vec3 c = clamp(linear, 0.0, 1.0);
  vec3 r1 = sqrt(c), r2 = sqrt(r1), r3 = sqrt(r2);
  return clamp(0.662002687 * r1 + 0.684122060 * r2 - 0.323583601 * r3 - 0.0225411470 * c, 0.0, 1.0);
}

// Filmic shoulder: straight up to 0.6, then towards 1, so that glints on wet fur keep their hue.
vec3 toneMap(vec3 linear) {
  vec3 x = linear * exposure;
  vec3 over = max(x - 0.6, 0.0);
  return min(x, 0.6) + 0.4 * over / (over + 0.4);
}

// Sheppard 2004 Eq. 3.3-3.4: F = 1 - N.L, S = clamp((4 h / d - 3 F) / F). F = 0 casts no shadow.
float furShadow(float h, float density, float nDotL) {
  float f = 1.0 - clamp(nDotL, 0.0, 1.0);
  return f < 1e-6 || density <= 0.0 ? 1.0 : clamp(4.0 * h / (density * f) - 3.0, 0.0, 1.0);
}

vec3 skyLight(float upness) { return mix(floorLight.rgb, sky.rgb, 0.5 + 0.5 * upness); }

// The model's own colour at its uv, by how much the settings ask for it; white where it has no picture.
#ifdef TEXTURED
vec3 modelColor(sampler2D picture, vec2 uv) { return mix(vec3(1.0), texture(picture, uv).rgb, textureAmount); }
#else
vec3 modelColor(sampler2D picture, vec2 uv) { return vec3(1.0); }
#endif

// sRGB to linear, a fit within 0.003 (C. Hery).
vec3 decodeSrgb(vec3 c) { return c * (c * (c * 0.305306011 + 0.682171111) + 0.012522878); }

#if defined(TEXTURED) && defined(TYPES)
uniform sampler2DArray typeColors;  // colour maps of fur types and skin

// Loops of one step, as software rasterisers look up in both branches of an if.

// A model without one has a white texel.
bool isPicture(sampler2D picture) { return textureSize(picture, 0).x > 1; }

// The mip level of a picture of that size, as textureGrad() finds it at a higher price.
float levelBy(mat2 uvs, ivec2 size) {
  vec2 x = uvs[0] * vec2(size), y = uvs[1] * vec2(size);
  return 0.5 * log2(max(max(dot(x, x), dot(y, y)), 1e-12));
}

// The colour of strands with roots at that uv, of the type with that typePicture; `uvs`: by how much it changes from pixel to pixel.
vec3 strandModelColor(sampler2D picture, float layer, vec2 uv, mat2 uvs) {
  vec3 color = vec3(1.0);
  if (layer < 0.0 && isPicture(picture)) color = textureLod(picture, uv, levelBy(uvs, textureSize(picture, 0))).rgb;
  if (layer >= 0.0) color = textureLod(typeColors, vec3(uv, layer), levelBy(uvs, textureSize(typeColors, 0).xy)).rgb;
  return mix(vec3(1.0), color, textureAmount);
}

// The colour of the skin at that uv: its own picture, as far as that is opaque, over `color`.
vec3 skinPictured(vec3 color, vec2 uv, mat2 uvs) {
  if (skinPicture >= 0.0) {
    vec4 own = textureLod(typeColors, vec3(uv, skinPicture), levelBy(uvs, textureSize(typeColors, 0).xy));
    color = mix(color, decodeSrgb(own.rgb), own.a);
  }
  return color;
}
#endif

#ifdef PAINTED
uniform sampler2D paint;  // sRGB; a: how much of it there is

// `color` under the paint at that atlas point; `shade`: what takes the paint's colour to where it is mixed with.
vec3 painted(vec3 color, vec2 at, vec3 shade) {
  vec4 over = textureLod(paint, at, 0.0);
  return mix(color, decodeSrgb(over.rgb) * shade, over.a);
}
#endif

// Colour of a strand at height h: root to tip, brighter or darker from strand to strand.
vec3 strandColor(vec3 root, vec3 tip, float variance, float h, float strandVariance, vec3 model) {
  return mix(root, tip, h) * (1.0 + variance * 1.3 * (strandVariance - 0.5)) * model;
}
#ifdef PAINTED
// The same under paint, a little darker at the root, too.
vec3 paintedStrand(vec3 albedo, vec2 at, float variance, float h, float strandVariance) {
  return painted(albedo, at, strandColor(vec3(0.65), vec3(0.95), variance, h, strandVariance, vec3(1.0)));
}
#endif


// Its two lobes: C++ twins in hair/StrandShading.h, which says more. The sines of small shifts are the shifts.
float shiftedCosine(vec4 cosines, float shift) {  // sin(T,L) sin(T,V), T.L T.V, T.L sin(T,V), T.V sin(T,L)
  return (cosines.x - cosines.y) * (1.0 - 0.5 * shift * shift) + (cosines.z + cosines.w) * shift;
}
float kajiyaLobe(float cosine, float exponent) {
  float x = max(0.0, 1.0 - exponent * (1.0 - cosine) * 0.125);
  x *= x;
  x *= x;
  return x * x;
}
// max(0, sin(T,L) sin(T,V) - (T.L)(T.V))^p (Sheppard 2004, Eq. 2.4; Silva et al. 2010, Eq. 3), L and V away from the strand.
float kajiyaPower(float cosine, float exponent) { return cosine > 0.0 ? pow(min(cosine, 1.0), exponent) : 0.0; }
vec2 lobeShifts(float strand) { return vec2(-0.14, 0.2) + 0.3 * (strand - 0.5); }

// Light from behind through the thin edge of the coat.
float rimLight(float lightDotView, float normalDotView, float h) {
  float behind = max(-lightDotView, 0.0), thin = clamp(1.0 - abs(normalDotView), 0.0, 1.0);
  behind *= behind * thin;
  return behind * behind * h;
}

// The same of the light that is always behind: of the tips along the outline alone.
vec3 fringe(float normalDotView, float h) {
  float edge = rimLight(-1.0, normalDotView, h);
  return edge * edge * backLight.rgb;
}

#ifdef MARSCHNER
#include "common_marschner.glsl"
#endif

// The body shades its own far side (object over fur).
float bodyShare(float nDotL) { return clamp(nDotL + 0.5, 0.0, 1.0); }
// The share of the light that gets to height h of the coat: `lit` gets to that spot, strands take of it (Sheppard).
float lightShare(float lit, float h, float nDotL) {
  return lit * bodyShare(nDotL) * mix(1.0, furShadow(h, densityShown(), nDotL), shadowShown());
}

// Kajiya and Kay's lobes know no surface: past the terminator of a coat they would glow where strands of the lit side
// stand in the light's way. C++ twin in hair/StrandShading.h.
float glossShare(float nDotL) { return clamp(1.6 * nDotL + 0.6, 0.0, 1.0); }

// What arrives at a strand, linear. C++ twin in hair/StrandShading.h.
struct StrandLight {
  vec3 key;      // of the key light
  vec3 through;  // of it, through the coat's edge (rimLight())
  vec3 rim;      // of the light behind what the eye sees (fringe())
  vec3 sky;      // from all around
};

// How much a strand mirrors on its scales: under a film of water, which any water makes, an eighth of what it does in air. What the film
// itself mirrors is waterGloss(). C++ twin in hair/StrandShading.h.
float whiteLobe(float rho) {
  float bare = 1.0 - min(rho, 1.0);
  bare *= bare;
  return 0.09 + 0.61 * bare * bare;
}

// Kajiya & Kay 1989 with a small Lambert term (Sheppard 5.3.1) and the factors of Silva et al. 2010:
//   C = occ wet (C_d + C_s)                                  Eq. 2
//   exponent p (1 + sigma_spec (rho - 1))                    Eq. 3: from dryShininess to shininess
//   occ = 1 + sigma_occ (h - 1), wet = 1 - sigma_wet rho     Eq. 5
// C_s: a white lobe, mirrored on the scales, and a wider one that went through the strand and has its colour;
// or Marschner's model, which has all light that goes through strands. L and V point away from the strand; of both: `along`: cosines
// to T, `normal`: to the surface's normal, `facing`: to each other.
// Silva et al. Eq. 5, by as much as strands are not white. C++ twin in hair/StrandShading.h.
vec3 strandDarkening(vec3 albedo, float rho) { return 1.0 - wetDarkening * rho * (1.0 - albedo); }
// `strand`: its random number (its variance); `shine`: its gloss by the share of it that glossShare() leaves.
vec3 shadeStrand(StrandLight lights, vec3 albedo, vec2 along, vec2 normal, float facing, float h, float rho, float strand, float exponent, float shine) {
  vec2 across = sqrt(max(vec2(0.0), 1.0 - along * along)), diffuse = mix(across, max(normal, 0.0), lambert);  // of the key light, of the fill light
#ifdef MARSCHNER
  // The setting 0.5 is the strand as it is.
  vec3 gloss = 2.0 * shine * lights.key * marschnerStrand(albedo, along, across, facing, exponent);
#elif defined(PRINTED_LOBE)
  vec3 gloss = shine * lights.key * kajiyaPower(across.x * across.y - along.x * along.y, exponent) + albedo * (1.6 * lights.through);
#else
  // A lobe's energy falls as its exponent rises; sqrt(p) keeps a strand's total about even.
  float strength = shine * sqrt(exponent / shininessShown());
  vec4 cosines = vec4(across.x * across.y, along.x * along.y, along * across.yx);
  vec2 shifts = lobeShifts(strand);
  vec3 gloss = (strength * lights.key) * (whiteLobe(rho) * kajiyaLobe(shiftedCosine(cosines, shifts.x), exponent) +
                                          albedo * kajiyaLobe(shiftedCosine(cosines, shifts.y), 0.5 * exponent));
  gloss += albedo * (1.6 * lights.through);
#endif
  gloss += (albedo + 0.3) * lights.rim;
  vec3 color = albedo * (lights.key * diffuse.x + fillLight * diffuse.y + lights.sky) + gloss;
  return color * (1.0 + occlusionShown() * (h - 1.0)) * strandDarkening(albedo, rho);
}
// Of a coat, with the exponent and gloss of its settings. `lit` is the share of the light that reaches the spot.
vec3 shadeStrand(vec3 albedo, vec3 T, vec3 L, vec3 V, float h, float rho, float lit, float upness, float strand) {
  float facing = dot(L, V), exponent = max(mix(dryShininessShown(), shininessShown(), rho), 1.0);
  StrandLight lights = StrandLight(keyLight.rgb * lightShare(lit, h, L.z), keyLight.rgb * lit * rimLight(facing, V.z, h), fringe(V.z, h), skyLight(upness));
  return shadeStrand(lights, albedo, vec2(dot(T, L), dot(T, V)), vec2(L.z, V.z), facing, h, rho, strand, exponent, specularShown() * glossShare(L.z));
}

// Wet strands: C++ twins in hair/StrandShading.h, which says more.
vec3 wetAlbedo(vec3 albedo, float rho) { return mix(albedo, albedo / mix(vec3(1.77), vec3(1.0), albedo), rho * (2.0 - rho)); }

vec3 wetCoatAlbedo(vec3 albedo, float rho) {
  vec3 ofStrand = wetAlbedo(albedo, rho);
  return ofStrand / (1.0 + 0.55 * rho * (2.0 - rho) * (1.0 - ofStrand) * ofStrand / (ofStrand + 0.08));
}

vec3 clumpNormal(vec2 outward, float sheet) {
  return normalize(vec3(outward * (1.0 - 0.85 * sheet), mix(sqrt(max(1.0 - dot(outward, outward), 0.0)), 1.0, sheet) + 0.25));
}

// Water is as smooth on blunt fur as on sleek.
const float kWaterShininess = 60.0;
// How far a sheet has closed when few of its strands glint: as far as one closes that is seen near to the eye (FUR_NEAR_SHEET).
const float kFewGlint = 0.4;
// What water mirrors, as shares: x of the light, y of the sky. Cosines as of shadeStrand(), `normal` to the clump's. C++ twin in hair/StrandShading.h,
// which says more.
vec2 waterGloss(vec2 along, vec2 normal, float facing, float nDotL, float held, float sheet, float strand, float smoothness) {
  vec2 middle = vec2(normal.x + normal.y, along.x + along.y) * inversesqrt(max(2.0 + 2.0 * facing, 1e-6));  // of L + V
  float away = 1.0 - clamp(normal.y, 0.0, 1.0), faces = max(middle.x, 0.0), slope = middle.y;
  float fresnel = away * away, film = min(held, 1.25);
  fresnel = 0.04 + 0.6 * fresnel * fresnel * away;
  float water = max(shininessShown(), kWaterShininess) * smoothness;
  // From strand to strand it lies elsewhere and is as strong as chance has it: fine lines instead of a band.
  float shifted = slope + 0.5 * (1.0 - sheet) * (strand - 0.5), own = strand * strand, few = min(sheet / kFewGlint, 1.0);
  own *= mix(1.0, own, few);
  float glint = kajiyaLobe(faces, 1.3 * water) * (1.0 - 0.7 * slope * slope) * (mix(0.3, 0.05, few) + mix(3.0, 4.0, few) * own) +
                kajiyaLobe(sqrt(max(1.0 - shifted * shifted, 0.0)), 5.0 * water) * faces * faces * (0.1 + mix(1.2, 2.1, few) * own);
  return film * film * wetGloss * vec2(smoothness * glossShare(nDotL) * glint * mix(1.0, 0.5, sheet), fresnel * mix(0.5, 0.1 + 3.0 * strand * strand, sheet));
}
vec2 waterGloss(vec3 T, vec3 n, vec3 L, vec3 V, float held, float sheet, float strand, float smoothness) {
  return waterGloss(vec2(dot(T, L), dot(T, V)), vec2(dot(n, L), dot(n, V)), dot(L, V), L.z, held, sheet, strand, smoothness);
}

// C++ twin in hair/StrandShading.h, which says more.
float clumpShade(float facing, float risen, float keyed, float h, float held, float sheet) {
  float much = min(held, 1.0), clumps = much * (1.0 - 0.75 * sheet), shaded = 1.0 - keyed;
  float turnedTo = mix(clamp(1.2 + 1.5 * risen, 0.3, 2.1), clamp(0.6 + 0.8 * facing, 0.3, 1.4), keyed);
  float around = shaded * (0.6 + 0.9 * shaded * shaded) - 0.3 * keyed;
  return mix(1.0, turnedTo, 0.7 * clumps) * mix(1.0, smoothstep(-0.2, 0.8, h), 0.3 * clumps) * (1.0 + around * much * (2.0 - much)) *
         (1.0 - 0.16 * sheet * smoothstep(0.3, 0.85, held));
}
// C++ twin in hair/StrandShading.h, which says more.
vec3 passedOn(float share, vec3 albedo) { return share / (1.0 - albedo * (1.0 - share)); }
// C++ twin in hair/StrandShading.h, which says more.
float mirroredSky(float keyed) { return 1.0 + (1.0 - keyed) * (0.6 + 1.4 * (1.0 - keyed)); }
// A strand's light `color` as that of one in a clump; and what water mirrors. `upwards`: in the surface's frame. `held`: 1 is saturated, what is
// more shines as a film.
vec3 clumpLight(vec3 color, vec3 albedo, vec3 T, vec3 n, vec3 L, vec3 V, float h, float held, float sheet, float lit, vec3 upwards, float strand, float smoothness) {
  float clumps = min(held, 1.0) * (1.0 - 0.75 * sheet), keyed = lit * glossShare(L.z), risen = dot(n, upwards);
  color *= passedOn(clumpShade(dot(n, L), risen - upwards.z, keyed, h, held, sheet), albedo);
  vec2 mirrored = waterGloss(T, n, L, V, held, sheet, strand, smoothness) * mix(1.0, h, clumps);
  color += 0.5 * min(held, 1.0) * fringe(V.z, h);
  return color + mirrored.x * lit * keyLight.rgb + mirrored.y * mirroredSky(keyed) * skyLight(2.0 * dot(n, V) * risen - dot(V, upwards));
}

// Skin without fur, darker where it is wet; `lit` is the share of the light that reaches it.
vec3 bareSkin(vec3 albedo, float nDotL, float upness, float rho, float lit) {
  return albedo * (keyLight.rgb * lit * max(nDotL, 0.0) + skyLight(upness)) * (1.0 - wetDarkening * rho);
}
// Skin seen through the fur above it, or the undergrowth up to the height h: in the shadow of the strands.
vec3 shadeSkin(vec3 albedo, float nDotL, float upness, float h, float rho, float lit) {
  float shadow = lit * mix(1.0, furShadow(h, densityShown(), nDotL), shadowShown());
  return albedo * (keyLight.rgb * max(nDotL, 0.0) * shadow + skyLight(upness)) * (1.0 + occlusionShown() * (h - 1.0)) * (1.0 - wetDarkening * rho);
}
