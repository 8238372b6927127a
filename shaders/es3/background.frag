#include "common.glsl"
#include "common_gradient.glsl"
flat in mat3 vGradient;
out vec4 fragColor;
void main() { fragColor = vec4(gradientIn(vGradient, gl_FragCoord.xy) + dither(gl_FragCoord.xy, vGradient[2].z), 1.0); }
