// A coat of one fur type. shell_types.glsl has the same functions for several.
float firstLayer(float stored) { return 0.0; }

// storedLayer(), and by chance the one beside it.
vec4 spotIn(Strand here) { return vec4(here.root, here.along * stored + between - 0.5, levelOf(here)); }

// What the strand adds to what is hidden.
float addStrand(Strand here, inout March march) {
  vec4 spot = spotIn(here);
  float add = stepCover(coverAt(spot, here.open)) * (1.0 - march.alpha);
  meet(march, add, here.along, spot);
  return add;
}

void showTypes(March march) {}
StrandColors colorsOf() { return StrandColors(rootColors[0].rgb, tipColors[0].rgb, typeVariance.x); }
vec3 typeColor() { return vec3(1.0); }
