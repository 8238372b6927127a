// What the groom makes of a strand: brushes have shaped it, and the map says how long it is and of which type.
#ifdef SHAPED
#include "common_shape.glsl"
vec3 shapeAmount;   // of curl, frizz and locks, for the whole ray
float shapeLength;  // tiles that a strand covers when it lies

void enterShape() {
  shapeAmount = textureLod(shapeMap, vAtlas + 0.5 * atlasFromTile() * (foot - vTile.xy), 0.0).rgb;
  shapeAmount *= 1.0 - 0.8 * min(entryHeld, 1.0);  // water draws curls out
  shapeLength = max(furLength * tilesPerUnit * vLength, 1e-4);
}

void shape(inout Strand here) {
  ShapedStrand shaped = shapedStrandAt(here.root, here.along, shapeAmount, shapeLength);
  here.root = shaped.root;
  here.open *= shaped.open;
  // Not all of it: locks keep their lines.
  here.coarser = max(here.coarser, step(0.3, shaped.pull) + step(0.63, shaped.pull));
}

vec2 shapeTilt(vec4 spot, float h) {
  float rise = min(0.05, h);
  ShapedStrand above = shapedStrandAt(spot.xy, h, shapeAmount, shapeLength), lower = shapedStrandAt(spot.xy, h - rise, shapeAmount, shapeLength);
  return (lower.root - above.root) / max(rise * shapeLength, 1e-4);
}
#else
void enterShape() {}
void shape(inout Strand here) {}
vec2 shapeTilt(vec4 spot, float h) { return vec2(0.0); }
#endif

#ifdef GROOMED
#ifdef TYPES
vec4 typesUnder;  // that the skin under the strands is of

void enterGroom() {
  enterTypes(rootsAside());
  typesUnder = only(plainType);
  grown = plainFurry;
  if (plainTo < end) {
    vec4 texel = furOn(footInAtlas());
    grown = coatShare(texel);
    typesUnder = presences(texel.gba);
  }
}
vec3 skinColor() { return skinColorOf(typesUnder); }
#else
void enterGroom() { grown = coatShare(furOn(footInAtlas())); }
vec3 skinColor() { return skinColors[0].rgb; }
#endif

// Vertices have room for the longest strand round them; the map knows the length of every strand.
void trim(inout Strand here, inout March march) {
  vec4 texel = furAt(here);
  here.along *= vLength / max(texel.r, 1e-3);
  here.open *= step(kBald, texel.r);
#ifdef TYPES
  here.grows = presences(texel.gba) * typesGrow;
  march.furry = min(texel.r / 0.15, 1.0) * min(2.0 * dot(here.grows, vec4(1.0)), 1.0);  // coatShare()
#else
  march.furry = coatShare(texel);
  here.open *= float(here.along <= 1.0);
#endif
}

#ifdef TYPES
// After the steps of addPlain().
void leavePlain(inout March march) {
  Strand met = standingAt(march.metX);
  shape(met);
  march.spot = spotIn(plainType, met, met.along * plainRise);
#ifndef WET
  march.hSum = march.alpha * plainRise * heightAt(march.xSum / max(march.alpha, 1e-3));
#endif
  march.types = (march.alpha + 1e-3) * only(plainType);
  march.furry = plainFurry;
}
#endif

// The strand that is shown is that of the step at which it was met.
vec4 spotOf(Strand here, March march) { return march.spot; }
// Skin under fur goes over into bare skin where it thins out.
vec3 thinned(vec3 skin, vec3 bare, float rho, float lit) { return mix(bareSkin(bare, vLight.z, vView.w, rho, lit), skin, grown); }
#else
void enterGroom() { grown = 1.0; }
vec3 skinColor() { return skinColors[0].rgb; }
void trim(inout Strand here, inout March march) {}
vec4 spotOf(Strand here, March march) { return spotIn(here); }
vec3 thinned(vec3 skin, vec3 bare, float rho, float lit) { return skin; }
#endif
