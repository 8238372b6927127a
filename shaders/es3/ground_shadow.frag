// r: the cast shadow  g: the contact shadow  b: the mirror image; added.
precision mediump float;
flat in vec3 vShadow;
out vec4 fragColor;
void main() { fragColor = vec4(vShadow, 0.0); }
