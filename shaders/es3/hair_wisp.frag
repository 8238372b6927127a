// A wisp of a view: its colour, rounded by a little light so that one is told from the next.
#include "common.glsl"
#include "common_noise.glsl"
uniform mediump sampler2DArray strips;  // hair/MemberStrands.h: coverage, slope, random number, nearness
in vec3 vPicture;
in vec4 vColor;
in vec4 vAcross;
flat in float vKind;
out vec4 fragColor;

void main() {
  vec4 seen = texture(strips, vec3(vPicture.xy / vPicture.z, vKind));
  float alpha = floor(seen.r * samples + pixelNoise()) / samples;
  if (alpha == 0.0) discard;
  float round = 1.0 - 0.35 * vAcross.w * vAcross.w + 0.2 * vAcross.w * dot(normalize(vAcross.xyz), light.xyz);
  float shade = round * mix(0.55, 1.0, seen.a) * mix(0.6, 1.0, smoothstep(0.0, 0.3, vColor.w));
  fragColor = vec4(vColor.rgb * shade, alpha);
}
