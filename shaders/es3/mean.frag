// The mean of a picture's samples with one more. In whole numbers: every context draws into them.
#include "common.glsl"
#include "common_mean.glsl"
uniform sampler2D source;
uniform highp usampler2D before;
out uvec4 mean;

void main() {
  vec4 shown = texelFetch(source, ivec2(gl_FragCoord.xy), 0);
  // Colours come multiplied by an alpha that counts only where there is no background.
  float alpha = mix(1.0, shown.a, transparent);
  vec4 light = vec4(lightOf(min(shown.rgb / max(alpha, 1e-3), 1.0)) * alpha, alpha) * 65535.0;
  vec4 last = vec4(texelFetch(before, ivec2(gl_FragCoord.xy), 0));
  mean = uvec4(mix(last, light, sampleShare) + 0.5);
}
