// The cells of the ground on which anything shows.
#include "common.glsl"
#include "common_gradient.glsl"
uniform sampler2D shadowMap;
out vec2 vSpot;  // of the ground, 0..1 over the shadow map
flat out mat3 vGradient;  // of the background
#ifdef WET
out vec3 vRay;   // world space, from the eye to the ground
#endif

void main() {
  int corner = gl_VertexID % 6, part = gl_VertexID / 6;
  float side = 1.0 / float(FUR_GROUND_CELLS);
  vec2 cell = side * vec2(part % FUR_GROUND_CELLS, part / FUR_GROUND_CELLS);
  vSpot = cell + side * vec2(corner % 2, corner > 1 && corner != 3 ? 1 : 0);
#ifdef WET
  // Puddles lie round the world's origin, and may lie anywhere.
  vec2 more = abs(groundCentre) / groundHalfSide;
  vSpot = mix(-more, 1.0 + more, vSpot);
  bool shows = true;
#else
  bool shows = false;
  for (int i = 0; i < 9; ++i)
    shows = shows || textureLod(shadowMap, cell + 0.5 * side * vec2(i % 3, i / 3), 0.0).r > 0.0;
#endif
  vec2 at = groundHalfSide * (2.0 * vSpot - 1.0) + groundCentre;
  vec3 eyeWorld = (worldFromModel * vec4(eye.xyz, 1.0)).xyz, ground = vec3(at.x, groundHeight, at.y);
#ifdef WET
  vRay = ground - eyeWorld;
#endif
  // From below the ground would hide the model.
  gl_Position = shows && eyeWorld.y > groundHeight ? clipFromWorld * vec4(ground, 1.0) : vec4(0.0);
  vGradient = gradientOfPicture();
  // A hair before the screen.
  gl_Position.z = gl_Position.w * 0.999999;
}
