precision highp float;
precision highp int;
precision mediump sampler2DArray;
precision highp sampler2D;
#include "shared/Blocks.h"

#ifdef POLYNOMIAL
// Sheppard's tip for a force of 1 where an arc turns furthest (BendField.h windBend).
vec2 windTip(float theta) {
  float f = min(theta / FUR_MAX_BEND, 1.0);
  return vec2(1.0 - (0.04743 + 0.36726 * f) * f, (0.861986 - 0.176676 * f) * f);
}
vec2 arcBend(float theta, float t) { return vec2(t * (1.0 - t), 0.0) + t * t * windTip(theta); }
vec2 arcTangent(float theta, float t) { return vec2(1.0 - 2.0 * t, 0.0) + 2.0 * t * windTip(theta); }
#else
// Along and across of a constant-length arc that turns by theta over t = 0..1 (BendField.h arcBend).
vec2 arcBend(float theta, float t) {
  float turn = theta * t;
  if (theta < 1e-3) return vec2(t, 0.5 * turn * t);
  return vec2(sin(turn), 1.0 - cos(turn)) / theta;
}
// How both change with t.
vec2 arcTangent(float theta, float t) { return vec2(cos(theta * t), sin(theta * t)); }
#endif

// Where a strand rooted at `root` is at height h, for the bend b (model space, radians, across the normal).
vec3 strandPoint(vec3 root, vec3 normal, vec3 bend, float h, float len) {
  float theta = length(bend);
  vec2 arc = arcBend(theta, h) * len;
  return root + normal * arc.x + (theta > 1e-5 ? bend * (arc.y / theta) : vec3(0.0));
}

// Where the fur's own shadow map has a point: xy 0..1, z depth along the light.
vec3 lightSpace(vec3 positionModel) { return (lightFromModel * vec4(positionModel, 1.0)).xyz; }
