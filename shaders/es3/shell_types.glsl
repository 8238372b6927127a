// A coat of several fur types, one above the other in the tile's textures: each that stands somewhere asks whether it has a strand there.
uniform sampler2D evenReach;  // groom/EvenReach.h

// Up to there the ray meets one type alone, all of one length: which, by how much heights are those along its strands, and how much of
// a coat that is.
float plainTo, plainRise, plainFurry;
int plainType;
// Members of the block that steps read.
vec4 typesGrow, typesRise;

int firstOf(int types) { return (types & 1) > 0 ? 0 : (types & 2) > 0 ? 1 : (types & 4) > 0 ? 2 : 3; }
// Of the type that has that layer.
float firstLayer(float layer) { return floor(layer / stored) * stored; }
// Where that type has the layer of nearestLayer(storedLayer()).
vec4 spotIn(int type, Strand here, float h) {
  return vec4(here.root, clamp(floor(h * stored + between), 0.0, stored - 1.0) + float(type) * stored, levelOf(here));
}

// `aside`: how far from where they are seen roots may lie, over the atlas.
void enterTypes(float aside) {
  typesGrow = typeGrows;
  typesRise = typeRise;
  vec4 texel = textureLod(evenReach, vAtlas, 0.0);
  vec2 size = vec2(textureSize(evenReach, 0));
  int even = int(255.0 * texel.r + 0.5);
  plainType = even & 3;
  // In texels: half of one less, as the map is filtered between them, and less what roots lie aside.
  vec2 way = abs(atlasFromTile() * (foot - vTile.xy)) * size;
  float reach = float(even >> 2) - 0.5 - aside * size.x;
  plainTo = end * clamp(reach / max(max(way.x, way.y), 1e-3), 0.0, 1.0);
  // Over the border of its chart the map has what grows in another place, or nothing: there fur is as where the ray enters, if that is even.
  if (reach > 0.0 && plainTo < end && textureLod(evenReach, atlasAt(foot), 0.0).b != texel.b) plainTo = end;
  vec4 is = only(plainType);
  float grows = dot(typesGrow, is) * step(kBald, texel.g);
  plainFurry = grows * min(texel.g / 0.15, 1.0);
  // What does not grow has no height.
  plainRise = dot(typesRise, is) * vLength / max(texel.g * grows, 1e-6);
}

// What the strand adds to what is hidden. What was met is worked out after the march.
float addPlain(Strand here, inout March march) {
  float h = here.along * plainRise;
  vec4 spot = spotIn(plainType, here, h);
  float add = stepCover(coverAt(spot, here.open) * float(h <= 1.0)) * (1.0 - march.alpha);
#ifdef WET
  march.hSum += add * h;
#endif
  if (add > march.alpha) march.metX = march.x;
  return add;
}

// What strands of all types add.
float addStrand(Strand here, inout March march) {
  float added = 0.0;
  ivec4 stands = ivec4(greaterThan(here.grows, vec4(0.0))) * ivec4(1, 2, 4, 8);
  int rest = stands.x + stands.y + stands.z + stands.w;
  for (int i = 0; i < FUR_TYPES && rest > 0; ++i) {
    int type = firstOf(rest);
    rest &= rest - 1;
    vec4 is = only(type);
    float grows = dot(here.grows, is), h = here.along * dot(typesRise, is);
    vec4 spot = spotIn(type, here, h);
    float cover = coverAt(spot, here.open) * float(h <= 1.0);
    // Alone it stands whatever its dominance.
    if (cover > 0.0 && grows < 1.0)
      cover *= float(h <= standsUpTo(grows, textureLod(strand, strandSpot(spot), spot.w).w));
    float add = stepCover(cover) * (1.0 - march.alpha - added);
    added += add;
    march.types += (add + 1e-3 * grows) * is;
    meet(march, add, h, spot);
    if (rest == 0) break;
  }
  return added;
}

void showTypes(March march) { showShares(march.types / max(dot(march.types, vec4(1.0)), 1e-6)); }

StrandColors colorsOf() { return StrandColors(shownRoot, shownTip, shownGloss.z); }

// As the picture of the groom has it: type 1 white, the others red, green and blue.
vec3 typeColor() {
  return typeShares.x + typeShares.yzw + 0.25 * (1.0 - typeShares.x);
}
