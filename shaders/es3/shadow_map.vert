// The coat from the light: its first surface, or the skin, or one instance a shell; or the ball.
#include "common.glsl"
#ifdef BALL
#include "common_ball.glsl"
#else
#include "common_bend.glsl"
layout(location = FUR_POSITION) in vec3 position;
layout(location = FUR_NORMAL) in vec3 normal;
layout(location = FUR_FUR_COORD) in vec2 furCoord;
#ifdef GROOMED
layout(location = FUR_UV_ATLAS) in vec4 uvAtlas;
#include "common_types.glsl"
#endif
#endif

#ifdef SHADOW_LAYERS
out vec2 vTile;
flat out float vHeight;
#ifdef TYPES
out vec4 vAlong, vGrows;  // height along the strands of each type; its presence
#endif
#endif

void main() {
#ifdef BALL
  vec3 world = ballCentre.xyz + ballNormal(gl_VertexID) * ballRadius;
  vec3 at = lightSpace((world - worldFromModel[3].xyz) * mat3(worldFromModel));
#else
#ifdef SHADOW_LAYERS
  float h = float(gl_InstanceID + 1) / float(FUR_SHADOW_SHELLS);
  vTile = furCoord * tilesPerUnit;
  vHeight = (float(gl_InstanceID) + 0.5) / float(FUR_SHADOW_SHELLS);  // the shell stands for what lies between the one below and it
#elif defined(SKIN_ONLY)
  const float h = 0.0;
#else
  float h = shadowSurface;
#endif
  vec4 groomed = bendOf(gl_VertexID);
#ifdef GROOMED
  // Vertices have room for the longest strand round them; the shadow is that of the fur that stands there.
  vec4 texel = textureLod(groom, uvAtlas.zw, 0.0);
#ifdef TYPES
  vec4 grows = presences(texel.gba) * typeGrows, high = min(2.0 * grows, 1.0) / typeRise;
  groomed.w = min(groomed.w, texel.r * max(max(high.x, high.y), max(high.z, high.w)));
#ifdef SHADOW_LAYERS
  vAlong = vHeight * groomed.w / max(texel.r, 1e-3) * typeRise;
  vGrows = grows;
#endif
#else
  groomed.w = min(groomed.w, texel.r * min(2.0 * dot(presences(texel.gba), typeGrows), 1.0));
#endif
#endif
  vec3 at = lightSpace(strandPoint(position, normal, groomed.xyz, h, furLength * groomed.w));
#endif
  gl_Position = vec4(vec3(at.xy, at.z / shadowRange) * 2.0 - 1.0, 1.0);
}
