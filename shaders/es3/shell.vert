// Shells: usually one, the coat's outside, or some below it as well (Frame::shellCount). The fragment shader marches from
// there to the skin along the view ray. Where the ray goes in the coat's own space, tile coordinates and height, comes from
// here as two parabolas: worked out per fragment from derivatives it costs four times as much and breaks at uv seams.
#include "common.glsl"
#include "common_bend.glsl"

layout(location = FUR_POSITION) in vec4 positionCurvature;
layout(location = FUR_NORMAL) in vec4 normalCurvature;
layout(location = FUR_UV_ATLAS) in vec4 uvAtlas;
layout(location = FUR_FUR_COORD) in vec4 furStrands;
layout(location = FUR_GRAD_S) in vec4 gradSCurvature;
layout(location = FUR_GRAD_T) in vec3 gradT;
layout(location = FUR_ATLAS_FROM_FUR) in vec4 atlasFromFur;
layout(location = FUR_LEAN) in vec3 leanRoom;
layout(location = FUR_HESSIAN_S) in vec3 hessianS;
layout(location = FUR_HESSIAN_T) in vec3 hessianT;

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
out vec2 vUp;         // upwards in the surface's frame; N.up: vView.w
out vec4 vTileOfFur;  // tiles that a fur length covers: along axisS (x, y), along axisT (0, z); mip levels that the chart's stretch adds
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

const float kShellsApart = 1.0 / 3.0;  // the second at half the height let one see into the coat between breast and foreleg
// Where the shell stands, a share of the coat's height.
float shellHeight() {
#if defined(VIEW_EXPLODED)
  // The middle of each share of the coat, the outermost first.
  return 1.0 - (float(gl_InstanceID) + 0.5) / float(FUR_EXPLODED_SHELLS);
#elif defined(VIEW_LAYER)
  return viewLayer;
#else
  return 1.0 - kShellsApart * float(gl_InstanceID);
#endif
}

#ifdef WET
// The share of its height that the coat keeps. By the wetness around the vertex, not only at it: rays from a shell that is higher
// than the fur would miss the outline, and pieces of fur would hang in the air. Clumps stand beside dry fur: they are as high as
// the driest fur around them; near a hard edge as high as on average (around.w).
float wetHeight(float coat, float aside) {
  float shortness = shortnessOf(coat), sheets = 0.0, clumps = 0.0, fewest = 1.0, inCharts = 1e-6;
  for (int i = 0; i < 9; ++i) {
    float held = clumpAt(mask, around.xy + around.z * vec2(i % 3 - 1, i / 3 - 1)).a;
    if (held < 0.0) continue;
    float sheet = sheetOf(held, shortness), clump = min(held, 1.0) * (1.0 - sheet);
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
  float top = 1.0 - FUR_SHEET_SINKS * sheets - FUR_CLUMPS_SINK * clumps;
  return wetTop(top, aside, wetLean(vec2(aside, 0.0), clumps, sheets).x, sheets);
}
#endif

#ifdef VIEW_EXPLODED
// Moves a shell off the one below it. Each ends further to the left than that one, so that all can be seen.
vec3 moveShell(vec3 position, vec3 normal) {
  float shell = float(FUR_EXPLODED_SHELLS - gl_InstanceID);
  vec3 right = normalize(cross(up.xyz, eye.xyz) + vec3(1e-4, 0.0, 0.0));
  float beforeEnd = 0.85 - 1.4 * shell / float(FUR_EXPLODED_SHELLS) - dot(position, right);
  vStrands = vec2(-1.0, beforeEnd * 700.0 / length(eye.xyz - position));
  return normal * (FUR_EXPLODED_GAP * shell);
}
#endif

#include "shell_skin.glsl"

// How fast a ray of that slope gets away from the skin again, at the height z over it. Where the skin is a circle under the ray, of
// the radius r at that height, the ray's height is sqrt((r - slope x)^2 + (round x)^2) - r + z: near its outline the parabola takes
// the lowest of that. By the second derivative at its start alone rays met the skin of thin parts, as ears, where they come past
// them: ears were three times as thick, ended at the polygons of the coat's outside, and had no strands there. No skin counts as
// rounder than 0.75 of the coat's length: on ridges, which go on behind, there were holes. What is four lengths round stays as it is.
float bentBack(vec2 way, vec2 turning, float slope, float z, float coat) {
  float bent = dot(way, turning), turned = length(turning);
  if (bent < 1e-4 || slope <= 0.0) return bent;
  float curvature = min(turned * turned / bent, 1.0 / (z + 0.75 * coat)), round = bent / turned, whole = length(vec2(slope, round));
  // How far from the circle's middle the ray comes past, of the radius of the skin.
  float skin = 1.0 / curvature - z, past = round / (whole * curvature * skin);
  float thin = clamp(2.0 - 0.5 * skin / max(coat, 1e-4), 0.0, 1.0);
  return mix(bent, 0.5 * curvature * whole * (whole + round), thin * smoothstep(0.5, 1.0, past));
}

// The curvature of the skin as terms for strands that lie take it, at the height z: they are linear in it. Bent inwards by more than so
// much of 1 / z tips turned round like hooks in creases; outwards rays went out of the coat over ridges, where sky showed.
mat2 boundedCurvature(mat2 curvature, float z) {
  const float kMostInwards = 0.15, kMostOutwards = 0.5;
  vec2 halves = 0.5 * vec2(curvature[0].x + curvature[1].y, curvature[0].x - curvature[1].y);
  float apart = length(vec2(halves.y, curvature[0].y));
  vec2 most = vec2(kMostInwards, kMostOutwards) / max(z * vec2(apart - halves.x, apart + halves.x), 1e-4);
  float share = min(1.0, min(most.x, most.y));
  return curvature * (share * share);
}

// The ray's way through the coat from the height `top`, as two parabolas.
void castRay(Skin skin, vec3 ray, vec3 bend, float top) {
  float len = skin.coat;
  vec2 leaning = leanRoom.xy;
  // A bent coat is lower: arc.x of its length; and its strands stand arc.y h^2 aside.
  float theta = length(bend);
  vec2 arc = arcBend(theta, 1.0);
  vec2 aside = theta > 1e-5 ? along(skin, bend) * (arc.y / theta) : vec2(0.0);
  // Above a curved skin the same way covers less of it: (I + z S)^-1. In a crease it would cover all of it.
  float z = len * arc.x * top;
  mat2 A = inverse(mat2(1.0) + z * skin.curvature);
  float down = dot(ray, skin.normal);
  vec2 way = along(skin, ray);
  vec2 foot = A * way, turning = skin.curvature * foot;
  // Height of the ray: falls with the slope, rises with the curvature, and falls with the skin where fur leans over it;
  // foot of the ray: see render/README.md.
  vec2 path = vec2(down + dot(leaning, foot), 0.5 * len * bentBack(way, turning, -down - dot(leaning, foot), z, len));
  // Near a hard edge normals lean by `leaning` off the face's. On the way to the middle of the face they turn to the face's and no
  // further, and the ray goes on down from there: its curvature is limited so that it still comes to the skin.
  float inwards = dot(leaning, way), onFace = inwards + down * sqrt(max(1.0 - dot(leaning, leaning), 0.0));
  float more = onFace - path.x, descent = -path.x - 0.5 * more;
  if (inwards > 0.0 && descent > 0.0) path.y = min(path.y, 0.5 * max(more, 0.0) * descent);
  // Strands that lie leave a skin that turns away under them: heights along them are not those over it, and where the ray meets them
  // they root elsewhere than under it.
  mat2 bounded = boundedCurvature(skin.curvature, z);
  vec2 lies = A * aside, lying = bounded * lies;
  path.x += len * top * top * dot(lying, way);
  path /= max(arc.x + 2.0 * len * top * top * top * dot(aside, lying), 0.5 * arc.x);
  vec2 root = foot - lies * (2.0 * top * path.x);
  vec2 rootTurning = bounded * root;
  vPath = vec4(path, len * rootTurning);
  vec2 stride = skin.tileFromAxes * (len * foot);
  vec2 turn = skin.tileFromAxes * (A * rootTurning * (-0.5 * len * len * (down + arc.x * path.x)));
  // The tile's coordinates change faster in some places of a chart than in others.
  vec3 squares = vec3(root.x * root.x, 2.0 * root.x * root.y, root.y * root.y);
  turn += 0.5 * tilesPerUnit * len * len * vec2(dot(hessianS, squares), dot(hessianT, squares));
  vTile = vec4(furStrands.xy * tilesPerUnit, stride);
  vTurn = vec4(turn, skin.tileFromAxes * (len * lies));
  vLean = vec4(2.0 * aside, uvAtlas.xy);
#ifdef WET
  vTileOfFur = vec4(len * vec3(skin.tileFromAxes[0], skin.tileFromAxes[1].y), log2(length(gradSCurvature.xyz)));
#endif
}

void lightRay(Skin skin, vec3 toEye, float distance) {
  vec3 toLight = light.xyz;
  float texelsPerPixel = distance / pixelsPerUnit * tilesPerUnit * length(gradSCurvature.xyz) * tileTexels;
  vLight = vec4(inFrame(skin, toLight), log2(texelsPerPixel));
  vec3 upwards = inFrame(skin, up.xyz);
  vView = vec4(inFrame(skin, toEye), upwards.z);
#ifdef WET
  vUp = upwards.xy;
#endif
  vec3 slide = toLight * (skin.coat / max(dot(skin.normal, toLight), 0.35));
  slide -= skin.normal * dot(skin.normal, slide);
  vLightStep = tilesPerUnit * vec2(dot(gradSCurvature.xyz, slide), dot(gradT, slide));
}

void main() {
  vStrands = chartsOverlap > 0.5 ? furStrands.zw : vec2(-1.0, 2.0);
  vec4 groomed = bendOf(gl_VertexID);
  vTop = shellHeight();
#ifdef WET
  vTop *= wetHeight(furLength * groomed.w, arcBend(length(groomed.xyz), 1.0).y);
#endif
  Skin skin = skinAtVertex(groomed.w);
  vec3 p = strandPoint(positionCurvature.xyz, skin.normal, groomed.xyz, vTop, skin.coat);
#ifdef VIEW_EXPLODED
  p += moveShell(positionCurvature.xyz, skin.normal);
#endif
  gl_Position = clipFromModel * vec4(p, 1.0);
  vLightSpace = lightSpace(p);

  vec3 ray = p - eye.xyz;
  float distance = length(ray);
  ray /= distance;
  vLightRay = lightSpace(p + ray * skin.coat) - vLightSpace;
  castRay(skin, ray, groomed.xyz, vTop);
  lightRay(skin, -ray, distance);
#ifdef GROOMED
  vLength = groomed.w;
#endif
#if defined(WET) || defined(GROOMED) || defined(PAINTED)
  vAtlas = uvAtlas.zw;
  vAtlasStep = atlasFromFur / tilesPerUnit;
#endif
}
