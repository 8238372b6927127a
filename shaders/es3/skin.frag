// The skin: bare in full light, or what is left to see of it behind fur.
#include "common.glsl"
#include "common_shading.glsl"
#include "common_clump.glsl"
#include "common_furshadow.glsl"

uniform sampler2D baseColor;
uniform sampler2D mask;

in vec3 vNormal;
in vec4 vUvAtlas;
in vec3 vColor;
#if defined(PAINTED) || (defined(TEXTURED) && defined(TYPES))
in vec3 vShade;
#endif
#ifdef GROOMED
in vec3 vBare;
#include "common_types.glsl"
#endif
in vec3 vLightSpace;

out vec4 fragColor;

#if defined(TEXTURED) && defined(TYPES)
vec3 ownSkin(vec3 color) { return skinPictured(color, vUvAtlas.xy, mat2(dFdx(vUvAtlas.xy), dFdy(vUvAtlas.xy))); }
#else
vec3 ownSkin(vec3 color) { return color; }
#endif

void main() {
#if defined(VIEW_SHADOW)
  fragColor = vec4(vColor, 1.0);
#elif defined(UNDER_FUR)
  vec3 model = modelColor(baseColor, vUvAtlas.xy), color = vColor * model;
#if defined(TEXTURED) && defined(TYPES)
  // As much of it as is skin (skin.vert) has the skin's picture.
  if (skinPicture >= 0.0) {
    vec4 grows = presences(textureLod(groom, vUvAtlas.zw, 0.0).gba);
    vec3 skin = skinColorOf(grows) * model;
#ifdef CLASSIC
    float share = 0.5;
#else
    float share = 1.0 - min(2.0 * dot(grows, typeDensity), 1.0);
#endif
    color += vShade * share * (ownSkin(skin) - skin);
  }
#endif
#ifdef PAINTED
  color = painted(color, vUvAtlas.zw, 0.9 * vShade);
#endif
#ifdef GROOMED
  // Where no fur grows it is bare.
  vec4 fur = textureLod(groom, vUvAtlas.zw, 0.0);
#ifdef TYPES
  vec3 bare = vBare * ownSkin(skinColorOf(presences(fur.gba)) * model);
#else
  vec3 bare = vBare * skinColors[0].rgb * model;
#endif
#ifdef PAINTED
  bare = painted(bare, vUvAtlas.zw, vBare);
#endif
  color = mix(bare, color, coatShare(fur));
#endif
#ifdef WET
  // Between clumps, in their shade.
  float rho = clamp(clumpAt(mask, vUvAtlas.zw).a, 0.0, 1.0);
  color = wetAlbedo(color, rho) * (1.0 - wetDarkening * rho) * (1.0 - 0.3 * rho);
#endif
  fragColor = vec4(encodeSrgb(toneMap(color)), 1.0);
#else
  vec3 n = normalize(vNormal);
  vec4 clump = clumpAt(mask, vUvAtlas.zw);
  clump.a = clamp(clump.a, 0.0, 1.0);
  float facing = 0.55 + 0.45 * dot(n, light.xyz);
#if defined(VIEW_WETNESS)
  // Blue by wetness, each clump with its own colour, so that centres and borders can be read.
  vec3 shown = mix(vec3(0.32, 0.31, 0.3), mix(vec3(0.15, 0.45, 0.95), clumpColor(clump), 0.45), clump.a);
  fragColor = vec4(shown * facing, 1.0);
#elif defined(VIEW_CLUMPS)
  // Darker than the clumps above it.
  fragColor = vec4(clumpColor(clump) * (0.5 * facing), 1.0);
#elif defined(VIEW_LAYOUT)
  // A hue a chart, chequered by texels and by sixteens of them; dark where it ends, two texels of gutter before the next.
  vec2 at = vUvAtlas.zw;
  float chart = chartOf(maskAt(mask, at)), shade = 0.6;
  vec4 ones = mod(floor(vec4(at, at / 16.0) * maskTexels), 2.0);
  shade += 0.1 * abs(ones.x - ones.y) + 0.2 * abs(ones.z - ones.w);
  for (int i = 0; i < 4; ++i) {
    vec4 texel = maskAt(mask, at + (float(i & 2) - 1.0) * 3.2 / maskTexels * vec2(i & 1, 1 - (i & 1)));
    texel.x -= chart;
    if (isBeside(texel)) shade = 0.1;
  }
  fragColor = vec4(clumpColor(vec4(chart * vec2(0.13, 0.39), 0.0, 1.0)) * (shade * facing), 1.0);
#elif defined(VIEW_DIM)
  fragColor = vec4(vec3(0.13, 0.16, 0.21) * facing, 1.0);
#elif defined(VIEW_NORMALS)
  fragColor = vec4(n * 0.5 + 0.5, 1.0);
#else
  vec3 albedo = ownSkin(skinColors[0].rgb * modelColor(baseColor, vUvAtlas.xy));
#ifdef PAINTED
  albedo = painted(albedo, vUvAtlas.zw, vec3(1.0));
#endif
  vec3 color = bareSkin(albedo, dot(n, light.xyz), dot(n, up.xyz), clump.a,
                        furShadowAt(vLightSpace));
  fragColor = vec4(encodeSrgb(toneMap(color)), 1.0);
#endif
#endif
}
