// The skin under long hair, as hair that lies on it (Halen & Wester 2007, 5.8).
#include "common.glsl"
#include "common_furshadow.glsl"
#include "shared/Hair.h"
layout(location = FUR_POSITION) in vec3 position;
layout(location = FUR_NORMAL) in vec3 normal;
uniform highp sampler2D baseTangents;  // hair/BaseTangents.h

out vec3 vPosition;
out vec3 vNormal;
out vec3 vTangent;  // as long as hair lies along the skin there, 0..1
out vec3 vLightSpace;
out float vDensity;

// Twin: evenTangent() in hair/PlantGuides.cpp.
vec3 evenTangent(vec3 n) {
  vec3 turned = n.y > -0.999 ? vec3(1.0, 0.0, 0.0) - vec3(n.x, n.y + 1.0, n.z) * (n.x / (1.0 + n.y)) : vec3(1.0, 0.0, 0.0) - n * n.x;
  return normalize(turned - n * dot(turned, n));
}

void main() {
  gl_Position = clipFromModel * vec4(position, 1.0);
  vec4 way = texelFetch(baseTangents, ivec2(gl_VertexID % FUR_BASE_TANGENTS_ROW, gl_VertexID / FUR_BASE_TANGENTS_ROW), 0);
  vec2 along = 2.0 * way.xy - 1.0;
  vec3 x = evenTangent(normal);
  vPosition = position;
  vNormal = normal;
  vTangent = normalize(x * along.x + cross(normal, x) * along.y + 1e-4 * x) * max(2.0 * way.z - 1.0, 0.01);
  vLightSpace = lightSpace(position + shadowOffset(normal));
  vDensity = way.w;
}
