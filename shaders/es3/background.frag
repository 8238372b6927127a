#include "common.glsl"
#include "common_noise.glsl"
in vec3 vColor;
out vec4 fragColor;
// Half a step of noise: a smooth gradient bands in 8 bits.
void main() { fragColor = vec4(vColor + (quickNoise() - 0.5) / 255.0, 1.0); }
