// Dry fur: strands stand where they root. shell_wet.glsl has the same functions for wet fur.
const float entryHeld = 0.0, enters = 0.0, closes = kClosed;
const int kSheetSteps = 0;

void enterWater() {}
#ifdef GROOMED
vec2 footInAtlas() { return atlasAt(foot); }
#endif
#if defined(GROOMED) && !defined(TYPES)
vec4 entryFur;
void enterChart() { entryFur = textureLod(groom, vAtlas, 0.0); }
// Over the border of its chart the map has what grows in another place, or nothing: there fur is as where the ray enters.
vec4 furOn(vec2 a) {
  vec4 there = textureLod(groom, a, 0.0);
  return abs(there.a - entryFur.a) < 0.5 / 255.0 ? there : entryFur;
}
#else
void enterChart() {}
#ifdef GROOMED
vec4 furOn(vec2 a) { return textureLod(groom, a, 0.0); }
#endif
#endif
float rootsAside() { return 0.0; }
bool underSheet() { return false; }
bool leavesSkin() { return false; }

Strand standingAt(float x) {
  Strand here;
  here.along = heightAt(x);
  here.root = tileAt(x, here.along);
  here.open = 1.0;
  here.coarser = 0.0;
  return here;
}
#ifdef GROOMED
vec4 furAt(Strand here) { return furOn(atlasAt(here.root)); }
#endif

vec4 strandAt(vec4 spot, Strand here) { return textureLod(strand, strandSpot(spot), spot.w); }
void joinStrands(inout Met met, float furry) {}
vec2 tiltOf(Met met) { return met.strand.xy * 2.0 - 1.0; }
vec2 clumpTilt(Met met, March march) { return vec2(0.0); }
float litHeight(Met met) { return met.h; }
float shadeOfOne() { return FUR_SHADE_OF_ONE; }
vec3 soaked(vec3 albedo, float rho) { return albedo; }
vec3 waterLight(vec3 color, vec3 albedo, Met met, vec3 T, vec3 L, vec3 V, float lit) { return color; }
