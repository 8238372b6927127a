// The shadow that the model casts on the ground, and water on it, in the background's colours.
#include "common.glsl"
#include "common_gradient.glsl"
uniform sampler2D shadowMap;
in vec2 vSpot;
flat in mat3 vGradient;
#ifdef WET
uniform sampler2D puddles;
in vec3 vRay;
// Cubic B-splines through the cells: four look-ups between two cells each.
float puddle(vec2 at) {
  vec2 size = vec2(textureSize(puddles, 0)), cell = at * size - 0.5, f = fract(cell), g = 1.0 - f, low = floor(cell) + 0.5;
  vec2 w0 = g * g * g, w1 = 4.0 - 3.0 * f * f * (1.0 + g), w3 = f * f * f, s = (w0 + w1) / 6.0;
  vec2 a = (low + w1 / (w0 + w1) - 1.0) / size, b = (low + w3 / (6.0 - w0 - w1) + 1.0) / size;
  return mix(mix(textureLod(puddles, b, 0.0).r, textureLod(puddles, vec2(a.x, b.y), 0.0).r, s.x),
             mix(textureLod(puddles, vec2(b.x, a.y), 0.0).r, textureLod(puddles, a, 0.0).r, s.x), s.y);
}
#endif
out vec4 fragColor;

void main() {
  vec3 color = gradientIn(vGradient, gl_FragCoord.xy);
  // Nothing where the map ends.
  vec2 shadow = textureLod(shadowMap, vSpot, 0.0).rg;
  float dark = shadow.r;
  color *= 1.0 - 0.55 * dark;  // where the key light does not come
#ifdef WET
  // Damp ground is darker; what it cannot take up mirrors sky and light, more at grazing.
  vec2 inWorld = vSpot + 0.5 * groundCentre / groundHalfSide, within = 1.0 - smoothstep(0.4, 0.5, abs(inWorld - 0.5));
  // Floors are uneven.
  vec2 at = 16.0 * inWorld;
  vec2 bent = sin(at.yx + 1.2 * sin(0.7 * at)), rough = sin(3.1 * at.yx + 2.0 * sin(2.3 * at));
  float water = puddle(inWorld + 0.018 * bent) * within.x * within.y * exp2(0.4 * (bent.x + rough.x * rough.y)), damp = smoothstep(0.0, 0.4, water),
        wet = smoothstep(0.4, 0.48, water);
  vec3 ray = normalize(vRay), mirrored = reflect(ray, vec3(0.0, 1.0, 0.0));
  float away = 1.0 + ray.y, grazing = away * away * away, glint = pow(max(dot(mirrored, lightWorld.xyz), 0.0), 64.0);
  color *= 1.0 - 0.28 * damp - 0.12 * wet;
  color = mix(color, gradientAt(vGradient, clamp(mirrored.y + 0.5, 0.0, 1.0)) * (1.0 - 0.8 * shadow.g),
              wet * min(0.25 + 0.8 * grazing, 0.8));
  color += wet * (1.0 - dark) * 0.35 * lightIntensity * glint;
#endif
  fragColor = vec4(color + dither(gl_FragCoord.xy, vGradient[2].z), 1.0);
}
