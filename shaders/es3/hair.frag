// Long hair as it is seen: a strip's strands from its picture, or a strand as a line of its true width.
#include "common.glsl"
#include "common_shading.glsl"
#include "common_noise.glsl"
#include "common_furshadow.glsl"
#include "common_hair.glsl"

in vec4 vBand;
in vec4 vTangent;
in vec4 vView;
in vec4 vNormal;
in vec3 vLightSpace;
#ifdef STRIPS
in vec4 vAcross;
flat in float vKind;
uniform mediump sampler2DArray strips;  // hair/MemberStrands.h: coverage, slope, random number, nearness
#endif
out vec4 fragColor;

// How much light comes through the fur to a point of long hair, through which light goes further: a wisp is dark only where many lie before it.
float hairShadowAt(vec3 at) {
#if defined(SHADOW_LAYERS)
  return betweenTexels(at);
#elif defined(SHADOW_DEPTH)
  float first = unpack(textureLod(firstSurfaces, at.xy, 0.0).rg);
  return exp2(-hairExtinction * max(at.z - first * shadowRange - hairShadowBias, 0.0));
#else
  return 1.0;
#endif
}

void main() {
  float h = vBand.z;
  vec3 T = vTangent.xyz;
#ifdef STRIPS
  vec4 seen = texture(strips, vec3(vBand.xy / vView.w, vKind));
  float alpha = seen.r, strand = fract(seen.b + vTangent.w), front = seen.a;
  T = normalize(T) + vAcross.xyz * (8.0 * (seen.g - 0.5) * vAcross.w);
#else
  float strand = vTangent.w, front = vView.w;
  // Where strands are thinner than a pixel there are fewer, a pixel wide: each ends where it is thinner than its own chance has it.
  float alpha = step(fract(61.0 * strand), vBand.y);
#endif
  float chance = fract(pixelNoise() + 7.0 * strand);
  // A whole number of samples, by chance: drivers differ in what they make of the shares between.
  alpha = floor(alpha * samples + chance) / samples;
  if (alpha == 0.0) discard;

  vec3 V = normalize(vView.xyz), L = light.xyz;
  T = normalize(T);
  // Hair is turned the way of the skin that it grows from; where it stands up from it, towards the light.
  vec3 z = normalize(vNormal.xyz - T * dot(T, vNormal.xyz) + 0.35 * (L - T * dot(T, L)) + 1e-4 * V);
  z = normalize(z - T * dot(T, z));
  mat3 frame = transpose(mat3(T, cross(z, T), z));
  vec3 albedo = strandColor(hairRootColor.rgb, hairTipColor.rgb, hairVariance, h, strand, vec3(1.0));
  // What lies behind others of its wisp gets less light; so does what lies deep among all.
  float height = mix(0.55, 1.0, front) * mix(1.0, vNormal.w, hairOcclusion);
  float lit = hairShadowAt(vLightSpace);
#ifdef WET
  albedo = wetAlbedo(albedo, vBand.w);
#endif
  // A strand is not as even as its wisp: it shines here and there.
  vec3 tangent = normalize(vec3(1.0, 0.0, 0.12 * sin(6.2831853 * (strand + 3.0 * h))));
  vec3 color = shadeStrand(albedo, tangent, frame * L, frame * V, height, vBand.w, lit, dot(z, up.xyz), strand, mix(hairShininess, 2.0 * hairShininess, vBand.w), hairGloss);
#ifdef WET
  vec2 mirrored = waterGloss(tangent, vec3(0.0, 0.0, 1.0), frame * L, frame * V, vBand.w, 0.0, strand);
  // A strand mirrors on its own: half of what a clump of fur does, whose strands lie in one film.
  color += 0.5 * (mirrored.x * lit * keyLight.rgb + mirrored.y * skyLight(dot(z, up.xyz)));
#endif
  fragColor = vec4(encodeSrgb(toneMap(color)), alpha);
}
