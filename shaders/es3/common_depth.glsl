// The fragment's depth in two bytes, twice: the colour mask tells of what.
vec4 packedDepth() {
  float steps = clamp(gl_FragCoord.z, 0.0, 1.0) * 255.0;
  vec2 depth = vec2(floor(steps) / 255.0, fract(steps));
  return vec4(depth, depth);
}
