// A coat of several fur types, one above the other in the tile's textures: each asks whether it has a strand there.
// Of the type that has that layer.
float firstLayer(float stored) { return floor(stored / storedLayers) * storedLayers; }

// What strands of all types add to what is hidden.
float addStrand(Strand here, inout March march) {
  float added = 0.0;
  for (int type = 0; type < FUR_TYPES; ++type) {
    if (here.grows[type] <= 0.0) continue;
    float h = here.along * typeRise[type];
    if (h > 1.0) continue;
    vec4 spot = vec4(here.root, nearestLayer(storedLayer(h, between)) + float(type) * storedLayers, levelOf(here));
    float upTo = standsUpTo(here.grows[type], textureLod(strand, spot.xyz, spot.w).w);
    float add = stepCover(coverAt(spot, here.open) * float(h <= upTo)) * (1.0 - march.alpha - added);
    added += add;
    march.types[type] += add + 1e-3 * here.grows[type];
    meet(march, add, h, spot);
  }
  return added;
}

void showTypes(March march) { typeShares = march.types / max(dot(march.types, vec4(1.0)), 1e-6); }

StrandColors colorsOf() {
  StrandColors colors = StrandColors(vec3(0.0), vec3(0.0), ofType(typeVariance));
  for (int type = 0; type < FUR_TYPES; ++type) {
    colors.root += typeShares[type] * rootColors[type].rgb;
    colors.tip += typeShares[type] * tipColors[type].rgb;
  }
  return colors;
}

// As the picture of the groom has it: type 1 white, the others red, green and blue.
vec3 typeColor() {
  return typeShares.x + typeShares.yzw + 0.25 * (1.0 - typeShares.x);
}
