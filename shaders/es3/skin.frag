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
in vec3 vLightSpace;

out vec4 fragColor;

vec3 clumpHue(vec2 centre) {
  float turn = fract(dot(centre, vec2(37.3, 91.7)));
  return clamp(abs(fract(turn + vec3(0.0, 2.0 / 3.0, 1.0 / 3.0)) * 6.0 - 3.0) - 1.0, 0.0, 1.0);
}

void main() {
#if defined(UNDER_FUR)
  fragColor = vec4(encodeSrgb(toneMap(vColor * modelColor(baseColor, vUvAtlas.xy))), 1.0);
#else
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
  vec3 color = bareSkin(skinColor.rgb * modelColor(baseColor, vUvAtlas.xy), dot(n, light.xyz), dot(n, up.xyz), clump.a,
                        furShadowAt(vLightSpace));
  fragColor = vec4(encodeSrgb(toneMap(color)), 1.0);
#endif
#endif
}
