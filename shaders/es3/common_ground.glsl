// A point flattened on the ground, and the channel of its shadow: 0 along the light, 1 straight down, 2 to where a wet ground
// mirrors it.
vec4 onGround(vec3 world, int way, out vec3 shadow) {
  vec2 spot = world.xz;
  shadow = vec3(0.0, 1.0, 0.0);
  float height = world.y - groundHeight;
  if (way == 0) {
    spot -= lightWorld.xz * (height / max(lightWorld.y, 0.15));
    shadow = vec3(1.0, 0.0, 0.0);
  } else if (way == 2) {
    vec3 eyeWorld = (worldFromModel * vec4(eye.xyz, 1.0)).xyz;
    spot = mix(spot, eyeWorld.xz, height / (height + eyeWorld.y - groundHeight));
    shadow = vec3(0.0, 0.0, 1.0);
  }
  return vec4((spot - groundCentre) / groundHalfSide, 0.0, 1.0);
}
