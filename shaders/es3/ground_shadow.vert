// The model flattened on the ground: along the light (CHANNEL 0) or straight down (1).
#include "common.glsl"
layout(location = FUR_POSITION) in vec3 position;
layout(location = FUR_NORMAL) in vec3 normal;
void main() {
  // Fur is part of what casts the shadow; its thin outer part lets light through.
  vec3 world = (worldFromModel * vec4(position + normal * (0.6 * shape.x), 1.0)).xyz;
#ifdef STRAIGHT_DOWN
  vec2 spot = world.xz;
#else
  vec2 spot = world.xz - lightWorld.xz * ((world.y - groundPlane.x) / max(lightWorld.y, 0.15));
#endif
  gl_Position = vec4((spot - groundCentre.xy) / groundPlane.y, 0.0, 1.0);
}
