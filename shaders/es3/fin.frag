// Strands seen from the side along the silhouette: shaded as the shells are, so that both meet without a seam.
#include "common.glsl"
#include "common_shading.glsl"
#include "common_clump.glsl"

uniform sampler2D fin;  // r: coverage  g: tangent along the edge  b: across  a: variance
uniform sampler2D baseColor;
#ifdef WET
uniform sampler2D mask;
#endif

in vec4 vFin;
in vec4 vLight;
in vec4 vView;
in vec2 vUv;
in vec2 vLean;
#ifdef WET
in vec2 vAtlas;
flat in vec2 vAtlasAlong;
#endif

out vec4 fragColor;

void main() {
  float u = vFin.x, h = vFin.y, rho = 0.0, clumpLean = 0.0;
#ifdef WET
  vec4 clump = clumpAt(mask, vAtlas);
  if (clump.a > 0.0) {
    float s = min(clumpProfile(h, water.x, shape.z) * clump.a, FUR_MAX_SHIFT);
    vec2 fromCentre = (vAtlas - clump.xy) / (1.0 - s);
    if (dot(fromCentre, fromCentre) > clump.z * clump.z || clumpAt(mask, clump.xy + fromCentre).a == 0.0) discard;
    // Only the part along the edge lies in the fin's plane.
    float along = dot(vAtlasAlong, vAtlasAlong);
    float turns = along > 0.0 ? dot(clump.xy + fromCentre - vAtlas, vAtlasAlong) / along : 0.0;
    u += turns;
    clumpLean = -turns / max(h, 0.1) / max(shape.x * shape.y, 1e-6);
    rho = clump.a;
  }
#endif
  vec4 t = textureLod(fin, vec2(u, min(h, 0.985)), pickLevel(vFin.w));
  float sharp = exp2(max(-vFin.w, 0.0));
  float alpha = clamp((t.r - 0.5) * sharp + 0.5, 0.0, 1.0) * vFin.z;
  alpha *= smoothstep(0.0, 0.2, h);  // no hard line where a fin meets the skin
  if (alpha < 0.02) discard;
  vec2 tilt = t.gb * 2.0 - 1.0;
  vec3 tangent = normalize(vec3(tilt + vLean + vec2(clumpLean, 0.0), sqrt(max(0.05, 1.0 - dot(tilt, tilt)))));
  vec3 albedo = strandColor(h, t.a, modelColor(baseColor, vUv));
  // Nothing stands before an outline: light reaches it from the side, further down than inside the coat.
  float exposed = mix(h, 1.0, 0.6);
  vec3 color = shadeStrand(albedo, tangent, normalize(vLight.xyz), normalize(vView.xyz), exposed, rho, 0.9, vLight.w);
  fragColor = vec4(encodeSrgb(toneMap(color)) * alpha, alpha);
}
