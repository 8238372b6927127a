// r: the cast shadow  g: the contact shadow; added.
precision mediump float;
flat in vec2 vShadow;
out vec4 fragColor;
void main() { fragColor = vec4(vShadow, 0.0, 0.0); }
