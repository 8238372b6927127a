// The shadow that the model casts on the ground, and water on it, in the gradient's colours (background.vert).
#include "common.glsl"
#include "common_noise.glsl"
uniform sampler2D shadowMap;
in vec2 vSpot;
#ifdef WET
uniform sampler2D puddles;
in vec3 vRay;
#endif
out vec4 fragColor;

void main() {
  vec3 color = mix(backgroundBottom.rgb, backgroundTop.rgb, smoothstep(0.0, lightWorld.w, pixel().y));
  // Nothing where the map ends.
  float dark = textureLod(shadowMap, vSpot, 0.0).r;
  color -= color * (groundPlane.z * dark);
#ifdef WET
  // Damp ground is darker; what it cannot take up mirrors sky and light, more at grazing.
  vec2 inWorld = vSpot + 0.5 * groundCentre.xy / groundPlane.y, within = step(abs(inWorld - 0.5), vec2(0.5));
  float water = 0.0;
  for (int i = 0; i < 4; ++i) water += 0.25 * textureLod(puddles, inWorld + (vec2(i & 1, i >> 1) - 0.5) / 64.0, 0.0).r;
  water *= within.x * within.y;
  float damp = smoothstep(0.0, 0.5, water), wet = smoothstep(0.3, 0.6, water);
  vec3 ray = normalize(vRay);
  float away = 1.0 + ray.y, grazing = away * away * away, glint = max(dot(reflect(ray, vec3(0.0, 1.0, 0.0)), lightWorld.xyz), 0.0);
  color *= 1.0 - 0.22 * damp;
  color = mix(color, backgroundTop.rgb, wet * min(0.04 + 0.7 * grazing, 0.7) * (1.0 - 0.5 * dark));
  glint *= glint, glint *= glint, glint *= glint, glint *= glint, glint *= glint;
  color += wet * (1.0 - dark) * 0.35 * light.w * glint * glint;
#endif
  fragColor = vec4(color + (quickNoise() - 0.5) / 255.0, 1.0);
}
