// The model, or the ball, flattened on the ground: the first instance along the light, the second straight down, the third to
// where a wet ground mirrors it.
#include "common.glsl"
#ifdef BALL
#include "common_ball.glsl"
#else
layout(location = FUR_POSITION) in vec3 position;
layout(location = FUR_NORMAL) in vec3 normal;
#endif
flat out vec3 vShadow;
void main() {
#ifdef BALL
  vec3 world = ballCentre.xyz + ballNormal(gl_VertexID) * ballRadius;
#else
  // Fur is part of what casts the shadow; its thin outer part lets light through.
  vec3 world = (worldFromModel * vec4(position + normal * (0.6 * furLength), 1.0)).xyz;
#endif
  vec2 spot = world.xz;
  vShadow = vec3(0.0, 1.0, 0.0);
  float height = world.y - groundHeight;
  if (gl_InstanceID == 0) {
    spot -= lightWorld.xz * (height / max(lightWorld.y, 0.15));
    vShadow = vec3(1.0, 0.0, 0.0);
  } else if (gl_InstanceID == 2) {
    vec3 eyeWorld = (worldFromModel * vec4(eye.xyz, 1.0)).xyz;
    spot = mix(spot, eyeWorld.xz, height / (height + eyeWorld.y - groundHeight));
    vShadow = vec3(0.0, 0.0, 1.0);
  }
  gl_Position = vec4((spot - groundCentre) / groundHalfSide, 0.0, 1.0);
}
