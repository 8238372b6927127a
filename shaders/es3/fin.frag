// Strands seen from the side along the silhouette: shaded as the shells are, so that both meet without a seam.
#include "common.glsl"
#include "common_shading.glsl"
#include "common_clump.glsl"
#include "common_noise.glsl"
#include "common_furshadow.glsl"

uniform sampler2D fin;  // r: coverage  g: tangent along the edge  b: across  a: variance
uniform sampler2D baseColor;
#ifdef WET
uniform sampler2D mask;
#endif

in vec4 vFin;
in vec4 vLight;
in vec3 vView;
in vec2 vUv;
in vec2 vLean;
#ifdef WET
in vec2 vAtlas;
flat in vec2 vAtlasAlong;
#endif

in vec3 vLightSpace;
out vec4 fragColor;

void main() {
  float u = vFin.x, h = vFin.y, rho = 0.0;
  vec2 clumpLean = vec2(0.0);
#ifdef WET
  vec4 clump = clumpAt(mask, vAtlas);
  if (clump.a > 0.0) {
    float s = clumpPull(h, clump.a);
    vec2 fromCentre = (vAtlas - clump.xy) / (1.0 - s);
    if (dot(fromCentre, fromCentre) > clump.z * clump.z || clumpAt(mask, clump.xy + fromCentre).a == 0.0) discard;
    // In turns of the fin map along the edge and across it; only the first moves the look-up, both
    // tilt the strand.
    vec2 moved = clump.xy + fromCentre - vAtlas, across = vec2(-vAtlasAlong.y, vAtlasAlong.x);
    vec2 turns = vec2(dot(moved, vAtlasAlong), dot(moved, across)) / max(dot(vAtlasAlong, vAtlasAlong), 1e-12);
    u += turns.x;
    clumpLean = -turns / (max(h, 0.1) * max(shape.x * shape.y, 1e-6));
    rho = clump.a;
  }
#endif
  vec4 t = textureLod(fin, vec2(u, min(h, 0.985)), floor(max(vFin.w, 0.0) + 0.5));
  float sharp = exp2(max(-vFin.w, 0.0));
  float alpha = clamp((t.r - 0.5) * sharp + 0.5, 0.0, 1.0) * vFin.z;
  // Slabs show the coat up to its outline; only the tips that stand out over it are missing.
  alpha *= smoothstep(FUR_FIN_FOOT, 0.9, h) * (1.0 - smoothstep(0.94, 1.0, h));
  if (alpha < 0.02) discard;
  vec2 tilt = t.gb * 2.0 - 1.0;
  vec3 tangent = normalize(vec3(tilt + vLean + clumpLean, sqrt(max(0.05, 1.0 - dot(tilt, tilt)))));
  vec3 albedo = strandColor(h, t.a, modelColor(baseColor, vUv));
  // Nothing stands before an outline: light reaches it from the side, further down than inside the coat.
  float exposed = mix(h, 1.0, 0.4);
  vec3 color = shadeStrand(albedo, tangent, normalize(vLight.xyz), normalize(vView), exposed, rho, 0.75 * furShadowAt(vLightSpace), vLight.w, t.a);
  // Samples by chance, as in shell.frag.
  alpha += (pixelNoise() - 0.5) / sky.w;
  if (alpha < 0.5 / sky.w) discard;
  fragColor = vec4(encodeSrgb(toneMap(color)), alpha);
}
