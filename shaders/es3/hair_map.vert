// The skin with a picture over its atlas.
#include "common.glsl"
layout(location = FUR_POSITION) in vec3 position;
layout(location = FUR_NORMAL) in vec3 normal;
layout(location = FUR_UV_ATLAS) in vec4 uvAtlas;
out vec3 vNormal;
out vec2 vAtlas;

void main() {
  gl_Position = clipFromModel * vec4(position, 1.0);
  vNormal = normal;
  vAtlas = uvAtlas.zw;
}
