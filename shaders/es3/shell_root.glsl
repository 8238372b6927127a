// Where the strand at a spot (tile, layer, mip level) has its root, and the model's colour there.
#if defined(TEXTURED) || defined(PAINTED)
// How far from where the ray enters the strand that was met has its root, so that a curl has one colour up to its tip.
vec2 toRoot(vec4 spot) {
  vec2 root = spot.xy + textureLod(offset, strandSpot(spot), spot.w).xy - 0.5;
#ifdef BORDERS
  root = inThisTile(root);
#endif
  return root - vTile.xy;
}
#endif
#ifdef TEXTURED
// The model's own colour there: the model's uv a tile on is solved out of what both do from pixel to pixel.
vec3 colorAtRoot(vec4 spot) {
  vec2 root = toRoot(spot);
  mat2 tiles = mat2(dFdx(vTile.xy), dFdy(vTile.xy)), uvs = mat2(dFdx(vLean.zw), dFdy(vLean.zw));
  float area = determinant(tiles);
  // A surface seen edge-on tells nothing: there the root is not far.
  vec2 moved = abs(area) > 1e-9 ? uvs * (inverse(tiles) * root) : vec2(0.0);
  // By the entry's mip level: from strand to strand roots jump.
#ifdef TYPES
  return strandModelColor(baseColor, dot(typePicture, only(int(spot.z / storedLayers))), vLean.zw + moved, uvs);
#else
  return mix(vec3(1.0), textureGrad(baseColor, vLean.zw + moved, uvs[0], uvs[1]).rgb, textureAmount);
#endif
}
#else
vec3 colorAtRoot(vec4 spot) { return vec3(1.0); }
#endif
#ifdef PAINTED
vec2 rootInAtlas(vec4 spot) { return vAtlas + atlasFromTile() * toRoot(spot); }
#endif
