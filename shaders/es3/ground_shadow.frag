// r: the cast shadow  g: what is above  b: the mirror image  a: what stands there; added.
precision mediump float;
in vec4 vShadow;
out vec4 fragColor;
void main() { fragColor = vShadow; }
