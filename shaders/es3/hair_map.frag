// A scalp's map on the skin, which is dim where there is none.
#include "common.glsl"
uniform sampler2D hairColors;
in vec3 vNormal;
in vec2 vAtlas;
out vec4 fragColor;

void main() {
  vec4 map = texture(hairColors, vAtlas);
  vec3 color = mix(vec3(0.13, 0.16, 0.21), map.rgb, map.a);
  fragColor = vec4(color * (0.55 + 0.45 * dot(normalize(vNormal), light.xyz)), 1.0);
}
