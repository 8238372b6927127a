// A coat of several fur types, one above the other in the tile's textures: each that a ray may meet asks whether it has a strand there.
uniform sampler2D typesNear;  // groom/TypesNear.h

// What the ray may meet, by enterTypes().
int firstType, lastType;
bool plain;       // one type, all of one length
float plainRise;  // then: by which heights are those along its strands

float riseOf(int type) { return dot(typeRise, vec4(equal(ivec4(type), ivec4(0, 1, 2, 3)))); }

// Of the type that has that layer.
float firstLayer(float stored) { return floor(stored / storedLayers) * storedLayers; }

void enterTypes(float skinLength) {
  vec2 way = 0.5 * atlasFromTile() * (foot - vTile.xy);
  // Half a cell for what is filtered between texels.
  float cells = max(abs(way.x), abs(way.y)) * float(textureSize(typesNear, 0).x) + 0.5;
  int near = int(255.0 * textureLod(typesNear, vAtlas + way, ceil(log2(max(cells, 1.0)))).r + 0.5);
  int types = near & 15;
  firstType = (types & 1) > 0 ? 0 : (types & 2) > 0 ? 1 : (types & 4) > 0 ? 2 : 3;
  lastType = types > 7 ? 3 : types > 3 ? 2 : types > 1 ? 1 : 0;
  plain = firstType == lastType && near < 16;
  plainRise = riseOf(firstType) * vLength / max(skinLength, 1e-3);
}

// What strands add to what is hidden.
float addPlain(Strand here, inout March march) {
  float h = here.along * plainRise;
  vec4 spot = vec4(here.root, nearestLayer(storedLayer(h, between)) + float(firstType) * storedLayers, levelOf(here));
  float add = stepCover(coverAt(spot, here.open) * float(h <= 1.0)) * (1.0 - march.alpha);
  meet(march, add, h, spot);
  return add;
}

float addStrand(Strand here, inout March march) {
  float added = 0.0;
  for (int i = 0; i < FUR_TYPES && firstType + i <= lastType; ++i) {
    int type = firstType + i;
    vec4 is = vec4(equal(ivec4(type), ivec4(0, 1, 2, 3)));
    float grows = dot(here.grows, is), h = here.along * dot(typeRise, is);
    vec4 spot = vec4(here.root, nearestLayer(storedLayer(h, between)) + float(type) * storedLayers, levelOf(here));
    float upTo = standsUpTo(grows, textureLod(strand, spot.xyz, spot.w).w);
    float add = stepCover(coverAt(spot, here.open) * float(grows > 0.0 && h <= min(upTo, 1.0))) * (1.0 - march.alpha - added);
    added += add;
    march.types += (add + 1e-3 * grows) * is;
    meet(march, add, h, spot);
  }
  return added;
}

void showTypes(March march) {
  typeShares = plain ? vec4(equal(ivec4(firstType), ivec4(0, 1, 2, 3))) : march.types / max(dot(march.types, vec4(1.0)), 1e-6);
}

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
