#include "common.glsl"
#include "common_shading.glsl"
#include "common_noise.glsl"
#include "common_furshadow.glsl"
#include "common_hair_samples.glsl"

in vec3 vPosition;
in vec3 vNormal;
in vec3 vTangent;
in vec3 vLightSpace;
in float vDensity;
out vec4 fragColor;

// A random number a whole one, smoothly from one to the next.
float chanceAt(float x) {
  float i = floor(x), f = x - i;
  vec2 ends = fract(sin(vec2(i, i + 1.0) * 12.9898) * 43758.5453);
  return mix(ends.x, ends.y, f * f * (3.0 - 2.0 * f));
}

void main() {
  vec3 n = normalize(vNormal), T = normalize(vTangent - n * dot(vTangent, n)), V = normalize(eye.xyz - vPosition), L = light.xyz;
  // Strands side by side along the tangents; where they are thinner than a pixel, what they are together.
  float across = dot(vPosition, cross(n, T)) / (2.0 * strandWidth), fine = clamp(1.5 - fwidth(across), 0.0, 1.0);
  float strand = mix(0.5, chanceAt(across), fine);
  // Its border is that of strands.
  float alpha = wholeSamples(smoothstep(0.1, 0.6, skinCover * vDensity * (0.5 + strand)), fract(pixelNoise() + 7.0 * strand));
  if (alpha == 0.0) discard;
  vec3 albedo = strandColor(hairRootColor.rgb, hairTipColor.rgb, hairVariance, 0.1, strand, vec3(1.0));
  // Where hair parts or stands up its tangents turn from one vertex to the next, and gloss would draw the triangles.
  float lies = dot(vTangent, vTangent), gloss = hairGloss * lies * lies;
  // Under all others.
  float lit = furShadowAt(vLightSpace), open = mix(1.0, 0.5, hairOcclusion), facing = dot(L, V);
  vec2 normal = vec2(dot(n, L), dot(n, V));
  StrandLight lights = StrandLight(keyLight.rgb * (lit * bodyShare(normal.x)), keyLight.rgb * (lit * rimLight(facing, normal.y, open)), fringe(normal.y, open), skyLight(dot(n, up.xyz)));
  vec3 color = shadeStrand(lights, albedo, vec2(dot(T, L), dot(T, V)), normal, facing, open, 0.0, strand, hairShininess, gloss * glossShare(normal.x));
  fragColor = vec4(encodeSrgb(toneMap(color)), alpha);
}
