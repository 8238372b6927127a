// A gradient behind everything: strips from the screen's foot to its top.
#include "common.glsl"
out vec3 vColor;

void main() {
  int corner = gl_VertexID % 6;
  float y = float(gl_VertexID / 6 + (corner > 1 && corner != 3 ? 1 : 0)) / float(FUR_BACKGROUND_STRIPS);
  gl_Position = vec4(corner % 2 == 0 ? -1.0 : 1.0, y * 2.0 - 1.0, 1.0, 1.0);
  vColor = mix(backgroundBottom.rgb, backgroundTop.rgb, smoothstep(0.0, 1.0, y));
}
