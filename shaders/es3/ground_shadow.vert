// The model, or the ball, flattened on the ground: the first instance along the light, the second straight down, the third to
// where a wet ground mirrors it.
#include "common.glsl"
#include "common_ground.glsl"
#ifdef BALL
#include "common_ball.glsl"
#else
layout(location = FUR_POSITION) in vec3 position;
layout(location = FUR_NORMAL) in vec3 normal;
#endif
out vec4 vShadow;
void main() {
#ifdef BALL
  vec3 world = ballCentre.xyz + ballNormal(gl_VertexID) * ballRadius;
#else
  // Fur is part of what casts the shadow; its thin outer part lets light through, and more of it comes in under that from all around.
  vec3 world = (worldFromModel * vec4(position + normal * ((gl_InstanceID == 1 ? 0.25 : 0.6) * furLength), 1.0)).xyz;
#endif
  gl_Position = onGround(world, gl_InstanceID, vShadow);
}
