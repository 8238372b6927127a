// What bends the fur, over the dim skin: one strip a vertex, of a part of the vertices. The bent strand beside where it
// would stand; or the force on it, as an arrow at its tip.
#include "common.glsl"
#include "common_bend.glsl"
layout(location = FUR_POSITION) in vec3 position;
layout(location = FUR_NORMAL) in vec3 normal;
out vec3 vColor;

void main() {
  vec4 shown = bendOf(gl_InstanceID);
  float size = length(shown.xyz), len = furLength * shown.w;
  int point = gl_VertexID >> 1;
  bool drawn = gl_InstanceID % (1 + textureSize(bends, 0).y / FUR_ARROW_ROWS) == 0;
#ifdef VIEW_FORCES
  // Shaft, head, point.
  drawn = drawn && size > 1e-3;
  vec3 along = shown.xyz, p = position + normal * len + along * (0.25 * (point == 0 ? 0.0 : point < 3 ? 0.6 : 1.0));
  float width = point < 2 ? 1.2 : point == 2 ? 3.6 : 0.0;
  vColor = mix(vec3(0.1, 0.5, 1.0), vec3(1.0, 0.2, 0.05), min(size, 1.0));
#else
  // From where its tip would be to the root, and from there to the tip.
  float t = max(float(point - 2), 0.0) / float(FUR_ARROW_POINTS - 3), width = point < 2 ? 0.7 : 1.2;
  vec2 slope = arcTangent(size, t);
  vec3 p = point == 0 ? position + normal * len : strandPoint(position, normal, shown.xyz, t, len);
  vec3 along = point < 2 ? normal : normal * slope.x + shown.xyz * (size > 1e-5 ? slope.y / size : 0.0);
  float warm = min(size / FUR_MAX_BEND, 1.0);
  vColor = point < 2 ? vec3(0.45) : mix(vec3(0.2, 0.85, 0.5), vec3(1.0, 0.35, 0.1), warm * (2.0 - warm));
#endif
  vec3 toEye = eye.xyz - p, side = cross(along, toEye);
  float pixel = length(toEye) / pixelsPerUnit;
  p += side * (width * (float(gl_VertexID & 1) * 2.0 - 1.0) * pixel * inversesqrt(max(dot(side, side), 1e-20)));
  gl_Position = drawn ? clipFromModel * vec4(p, 1.0) : vec4(2.0, 2.0, 2.0, 1.0);
}
