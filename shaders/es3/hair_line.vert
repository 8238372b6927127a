// A line with round ends that faces the eye, of a width in pixels: an instance a line. A dot where both ends are the same.
#include "common.glsl"
#include "shared/Hair.h"
layout(location = FUR_LINE_FROM) in vec4 from;
layout(location = FUR_LINE_TO) in vec4 to;
layout(location = FUR_LINE_COLOR) in vec4 color;

out vec3 vPlace;  // pixels across it, along it from its first end, and how long it is
flat out vec4 vColor;
flat out float vRadius;

void main() {
  float lift = to.w;
  vec3 middle = 0.5 * (from.xyz + to.xyz), toMiddle = normalize(eye.xyz - middle), way = to.xyz - from.xyz;
  // Across and along as the eye sees them.
  vec3 along = way - toMiddle * dot(way, toMiddle);
  float seen = length(along);
  along = seen > 1e-6 ? along / seen : normalize(cross(toMiddle, abs(toMiddle.y) < 0.9 ? vec3(0.0, 1.0, 0.0) : vec3(1.0, 0.0, 0.0)));
  vec3 side = cross(along, toMiddle), end = (gl_VertexID & 2) == 0 ? from.xyz : to.xyz;
  vec3 toEye = eye.xyz - end;
  float away = length(toEye), pixel = away / pixelsPerUnit, reach = 0.5 * from.w + 1.0;
  vec2 corner = vec2(gl_VertexID & 1, gl_VertexID >> 1) * 2.0 - 1.0;
  vec4 clip = clipFromModel * vec4(end + (side * corner.x + along * corner.y) * (reach * pixel), 1.0);
  // Its depth as if it were nearer.
  vec4 nearer = clipFromModel * vec4(end + toEye * (min(lift, 0.5 * away) / away), 1.0);
  gl_Position = vec4(clip.xy, nearer.z / nearer.w * clip.w, clip.w);
  float len = seen * pixelsPerUnit / length(eye.xyz - middle);
  vPlace = vec3(reach * corner.x, corner.y < 0.0 ? -reach : len + reach, len);
  vColor = color;
  vRadius = 0.5 * from.w;
}
