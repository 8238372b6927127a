#include "common.glsl"
#include "common_bend.glsl"
#include "common_shading.glsl"
#include "common_furshadow.glsl"
#ifdef TYPES
#include "common_types.glsl"
#endif

layout(location = FUR_POSITION) in vec3 position;
layout(location = FUR_NORMAL) in vec3 normal;
layout(location = FUR_UV_ATLAS) in vec4 uvAtlas;

out vec3 vNormal;
out vec4 vUvAtlas;
out vec3 vColor;  // under fur: its light, without the model's picture
#if defined(PAINTED) || (defined(TEXTURED) && defined(TYPES))
out vec3 vShade;  // of that, without the skin's colour
#endif
#ifdef GROOMED
out vec3 vBare;   // the same where no fur grows
#endif
out vec3 vLightSpace;

void main() {
  gl_Position = clipFromModel * vec4(position, 1.0);
  vNormal = normal;
  vLightSpace = lightSpace(position + shadowOffset(normal));
  vUvAtlas = uvAtlas;
  // Shells show the skin themselves where a ray reaches it. This one is seen where a ray has left the coat of one
  // part of the body and goes on deep in that of another: there it stands for the strands that are missing.
  float nDotL = dot(normal, light.xyz), upness = dot(normal, up.xyz);
  vec3 strands = rootColors[0].rgb + tipColors[0].rgb;
#ifdef VIEW_SHADOW
  float furry = bendOf(gl_VertexID).w;
  vColor = vec3(lightShare(furShadowAt(vLightSpace), 1.0, nDotL));
#ifdef UNDER_FUR
  float under = lightShare(furShadowAt(lightSpace(position + normal * (0.3 * furLength))), 0.3, nDotL);
  vColor = mix(vColor, vec3(under), min(furry / 0.15, 1.0));
#endif
  return;
#endif
#ifdef TYPES
  vec4 grows = presences(textureLod(groom, uvAtlas.zw, 0.0).gba);
  strands *= grows.x;
  for (int type = 1; type < FUR_TYPES; ++type) strands += grows[type] * (rootColors[type].rgb + tipColors[type].rgb);
  showShares(grows);
  vec3 skin = skinColorOf(grows);
#else
  vec3 skin = skinColors[0].rgb;
#endif
#ifdef CLASSIC
  // What is seen between strands, as the march has it (shell.frag).
  const float h = 0.0;
  vec3 albedo = 0.5 * skin;
#else
  const float h = 0.3;
  vec3 albedo = mix(skin, 0.5 * strands, min(2.0 * densityShown(), 1.0));
#endif
  vec3 shade = shadeSkin(vec3(1.0), nDotL, upness, h, 0.0, furShadowAt(lightSpace(position + normal * (0.3 * furLength))));
  vColor = shade * albedo;
#if defined(PAINTED) || (defined(TEXTURED) && defined(TYPES))
  vShade = shade;
#endif
#ifdef GROOMED
  vBare = bareSkin(vec3(1.0), nDotL, upness, 0.0, furShadowAt(vLightSpace));
#endif
}
