// Wisps as strips, each in a colour of its own at its root and at its tip.
#include "common.glsl"
#include "hair_strip.glsl"
uniform highp sampler2D hairColors;  // root and tip, a row a wisp
out vec3 vPicture;  // xy: place in the strip's picture, times z
out vec4 vColor;    // w: height, 0 root to 1 tip
out vec4 vAcross;   // unit; w: -1 to 1 from side to side
flat out float vKind;

void main() {
  int wisp = int(firstWisp) + gl_InstanceID;
  StripVertex v = stripVertex(gl_VertexID, wisp, eye.xyz, 1.0);
  gl_Position = clipFromModel * vec4(v.position, 1.0);
  vPicture = v.picture;
  vColor = vec4(mix(texelFetch(hairColors, ivec2(0, wisp), 0).rgb, texelFetch(hairColors, ivec2(1, wisp), 0).rgb, v.t), v.t);
  vAcross = vec4(v.across / v.picture.z, v.side);
  vKind = v.shape.z;
}
