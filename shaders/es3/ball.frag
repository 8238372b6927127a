#include "common.glsl"
#include "common_shading.glsl"
in vec3 vNormal, vToEye;
out vec4 fragColor;
const vec3 kRubber = vec3(0.55, 0.06, 0.05);
void main() {
  vec3 n = normalize(vNormal), toEye = normalize(vToEye), between = normalize(toEye + lightWorld.xyz);
  vec3 around = mix(floorLight.rgb, sky.rgb, 0.5 + 0.5 * n.y);
  float lit = max(dot(n, lightWorld.xyz), 0.0);
  vec3 color = kRubber * (around + lightIntensity * 0.4 * lit) + lightIntensity * 0.12 * lit * pow(max(dot(n, between), 0.0), 40.0);
  fragColor = vec4(encodeSrgb(toneMap(color)), 1.0);
}
