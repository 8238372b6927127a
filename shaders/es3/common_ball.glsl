// The ball that is pressed into the fur, made of vertex numbers: six to a quad of longitude and latitude.
vec3 ballNormal(int vertex) {
  int quad = vertex / 6, corner = vertex % 6;
  ivec2 at = ivec2(quad % FUR_BALL_AROUND, quad / FUR_BALL_AROUND);
  at += ivec2(corner == 1 || corner == 2 || corner == 4 ? 1 : 0, corner == 0 || corner == 1 || corner == 3 ? 1 : 0);
  vec2 angle = vec2(at) * vec2(6.2831853 / float(FUR_BALL_AROUND), 3.1415927 / float(FUR_BALL_DOWN));
  return vec3(sin(angle.x) * sin(angle.y), cos(angle.y), cos(angle.x) * sin(angle.y));
}
