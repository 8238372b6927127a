// Clear water: through its middle one sees what is behind it, towards its rim the surroundings upside down, which are darker
// there, and at the rim it mirrors them. The light shows twice: as a glint, and gathered at the far side.
#include "common.glsl"

#ifdef BEAD
flat in float vReach;  // of the point, in radii
#else
in vec2 vAt;
#endif
flat in vec4 vSize;
flat in mat3 vFrame;
flat in float vPasses;
out vec4 fragColor;

// The surroundings in a direction of the world, sRGB.
vec3 seen(vec3 to) { return mix(backgroundBottom.rgb, backgroundTop.rgb, smoothstep(-0.5, 0.5, to.y)); }

void main() {
#ifdef BEAD
  vec2 vAt = vReach * vec2(2.0, -2.0) * (gl_PointCoord - 0.5);
#endif
  vec2 disc = vec2(vAt.x, sign(vAt.y) * max(abs(vAt.y) - vSize.z, 0.0));
  float out2 = dot(disc, disc), thin = max(0.15, fwidth(out2)), covers = clamp((1.0 - sqrt(out2)) * vSize.x + 0.5, 0.0, 1.0) * vSize.y * vSize.w;
  if (covers <= 0.0) discard;
  // A piece of a jet goes over into the next.
  if (vPasses == -1.0) covers *= clamp(0.5 * (vSize.z + 0.5 - abs(vAt.y)), 0.0, 1.0), disc.y = 0.0, out2 = disc.x * disc.x;
  float towards = sqrt(max(1.0 - out2, 0.0));
  vec3 n = vFrame * vec3(disc, towards), V = vFrame[2], L = lightWorld.xyz;
  if (vPasses == -2.0) {
    // A wave on the ground, lit on one side.
    fragColor = vec4((0.6 + dot(n.xz, L.xz)) * backgroundTop.rgb + 0.2, 1.0) * (max(1.0 - abs(sqrt(out2) - 0.8) / thin, 0.0) * 0.08 / thin * covers);
    return;
  }
  // Schlick's term for water.
  float fresnel = 0.02 + 0.98 * pow(1.0 - towards, 5.0);
  vec3 through = seen(normalize(-V - 1.6 * vFrame * vec3(disc, 0.0))) * (1.0 - 0.45 * out2 * out2);
  vec3 color = mix(through, seen(reflect(-V, n)), fresnel);
  float glint = pow(max(dot(n, normalize(L + V)), 0.0), 96.0), gathered = max(dot(-n, L), 0.0);
  float alpha = 0.3 + 0.55 * out2 * out2;
  if (vPasses == -1.0) alpha += 0.15;  // a jet has air in it
  if (vPasses > 0.0) {
    // While it passes, what is behind it shows longer at its ends and sides. As much water as before, where it is wider than a pixel.
    float soft = vPasses * clamp(0.4 * vSize.x - 0.4, 0.0, 0.8);
    covers *= (1.0 - soft * min(out2, 1.0)) / (1.0 - soft / 3.0) * (1.0 - vPasses * smoothstep(0.2, 1.0, abs(vAt.y) / (1.0 + vSize.z)));
    alpha = mix(alpha, 0.45, vPasses);
  }
  alpha *= covers;
  vec3 shine = vec3(lightIntensity * (0.45 * glint + 0.1 * gathered * gathered + 0.03 * abs(vPasses)));
  fragColor = vec4(min(color * alpha + shine * covers, 1.0), alpha);
}
