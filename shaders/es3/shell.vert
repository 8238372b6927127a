// Shells: usually one, the coat's outside. Of K (Frame::shellCount) instance i stands at the height 1 - i / K, and the
// fragment shader marches from there to the skin along the view ray. Where the ray goes in the
// coat's own space, tile coordinates and height, comes from here as two parabolas: worked out per fragment
// from derivatives it costs four times as much and breaks at uv seams.
#include "common.glsl"
#include "common_bend.glsl"

layout(location = FUR_POSITION) in vec4 positionFrom;
layout(location = FUR_NORMAL) in vec4 normalTo;
layout(location = FUR_UV_ATLAS) in vec4 uvAtlas;
layout(location = FUR_FUR_COORD) in vec4 furCurvature;
layout(location = FUR_GRAD_S) in vec4 gradSCurvature;
layout(location = FUR_GRAD_T) in vec3 gradT;
layout(location = FUR_ATLAS_FROM_FUR) in vec4 atlasFromFur;
layout(location = FUR_LEAN) in vec2 leaning;

// A point x fur lengths down the ray is at the height h = top + x (path.x + x path.y), over the tile
// coordinates tile + x (step + x turn) + lean (top^2 - h^2).
out vec4 vTile;       // xy: tile  zw: step
out vec4 vTurn;       // xy: turn  zw: lean
out vec4 vPath;       // xy: path  zw: how the normal turns along the ray, a fur length
out vec4 vLight;      // xyz: light in the surface's frame  w: mip level
out vec4 vView;       // xyz: eye in the surface's frame  w: N.up
out vec4 vLean;       // xy: sideways part of the tip's tangent for h = 1  zw: model uv
out vec2 vLightStep;  // tile step towards the light for one fur length of height
#ifdef WET
layout(location = FUR_AROUND) in vec4 around;
#include "common_clump.glsl"
uniform sampler2D mask;
out float vTop;
out vec3 vTileOfFur;  // tiles that a fur length covers: along axisS (x, y), along axisT (0, z)
#else
flat out float vTop;  // the shell's height, 0..1
#endif
out vec2 vStrands;    // the strands shown: from, to; not clamped
#if defined(WET) || defined(GROOMED) || defined(PAINTED)
out vec2 vAtlas;
out vec4 vAtlasStep;  // d(atlas)/d(tile), by columns
#endif
#ifdef GROOMED
out float vLength;    // of the coat here, a share of the fur length
#endif
out vec3 vLightSpace, vLightRay;  // in the fur's own shadow map: where the ray enters, and a fur length of it

void main() {
  vec3 position = positionFrom.xyz, normal = normalTo.xyz, gradS = gradSCurvature.xyz;
  vStrands = chartsOverlap > 0.5 ? vec2(positionFrom.w, normalTo.w) : vec2(-1.0, 2.0);
  vec4 groomed = bendOf(gl_VertexID);
  vec3 bend = groomed.xyz;
#if defined(VIEW_EXPLODED)
  // The middle of each share of the coat, the outermost first.
  float top = 1.0 - (float(gl_InstanceID) + 0.5) / float(FUR_EXPLODED_SHELLS);
#elif defined(VIEW_LAYER)
  float top = viewLayer;
#else
  float top = 1.0 - float(gl_InstanceID) / shellCount;
#endif
#ifdef WET
  // As far down as fur stands from here to the next vertices: rays that came to it from higher up would come past where the
  // body turns away, and hang there. Clumps stand beside dry fur, so they are as high as the driest near them; near a hard edge,
  // where it all turns away, as on average (around.w).
  float sheets = 0.0, clumps = 0.0, fewest = 1.0, inCharts = 1e-6;
  for (int i = 0; i < 9; ++i) {
    float held = clumpAt(mask, around.xy + around.z * vec2(i % 3 - 1, i / 3 - 1)).a;
    if (held < 0.0) continue;
    float sheet = sheetOf(held), clump = min(held, 1.0) * (1.0 - sheet);
    sheets += sheet;
    clumps += clump;
    fewest = min(fewest, mix(clump, 1.0, sheet));
    inCharts += 1.0;
  }
  sheets /= inCharts;
  clumps = mix(min(fewest, 1.0 - sheets), clumps / inCharts, around.w);
#ifdef VIEW_LAYER
  clumps = 0.0;  // a layer is where it is said to be
#endif
  top *= 1.0 - FUR_SHEET_SINKS * sheets - FUR_CLUMPS_SINK * clumps;
#endif
  // In a crease the coat ends before its strands would cross those of the other side.
  mat2 S = mat2(furCurvature.z, furCurvature.w, furCurvature.w, gradSCurvature.w);
  float meanS = 0.5 * (S[0][0] + S[1][1]), apart = 0.5 * (S[0][0] - S[1][1]);
  float hollow = sqrt(apart * apart + S[0][1] * S[0][1]) - meanS;
  float len = max(min(furLength * groomed.w, 0.65 / max(hollow, 1e-6)), 1e-4);
  vTop = top;
  vec3 p = strandPoint(position, normal, bend, top, len);
#ifdef VIEW_EXPLODED
  // Each ends further to the left than the one below it, so that all can be seen.
  float shell = float(FUR_EXPLODED_SHELLS - gl_InstanceID);
  vec3 right = normalize(cross(up.xyz, eye.xyz) + vec3(1e-4, 0.0, 0.0));
  float beforeEnd = 0.85 - 1.4 * shell / float(FUR_EXPLODED_SHELLS) - dot(position, right);
  vStrands = vec2(-1.0, beforeEnd * 700.0 / length(eye.xyz - position));
  p += normal * (FUR_EXPLODED_GAP * shell);
#endif
  gl_Position = clipFromModel * vec4(p, 1.0);
  vLightSpace = lightSpace(p);

  vec3 ray = p - eye.xyz;
  float distance = length(ray);
  ray /= distance;
  vLightRay = lightSpace(p + ray * len) - vLightSpace;
  vec3 axisS = normalize(gradS + vec3(1e-8, 0.0, 0.0));
  vec3 axisT = cross(normal, axisS);
  mat2 tileFromAxes = tilesPerUnit * mat2(dot(gradS, axisS), dot(gradT, axisS), dot(gradS, axisT), dot(gradT, axisT));

  // A bent coat is lower: arc.x of its length; and its strands stand arc.y h^2 aside.
  float theta = length(bend);
  vec2 arc = arcBend(theta, 1.0);
  vec2 aside = theta > 1e-5 ? vec2(dot(axisS, bend), dot(axisT, bend)) * (arc.y / theta) : vec2(0.0);
  // Above a curved skin the same way covers less of it: (I + z S)^-1. In a crease it would cover all of it.
  float z = len * arc.x * top;
  mat2 A = inverse(mat2(1.0) + z * S);
  float down = dot(ray, normal);
  vec2 along = vec2(dot(axisS, ray), dot(axisT, ray));
  vec2 foot = A * along, turning = S * foot;
  // Height of the ray: falls with the slope, rises with the curvature, and falls with the skin where fur leans over it;
  // foot of the ray: see render/README.md.
  vec2 path = vec2(down + dot(leaning, foot), 0.5 * len * dot(along, turning));
  // Away from a hard edge normals turn no further than to the face's: there the ray goes on down.
  float inwards = dot(leaning, along), more = inwards + down * sqrt(max(1.0 - dot(leaning, leaning), 0.0)) - path.x;
  float sinks = -path.x - 0.5 * more;
  if (inwards > 0.0 && sinks > 0.0) path.y = min(path.y, 0.5 * max(more, 0.0) * sinks);
  vPath = vec4(path / arc.x, turning * len);
  vec2 stride = tileFromAxes * (len * foot), turn = tileFromAxes * (A * turning * (-down * len * len));
  vTile = vec4(furCurvature.xy * tilesPerUnit, stride);
  vTurn = vec4(turn, tileFromAxes * (A * aside * len));
#ifdef WET
  vTileOfFur = len * vec3(tileFromAxes[0], tileFromAxes[1].y);
#endif

  float texelsPerPixel = distance / pixelsPerUnit * tilesPerUnit * length(gradS) * tileTexels;
  vec3 toLight = light.xyz, toEye = -ray;
  vLight = vec4(dot(axisS, toLight), dot(axisT, toLight), dot(normal, toLight), log2(texelsPerPixel));
  vView = vec4(dot(axisS, toEye), dot(axisT, toEye), dot(normal, toEye), dot(normal, up.xyz));
  vLean = vec4(2.0 * aside, uvAtlas.xy);
  vec3 lightSlide = toLight * (len / max(dot(normal, toLight), 0.35));
  lightSlide -= normal * dot(normal, lightSlide);
  vLightStep = tilesPerUnit * vec2(dot(gradS, lightSlide), dot(gradT, lightSlide));
#ifdef GROOMED
  vLength = groomed.w;
#endif
#if defined(WET) || defined(GROOMED) || defined(PAINTED)
  vAtlas = uvAtlas.zw;
  vAtlasStep = atlasFromFur / tilesPerUnit;
#endif
}
