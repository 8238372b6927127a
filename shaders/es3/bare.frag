// Parts without fur, as glTF has them: the metallic-roughness material (glTF 2.0, appendix B.2 and B.3), in the light of the scene.
// pi is left out of the diffuse part, as on skin, and so of all.
#include "common.glsl"
#include "common_shading.glsl"
#include "common_furshadow.glsl"
#include "shared/Material.h"

uniform sampler2D baseColor;
uniform sampler2D normals;
uniform sampler2D roughnessMap;
uniform sampler2D occlusionMap;
uniform sampler2D emissiveMap;

in vec3 vPosition;
in vec3 vNormal;
in vec4 vUv;  // zw: the others
in vec3 vLightSpace;

out vec4 fragColor;

vec2 uvOf(vec4 rows[2]) { return rows[0].w > 0.5 ? vUv.zw : vUv.xy; }
vec4 at(sampler2D picture, vec4 rows[2]) {
  vec3 uv = vec3(uvOf(rows), 1.0);
  return texture(picture, vec2(dot(rows[0].xyz, uv), dot(rows[1].xyz, uv)));
}

// The normal of the picture in the frame that position and texture coordinates span from pixel to pixel (C. Schueler 2013,
// "Normal Mapping Without Precomputed Tangents").
vec3 bumped(vec3 n) {
  vec3 px = dFdx(vPosition), py = dFdy(vPosition);
  vec2 uv = uvOf(normalRows), ux = dFdx(uv), uy = dFdy(uv);
  vec3 acrossX = cross(n, px), acrossY = cross(py, n);
  vec3 t = acrossY * ux.x + acrossX * uy.x, b = acrossY * ux.y + acrossX * uy.y;
  float size = max(dot(t, t), dot(b, b));
  vec3 bump = at(normals, normalRows).xyz * 2.0 - 1.0;
  bump.xy *= normalScale;
  return size < 1e-20 ? n : normalize((t * bump.x + b * bump.y) * inversesqrt(size) + n * bump.z);
}

// What a light of that direction sends to the eye, a share of it.
vec3 lightOn(vec3 n, vec3 L, vec3 V, vec3 diffuse, vec3 f0, float alpha) {
  vec3 H = normalize(L + V);
  float nl = max(dot(n, L), 0.0), nv = max(dot(n, V), 1e-3), nh = max(dot(n, H), 0.0), a2 = alpha * alpha;
  float away = 1.0 - max(dot(V, H), 0.0), away2 = away * away;
  vec3 fresnel = f0 + (1.0 - f0) * (away2 * away2 * away);
  float d = nh * nh * (a2 - 1.0) + 1.0;  // GGX, times pi
  float visible = 0.5 / max(nl * sqrt(nv * nv * (1.0 - a2) + a2) + nv * sqrt(nl * nl * (1.0 - a2) + a2), 1e-4);
  return nl * ((1.0 - fresnel) * diffuse + fresnel * (a2 / (d * d) * visible));
}

// How much of light from all around a surface mirrors (B. Karis 2014, "Physically Based Shading on Mobile").
vec3 mirroredShare(vec3 f0, float roughness, float nv) {
  vec4 r = roughness * vec4(-1.0, -0.0275, -0.572, 0.022) + vec4(1.0, 0.0425, 1.04, -0.04);
  float a = min(r.x * r.x, exp2(-9.28 * nv)) * r.x + r.y;
  return f0 * (-1.04 * a + r.z) + 1.04 * a + r.w;
}

void main() {
  vec4 base = texture(baseColor, vUv.xy);
  vec3 albedo = decodeSrgb(base.rgb) * baseColorFactor.rgb;
  float opacity = base.a * baseColorFactor.a;
  if (alphaMode < 0.5) opacity = 1.0;
  else if (alphaMode < 1.5) opacity = clamp((opacity - alphaCutoff) / max(fwidth(opacity), 1e-3) + 0.5, 0.0, 1.0);
  if (opacity <= 0.0) discard;
  vec2 look = at(roughnessMap, roughnessRows).gb;
  float roughness = clamp(look.x * roughnessFactor, 0.05, 1.0), metallic = look.y * metallicFactor;
  vec3 diffuse = albedo * (1.0 - metallic), f0 = mix(vec3(0.04), albedo, metallic);

  vec3 V = normalize(eye.xyz - vPosition), n = normalize(vNormal);
  if (!gl_FrontFacing) n = -n;
  n = bumped(n);
  float nv = max(dot(n, V), 1e-3), lit = furShadowAt(vLightSpace);
  vec3 color = lit * keyLight.rgb * lightOn(n, light.xyz, V, diffuse, f0, roughness * roughness) + fillLight * lightOn(n, V, V, diffuse, f0, max(roughness * roughness, 0.3));
  vec3 mirrored = mirroredShare(f0, roughness, nv);
  float open = mix(1.0, at(occlusionMap, occlusionRows).r, occlusionStrength), upness = dot(n, up.xyz);
  // A smooth one mirrors the horizon as the edge that it is.
  float above = dot(reflect(-V, n), up.xyz);
  above = mix(clamp(4.0 * above, -1.0, 1.0), above, sqrt(roughness));
  color += open * ((1.0 - mirrored) * diffuse * skyLight(upness) + mirrored * skyLight(above));
  color += emissiveFactor.rgb * decodeSrgb(at(emissiveMap, emissiveRows).rgb);
  float covered = alphaMode > 1.5 ? opacity : 1.0;
  fragColor = vec4(encodeSrgb(toneMap(color)) * covered, opacity);
}
