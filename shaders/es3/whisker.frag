// A whisker as a line of its true width: thinner than a pixel it covers that share of it.
#include "common.glsl"
#include "common_shading.glsl"
#include "common_noise.glsl"
#include "common_furshadow.glsl"
#include "common_line.glsl"

in vec4 vBand;
in vec4 vTangent;
in vec4 vView;
in vec3 vColor;
in vec3 vLightSpace;
out vec4 fragColor;

void main() {
  float alpha = lineCoverage(vBand.x, vBand.y);
  // Its foot stands among strands.
  float h = clamp(vBand.z, 0.0, 1.0);
  alpha *= smoothstep(0.2, 1.0, h);
  // A whole number of samples, by chance: drivers differ in what they make of the shares between.
  alpha = floor(alpha * samples + pixelNoise()) / samples;
  if (alpha == 0.0) discard;

  // It stands in the open: no surface but its own turns away from the light. z: across it, towards the light.
  vec3 T = normalize(vTangent.xyz), V = normalize(vView.xyz), L = light.xyz;
  vec3 z = L - T * dot(T, L);
  z *= inversesqrt(max(dot(z, z), 1e-12));
  vec3 y = cross(z, T);
  mat3 frame = transpose(mat3(T, y, z));
  // Half of the light goes through a hair that stands alone; in a coat it meets the next one.
  float rim = 2.0 * vBand.x / (vBand.y + 1.0);
  vec3 albedo = vColor * (0.35 + 0.4 * vTangent.w) * (1.0 - 0.5 * rim * rim);
  // The strands round its foot shade it too.
  float lit = vView.w * mix(0.35, 1.0, min(0.5 * vBand.z, 1.0)) * furShadowAt(vLightSpace);
#ifdef WET
  albedo = wetAlbedo(albedo, vBand.w);
#endif
  vec3 color = shadeStrand(albedo, frame * T, frame * L, frame * V, h, vBand.w, lit, dot(z, up.xyz), vTangent.w);
#ifdef WET
  // Round: where its normal lies between those to the eye and to the light it shines, all along.
  vec2 mirrored = waterGloss(frame * T, normalize(frame * (V - T * dot(T, V)) + vec3(0.0, rim, 0.0)), frame * L, frame * V, vBand.w, 0.0, vTangent.w, 1.0);
  color += mirrored.x * lit * keyLight.rgb + mirrored.y * skyLight(dot(z, up.xyz));
#endif
  fragColor = vec4(encodeSrgb(toneMap(color)), alpha);
}
