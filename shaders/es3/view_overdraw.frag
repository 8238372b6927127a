// Counts a fragment, whatever it would show.
precision mediump float;
#include "common_heat.glsl"
out vec4 fragColor;
void main() { fragColor = heat(1.0); }
