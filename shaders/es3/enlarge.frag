// A smaller picture over the whole screen.
precision highp float;
uniform highp sampler2D source;
in vec2 vScreen;
out vec4 fragColor;
void main() { fragColor = vec4(texture(source, vScreen).rgb, 1.0); }
