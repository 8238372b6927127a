// The skin under the fur: pores darkened by the lowest layer, the same light.
#include "common.glsl"
#include "common_shading.glsl"
#include "common_clump.glsl"

uniform sampler2DArray tile;
uniform sampler2D baseColor;
uniform sampler2D mask;

in vec3 vNormal;
in vec4 vUvAtlas;
in vec2 vTile;

out vec4 fragColor;

vec3 clumpHue(vec2 centre) {
  float turn = fract(dot(centre, vec2(37.3, 91.7)));
  return clamp(abs(fract(turn + vec3(0.0, 2.0 / 3.0, 1.0 / 3.0)) * 6.0 - 3.0) - 1.0, 0.0, 1.0);
}

void main() {
  vec3 n = normalize(vNormal);
  vec4 clump = clumpAt(mask, vUvAtlas.zw);
#if defined(VIEW_WETNESS)
  // Blue by wetness, each clump with its own hue, so that centres and borders can be read.
  float facing = 0.55 + 0.45 * dot(n, normalize(light.xyz));
  vec3 shown = mix(vec3(0.32, 0.31, 0.3), mix(vec3(0.15, 0.45, 0.95), clumpHue(clump.xy), 0.45), clump.a);
  fragColor = vec4(shown * facing, 1.0);
#elif defined(VIEW_NORMALS)
  fragColor = vec4(n * 0.5 + 0.5, 1.0);
#else
  // Without fur the skin is bare: full light, no pores.
  float furry = float(shape.x > 0.0) * step(0.001, volume.z);
  float pores = texture(tile, vec3(vTile, 0.0)).r * furry;
  float nDotL = dot(n, light.xyz);
  float upness = dot(n, up.xyz);
  float shadow = mix(1.0, furShadow(0.0, volume.z, nDotL), shading.w * furry);
  vec3 albedo = skinColor.rgb * modelColor(baseColor, vUvAtlas.xy) * (1.0 - 0.5 * pores);
  vec3 color = albedo * (light.w * max(nDotL, 0.0) * shadow + skyLight(upness));
  color *= (1.0 - coat.x * furry) * (1.0 - water.y * clump.a);
  fragColor = vec4(encodeSrgb(toneMap(color)), 1.0);
#endif
}
