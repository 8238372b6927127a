// The mean of a picture's samples on the screen.
#include "common.glsl"
#include "common_mean.glsl"
#include "common_gradient.glsl"
uniform highp usampler2D before;
out vec4 fragColor;

void main() {
  vec4 light = vec4(texelFetch(before, ivec2(gl_FragCoord.xy), 0)) / 65535.0;
  vec3 color = shownOf(light.rgb / max(light.a, 1e-3)) * light.a;
  // Half a step of noise, as smooth gradients would band; a single sample has had it.
  color += dither(gl_FragCoord.xy, ditherStart()) * float(sampleShare < 1.0) * light.a;
  fragColor = vec4(color, light.a);
}
