// What is behind everything: first the cells of the ground on which anything shows; then strips from the screen's foot to
// its top, with the gradient's colours, for all that is left of it.
#include "common.glsl"
uniform sampler2D shadowMap;
out vec3 vColor;
out vec2 vSpot;        // of the ground, 0..1 over the shadow map
#ifdef WET
out vec3 vRay;         // world space, from the eye to the ground
#endif
flat out float vDark;  // how dark shadows are; 0: no ground
const vec2 kCorners[6] = vec2[6](vec2(0.0, 0.0), vec2(1.0, 0.0), vec2(0.0, 1.0), vec2(0.0, 1.0), vec2(1.0, 0.0), vec2(1.0, 1.0));
const int kCells = FUR_GROUND_CELLS * FUR_GROUND_CELLS;

void main() {
  vec2 corner = kCorners[gl_VertexID % 6];
  int part = gl_VertexID / 6;
  vColor = vec3(0.0);
  vSpot = vec2(0.0);
#ifdef WET
  vRay = vec3(0.0);
#endif
  vDark = 0.0;
  if (part >= kCells) {
    float y = (float(part - kCells) + corner.y) / float(FUR_BACKGROUND_STRIPS);
    gl_Position = vec4(corner.x * 2.0 - 1.0, y * 2.0 - 1.0, 1.0, 1.0);
    vColor = mix(backgroundBottom.rgb, backgroundTop.rgb, smoothstep(0.0, 1.0, y));
    return;
  }
  float side = 1.0 / float(FUR_GROUND_CELLS);
  vec2 cell = side * vec2(part % FUR_GROUND_CELLS, part / FUR_GROUND_CELLS);
#ifdef WET
  // Puddles lie round the world's origin, and may lie anywhere.
  vec2 more = abs(groundCentre.xy) / groundPlane.y;
  vSpot = mix(-more, 1.0 + more, cell + side * corner);
  bool shows = true;
#else
  vSpot = cell + side * corner;
  bool shows = false;
  for (int i = 0; i < 9; ++i)
    shows = shows || textureLod(shadowMap, cell + 0.5 * side * vec2(i % 3, i / 3), 0.0).r > 0.0;
#endif
  vec2 at = groundPlane.y * (2.0 * vSpot - 1.0) + groundCentre.xy;
  vec3 eyeWorld = (worldFromModel * vec4(eye.xyz, 1.0)).xyz, ground = vec3(at.x, groundPlane.x, at.y);
#ifdef WET
  vRay = ground - eyeWorld;
#endif
  // From below the ground would hide the model.
  if (!shows || eyeWorld.y <= groundPlane.x || groundPlane.z <= 0.0) {
    gl_Position = vec4(0.0);
    return;
  }
  vDark = groundPlane.z;
  gl_Position = clipFromWorld * vec4(ground, 1.0);
  // A hair before the screen.
  gl_Position.z = gl_Position.w * 0.999999;
}
