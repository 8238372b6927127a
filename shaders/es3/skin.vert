#include "common.glsl"

layout(location = FUR_POSITION) in vec3 position;
layout(location = FUR_NORMAL) in vec3 normal;
layout(location = FUR_UV_ATLAS) in vec4 uvAtlas;
layout(location = FUR_FUR_COORD) in vec2 furCoord;

out vec3 vNormal;
out vec4 vUvAtlas;
out vec2 vTile;

void main() {
  gl_Position = clipFromModel * vec4(position, 1.0);
  vNormal = normal;
  vUvAtlas = uvAtlas;
  vTile = furCoord * shape.y;
}
