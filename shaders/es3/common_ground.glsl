// What stands on the ground, up to that height over it, darkens it right there, model units.
const float kContactHeight = 0.08;
// A point flattened on the ground, and the channel of its shadow: 0 along the light, 1 straight down, 2 to where a wet ground
// mirrors it. In the fourth is what is straight down and near.
vec4 onGround(vec3 world, int way, out vec4 shadow) {
  vec2 spot = world.xz;
  float height = world.y - groundHeight, touches = clamp(1.0 - height / kContactHeight, 0.0, 1.0);
  shadow = vec4(0.0, 1.0, 0.0, touches);
  if (way == 0) {
    spot -= lightWorld.xz * (height / max(lightWorld.y, 0.15));
    shadow = vec4(1.0, 0.0, 0.0, 0.0);
  } else if (way == 2) {
    vec3 eyeWorld = (worldFromModel * vec4(eye.xyz, 1.0)).xyz;
    spot = mix(spot, eyeWorld.xz, height / (height + eyeWorld.y - groundHeight));
    shadow = vec4(0.0, 0.0, 1.0, 0.0);
  }
  return vec4((spot - groundCentre) / groundHalfSide, 0.0, 1.0);
}
