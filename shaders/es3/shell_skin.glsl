// The skin at the vertex: two unit axes in it, its normal, and the matrix of its curvature along the axes.
struct Skin {
  vec3 axisS, axisT, normal;
  mat2 curvature;
  mat2 tileFromAxes;  // tiles for a model unit along each axis
  float coat;         // length of the fur, model units
};

Skin skinAtVertex(float grown) {
  Skin skin;
  vec3 gradS = gradSCurvature.xyz;
  skin.normal = normalCurvature.xyz;
  skin.curvature = mat2(positionCurvature.w, normalCurvature.w, normalCurvature.w, gradSCurvature.w);
  // In a crease the coat ends before its strands would cross those of the other side.
  skin.coat = max(min(furLength * grown, leanRoom.z), 1e-4);
  skin.axisS = normalize(gradS + vec3(1e-8, 0.0, 0.0));
  skin.axisT = cross(skin.normal, skin.axisS);
  skin.tileFromAxes = tilesPerUnit *
      mat2(dot(gradS, skin.axisS), dot(gradT, skin.axisS), dot(gradS, skin.axisT), dot(gradT, skin.axisT));
  return skin;
}

vec2 along(Skin skin, vec3 v) { return vec2(dot(skin.axisS, v), dot(skin.axisT, v)); }
vec3 inFrame(Skin skin, vec3 v) { return vec3(along(skin, v), dot(skin.normal, v)); }
