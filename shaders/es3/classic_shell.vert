// The technique `shells` (Lengyel et al. 2001; Sheppard 2004, 3.2.1): the coat's layers as shells, inner to outer.
// Of N instance i stands at the height (i + 1) / N.
#include "common.glsl"
#include "common_bend.glsl"
#include "common_shading.glsl"
#include "common_clump.glsl"
#include "common_furshadow.glsl"
#include "common_classic.glsl"
#ifdef TYPES
#include "common_types.glsl"
#endif

layout(location = FUR_POSITION) in vec4 positionCurvature;
layout(location = FUR_NORMAL) in vec4 normalCurvature;
layout(location = FUR_UV_ATLAS) in vec4 uvAtlas;
layout(location = FUR_FUR_COORD) in vec4 furStrands;
layout(location = FUR_GRAD_S) in vec4 gradSCurvature;
layout(location = FUR_GRAD_T) in vec3 gradT;
layout(location = FUR_ATLAS_FROM_FUR) in vec4 atlasFromFur;
layout(location = FUR_LEAN) in vec3 leanRoom;

out vec4 vTile;   // xy: tile  z: mip level, rounded down  w: pixels that a texel covers, 1 at least
flat out vec2 vShell;  // x: height  y: layer of its texture
out vec3 vLight;  // in the surface's frame
out vec4 vView;   // xyz: eye in the surface's frame  w: share of the light that the fur's shadow leaves
out vec4 vAround; // both as LightOfShell has them
out vec2 vGlint;
out vec3 vUp;    // upwards in the surface's frame
out vec4 vLean;   // xy: sideways part of the strand's tangent  zw: model uv
#ifdef WET
out vec2 vTip;        // how far aside the tip is, fur lengths
out vec3 vTileOfFur;  // tiles that a fur length covers: along axisS (x, y), along axisT (0, z)
#endif
#if defined(WET) || defined(GROOMED) || defined(PAINTED)
out vec2 vAtlas;
out vec4 vAtlasStep;  // d(atlas)/d(tile), by columns
#endif
#ifdef GROOMED
out float vLength;    // of the coat here, a share of the fur length
#endif

#include "shell_skin.glsl"

void main() {
  vec4 groomed = bendOf(gl_VertexID);
  Skin skin = skinAtVertex(groomed.w);
  float shell = float(gl_InstanceID), h = (shell + 1.0) / layers, theta = length(groomed.xyz);
  vec3 p = strandPoint(positionCurvature.xyz, skin.normal, groomed.xyz, h, skin.coat);
  gl_Position = clipFromModel * vec4(p, 1.0);

  vec3 toEye = eye.xyz - p;
  float distance = length(toEye), texelsPerPixel = distance / pixelsPerUnit * tilesPerUnit * length(gradSCurvature.xyz) * tileTexels;
  // Of a mip level between two, some shells show the one and some the other.
  float level = log2(texelsPerPixel) - 0.5 + fract(0.618 * shell);
  vTile = vec4(furStrands.xy * tilesPerUnit, max(level, 0.0), max(1.0 / texelsPerPixel, 1.0));
  vShell = vec2(h, floor((shell + 0.5) / layers * storedLayers));
  vLight = inFrame(skin, light.xyz);
  vUp = inFrame(skin, up.xyz);
  vView = vec4(inFrame(skin, toEye / distance), furShadowAt(lightSpace(p)));
#ifdef TYPES
  showShares(presences(textureLod(groom, uvAtlas.zw, 0.0).gba));
#endif
  LightOfShell lit = lightOfShell(vLight, vView.xyz, h, vView.w, vUp.z);
  vAround = lit.around;
  vGlint = lit.glint;
  vec2 sideways = theta > 1e-5 ? along(skin, groomed.xyz) / theta : vec2(0.0);
  vLean = vec4(sideways * arcTangent(theta, h).y, uvAtlas.xy);
#ifdef WET
  vTip = sideways * arcBend(theta, 1.0).y;
  vTileOfFur = skin.coat * vec3(skin.tileFromAxes[0], skin.tileFromAxes[1].y);
#endif
#ifdef GROOMED
  vLength = groomed.w;
#endif
#if defined(WET) || defined(GROOMED) || defined(PAINTED)
  vAtlas = uvAtlas.zw;
  vAtlasStep = atlasFromFur / tilesPerUnit;
#endif
}
