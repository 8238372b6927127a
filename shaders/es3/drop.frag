// A drop of water as a ball: through its middle one sees the surroundings upside down, or where it clings to strands mostly
// those; its rim mirrors the surroundings, and the light shows twice: as a glint on the outside, and gathered at the far side.
#include "common.glsl"

in vec2 vDisc;
in vec2 vSize;
flat in float vFlies;
flat in mat3 vFrame;
out vec4 fragColor;

// The surroundings in a direction of the world, sRGB.
vec3 seen(vec3 to) { return mix(backgroundBottom.rgb, backgroundTop.rgb, smoothstep(-0.5, 0.5, to.y)); }

void main() {
  float out2 = dot(vDisc, vDisc);
  float covers = clamp((1.0 - sqrt(out2)) * vSize.x + 0.5, 0.0, 1.0) * vSize.y;
  if (covers <= 0.0) discard;
  float towards = sqrt(max(1.0 - out2, 0.0));
  vec3 n = vFrame * vec3(vDisc, towards), V = vFrame[2], L = lightWorld.xyz;
  // Schlick's term for water.
  float away = 1.0 - towards, fresnel = away * away;
  fresnel = 0.02 + 0.98 * fresnel * fresnel * away;
  vec3 through = seen(normalize(-V - 1.6 * vFrame * vec3(vDisc, 0.0))) * (1.0 - 0.45 * out2 * out2);
  vec3 color = mix(through, seen(reflect(-V, n)), fresnel);
  float glint = max(dot(n, normalize(L + V)), 0.0), gathered = max(dot(-n, L), 0.0);
  glint *= glint, glint *= glint, glint *= glint, glint *= glint, glint *= glint;
  gathered *= gathered;
  float alpha = covers * mix(0.25 + 0.55 * out2 * out2, 0.95, vFlies);
  vec3 shine = vec3(0.45 * light.w * (glint * glint * glint + 0.35 * gathered * gathered));
  fragColor = vec4(min(color * alpha + shine * covers, 1.0), alpha);
}
