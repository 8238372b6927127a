#include "common.glsl"
#include "common_furshadow.glsl"

layout(location = FUR_POSITION) in vec3 position;
layout(location = FUR_NORMAL) in vec3 normal;
layout(location = FUR_UV_ATLAS) in vec4 uvAtlas;
layout(location = FUR_GRAD_S) in vec3 gradS;
layout(location = FUR_LEAN) in vec2 leaning;
layout(location = FUR_OTHER_UV) in vec2 otherUv;

out vec3 vPosition;
out vec3 vNormal;
out vec4 vUv;  // zw: the others
out vec3 vLightSpace;

void main() {
  gl_Position = clipFromModel * vec4(position, 1.0);
  vPosition = position;
  // Of the face itself: `normal` is where fur would grow, which leans over hard edges.
  vec3 axisS = normalize(gradS + vec3(1e-8, 0.0, 0.0));
  vNormal = normal * sqrt(max(1.0 - dot(leaning, leaning), 0.0)) + axisS * leaning.x + cross(normal, axisS) * leaning.y;
  vUv = vec4(uvAtlas.xy, otherUv);
  vLightSpace = lightSpace(position + shadowOffset(normal));
}
