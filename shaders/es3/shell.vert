// Slabs of fur. Instance i holds layers [i K, (i + 1) K); its triangles lie at the slab's top and the
// fragment shader marches down through it. The step per layer in tile coordinates comes from here:
// worked out per fragment from derivatives it costs four times as much and breaks at uv seams.
#include "common.glsl"

layout(location = FUR_POSITION) in vec4 positionFrom;
layout(location = FUR_NORMAL) in vec4 normalTo;
layout(location = FUR_UV_ATLAS) in vec4 uvAtlas;
layout(location = FUR_FUR_COORD) in vec2 furCoord;
layout(location = FUR_GRAD_S) in vec3 gradS;
layout(location = FUR_GRAD_T) in vec3 gradT;
layout(location = FUR_ATLAS_FROM_FUR) in vec4 atlasFromFur;

uniform sampler2D bends;

out vec4 vTile;       // xy: tile coordinates at the slab's top  zw: step a layer down along the view ray
out vec4 vLight;      // xyz: light in the surface's frame  w: mip level
out vec4 vView;       // xyz: eye in the surface's frame  w: N.up
out vec4 vLean;       // xy: sideways part of the bent strand's tangent  zw: model uv
out vec2 vLightStep;  // tile step towards the light for one fur length of height
flat out float vTop;  // layer count up to the slab's top
out float vSubSteps;  // steps a layer: more where the ray is shallow
out vec2 vStrands;    // the strands shown: from, to; not clamped
#ifdef WET
out vec2 vAtlas;
out vec4 vAtlasStep;  // d(atlas)/d(tile), by columns
#endif

void main() {
  vec3 position = positionFrom.xyz, normal = normalTo.xyz;
  vStrands = vec2(positionFrom.w, normalTo.w);
  vec3 bend = texelFetch(bends, ivec2(gl_VertexID % FUR_BEND_ROW, gl_VertexID / FUR_BEND_ROW), 0).xyz;
  vTop = float(gl_InstanceID + 1) * shape.w;
  float h = vTop / shape.z, below = max(h - 1.0 / shape.z, 0.0);
  vec3 p = strandPoint(position, normal, bend, h);
  vec3 strandStep = strandPoint(position, normal, bend, below) - p;
  gl_Position = clipFromModel * vec4(p, 1.0);

  // One layer down along the view ray, less what the strand itself moves on the way.
  vec3 ray = p - eye.xyz;
  float distance = length(ray);
  ray /= distance;
  // Grazing rays would step for ever: at 0.15 (81 degrees) the next slab and the fins take over.
  vec3 rayStep = ray * (dot(strandStep, normal) / min(dot(ray, normal), -0.15));
  rayStep = ray * (-dot(strandStep, normal) / max(-dot(ray, normal), 0.15));
  vec3 slide = rayStep - strandStep;
  vec2 step = shape.y * vec2(dot(gradS, slide), dot(gradT, slide));
  float stepLength = length(step);
  // A torn or squeezed triangle can have huge gradients; a twentieth of a tile per layer is plenty.
  step *= min(1.0, 0.05 / max(stepLength, 1e-6));
  vTile = vec4(furCoord * shape.y, step);

  vec3 axisS = normalize(gradS + vec3(1e-8, 0.0, 0.0));
  vec3 axisT = cross(normal, axisS) * (dot(cross(normal, gradS), gradT) < 0.0 ? -1.0 : 1.0);
  vec3 toLight = light.xyz, toEye = -ray;
  float texelsPerPixel = distance / eye.w * shape.y * length(gradS) * volume.x;
  // A step longer than a strand is wide would cut it into discs, where a pixel can show them.
  vSubSteps = clamp(min(stepLength, 0.05) * volume.x / max(4.0, 2.4 * texelsPerPixel), 1.0, 2.0);
  vLight = vec4(dot(axisS, toLight), dot(axisT, toLight), dot(normal, toLight), log2(texelsPerPixel));
  vView = vec4(dot(axisS, toEye), dot(axisT, toEye), dot(normal, toEye), dot(normal, up.xyz));
  vec3 lean = -strandStep * (shape.z / max(shape.x, 1e-6));
  vLean = vec4(dot(axisS, lean), dot(axisT, lean), uvAtlas.xy);
  vec3 lightSlide = toLight * (shape.x / max(dot(normal, toLight), 0.35));
  lightSlide -= normal * dot(normal, lightSlide);
  vLightStep = shape.y * vec2(dot(gradS, lightSlide), dot(gradT, lightSlide));
#ifdef WET
  vAtlas = uvAtlas.zw;
  vAtlasStep = atlasFromFur / shape.y;
#endif
}
