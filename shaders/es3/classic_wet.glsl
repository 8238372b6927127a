// Draws the strand at a shell's height to its clump. The march does the same at each step (shell_wet.glsl).
#ifdef PRINTED_CLUMPS
void drawToClump(inout Strand s) {
  vec4 clump = maskAt(mask, vAtlas);
  float chart = chartOf(clump);
  clump.x -= chart;
  s.held = clamp(clump.a, 0.0, 1.0);
  if (s.held <= 0.0) return;
  // Eq. 1 with p - c in radii of the clump; d moves the look-up.
  vec2 from = vAtlas - clump.xy, d = from * clumpDisplacement(s.along, s.held);
  vec4 home = maskAt(mask, vAtlas + d);
  home.x -= chart;
  // Algorithm 2: a root outside the clump or in a dry texel is no strand.
  s.open = float(dot(from + d, from + d) <= clump.z * clump.z && home.a > 0.0 && !isBeside(home));
  mat2 tileFromAtlas = inverse(atlasFromTile());
  s.root += tileFromAtlas * d;
  // Eq. 4: a strand moves by -d.
  vec2 rises = tileFromAtlas * from * ((clumpDisplacement(s.along - 1.0 / layers, s.held) - clumpDisplacement(s.along, s.held)) * layers);
  s.tilt = inverse(mat2(vTileOfFur.xy, 0.0, vTileOfFur.z)) * rises;
}
#else
void drawToClump(inout Strand s) {
  mat2 tileFromAtlas = inverse(atlasFromTile()), tileFromFur = mat2(vTileOfFur.xy, 0.0, vTileOfFur.z), furFromTile = inverse(tileFromFur);
  float atlasLength = sqrt(abs(determinant(tileFromAtlas))), furLengths = sqrt(abs(determinant(furFromTile)));
  vec4 under = maskAt(mask, vAtlas), clump = under;
  vec2 water = max(filteredWater(mask, vAtlas), 0.0);
  float held = water.x, chart = chartOf(under), shortness = shortnessOf(coatHere());
  s.sheet = sheetOf(held, shortness);
  // Wet strands lie down the way they lean, and stand lower.
  vec2 lean = wetLean(vTip, water.y, sheetOf(water.y, shortness));
  s.along /= upright(held, s.sheet);
  s.sheet = clumpsClosed(held, s.sheet, shortness);
  vec2 tile = vTile.xy - tileFromFur * lean * s.along, a = atlasAt(tile);
  clump = maskAt(mask, a);
  clump.x -= chart;
  if (isBeside(clump)) {
    a = vAtlas;
    clump = under;
    clump.x -= chart;
  }
  s.root = tile;
  s.tilt = lean;
  s.held = max(clump.a, 0.0);
  if (s.held <= 0.0) return;
  float drawn = clumpingWetness(s.held, clump.z * atlasLength * furLengths, chanceOfClump(clump.xy)), pull = clumpPull(s.along, drawn, s.sheet);
  vec2 from = (a - clump.xy) / (1.0 - pull), root = tileFromAtlas * from, aside = root * pull;
  s.tilt += furFromTile * root * ((clumpPull(s.along - 1.0 / layers, drawn, s.sheet) - pull) * layers);
  s.root += aside;
  s.along = alongStrand(s.along, furFromTile * aside) * rimTaper(s.sheet, s.sheet, dot(from, from) / (clump.z * clump.z + 1e-12));
  s.open = mix(ownStrand(mask, clump, chart, from), 1.0, 0.7 * s.sheet) * (1.0 + 2.0 * pull + s.sheet);
  s.outward = root / max(clump.z * atlasLength, 1e-6);
}
#endif
