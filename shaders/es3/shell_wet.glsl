// What water makes of the coat that a ray marches through. shell_dry.glsl has the same functions for dry fur.
uniform sampler2D mask;
uniform sampler2DArray streaks;  // strand, the mean of those in line: layers turn by a half

in vec2 vUp;         // upwards in the surface's frame; N.up: vView.w
in vec4 vTileOfFur;  // tiles that a fur length covers: along axisS (x, y), along axisT (0, z); mip levels that the chart's stretch adds

// Up to the first of these mip levels, near to the eye, soaked fur is strands in clumps that lie; from the second on it is drawn as one. Short fur
// has no clumps: its single strands would shine as one patch.
const vec2 kFarLevels = vec2(3.7, 4.0), kShortFarLevels = vec2(2.6, 3.0);
// Clumps of as few pixels in radius as the first of these are drawn as one as well, as their strands and gaps would be grain; from the second on none.
const float kSmallClump = 1.0, kLargeClump = 4.5;
// Up to the first of these pixels in radius tufts are not seen, from the second on they are.
const vec2 kTuftPixels = vec2(0.6, 1.8);
const float kLeastSmooth = 0.15;  // clumpsSmooth of the smallest that are drawn; four times as large as that all is left
const float kFewestDrawn = 0.55;  // pixels along a side, as a share of those shown
// Of what is drawn as one, from here on what the march finds does not show (it is weighted by 1 - joined): that many steps.
const float kWholeSheet = 0.98;
const float kNoClumps = 0.999;    // so whole a sheet that clumps draw nothing aside
const float kUnseenSheet = 0.05;  // so little of it costs as much as all and is not seen
#ifdef GROOMED
const int kSheetSteps = 1;  // which fur there is
#else
const int kSheetSteps = 0;
#endif
// As kSampleStep: shorter steps find more of the clumps' strands than the first sample does, and the picture grew lighter.
const float kWetSampleStep = 0.75;

// Of the whole ray, by where it enters.

float entryHeld, entryChart;      // the water there; chartOf()
vec4 entryClump;                  // that lies there, less its chart's number
float entryRadius;                // of its clump, 0: it is dry
float seenApart;                  // how far strands that are drawn together are seen one by one
float soakedShare;                // how much of a sheet the coat is
float shortness, closed;          // shortnessOf() of the coat there; clumpsClosed()
float locked;                     // how far strands lie in locks: those that are drawn as one, and single ones of short fur
float sheet, joined;              // how far the clumps that are drawn have closed into it; how much of what is shown is drawn as one
bool drawsNothing;                // whether it is so whole a sheet that clumps draw nothing aside
float fillsGaps;                  // how many strands stand between clumps, where it is one
vec4 tuftHere;                    // what stands for a clump there
vec3 profile;                     // what clumpProfile() takes beside the height
float clumpsSmooth;               // what glints on soaked clumps has left of its smoothness where they are small
float coatTop, perTop;            // how high it stands; 1 / that
float enters, closes;             // where the ray comes to that; what hides all
float locksAcross, perLocks;      // in clumps, or tufts of short fur: to a tile; 1 / that
float tufts;                      // tuftsOf(), where they are seen one by one
vec2 lean, tipTile;               // where its tips are from their roots: fur lengths, tiles
vec2 bend;                        // and where they would be when dry
float inLineLayer;                // streakLayer() of the way that they lie
float perLength;                  // 1 / the length of its strands that no clump draws aside, fur lengths
float furLengths, atlasLength;    // how many fur lengths a tile is on average, how many tiles the atlas
float furOfAtlas;                 // their product
mat2 tileFromAtlas, furFromTile;  // fur lengths along axisS, axisT (shell.vert)

// What lies on top of a sheet where the ray comes to it.
struct Lying {
  vec2 outward;  // of its lock in the surface's frame, 1 at the rim
  float rises;   // how far it is out of the gaps between locks, 0..1
  float chance;  // how far it is up (above 0) or down: of the lock, falling to its tip; of a sheet, by the strand as well
  vec2 tilt;     // of its strands to the tip of the lock
  float smoothness;  // waterGloss()
};
Lying lying;

// The layer of the streaks in which strands of the first type lie along `way`; those of the next have FUR_STREAK_TURNS more.
float streakLayer(vec2 way) { return mod(floor(atan(way.y, way.x + 1e-9) * (FUR_STREAK_TURNS / 3.14159265) + 0.5), FUR_STREAK_TURNS); }
// The means of strands in line, at that tile: `wide` times as wide as they are; of one mip level, as lod is.
vec4 strandsInLine(vec2 tile, float layer, float wide) {
  return textureLod(streaks, vec3((2.0 / wide) * tile, layer), floor(max(vLight.w - 0.5 - log2(wide), 0.7) + quadNoise()));
}

const float kAllSheet = 1.0 - FUR_SHEET_SINKS + 0.01;  // how high vertices stand between sheets
// The water where the ray enters. In short fur, where it lies in no clumps, lines of strands draw it in further or less far: its border frays
// the way that they lie. As filteredWater().
vec2 waterOfLine(mat2 tileFromFur) {
  float lies = length(vLean.xy), shift = shortness * smoothstep(0.1, 0.5, lies) * float(vTop > kAllSheet);
  vec2 way = tileFromFur * (vLean.xy / max(lies, 1e-3)), at = vAtlas;
  inLineLayer = streakLayer(way);
  if (shift > 0.0) {
    float chance = 4.5 * (strandsInLine(vTile.xy, inLineLayer, 0.9).z - 0.5);
    at -= atlasFromTile() * (way * (1.3 * shift * clamp(chance, -1.0, 1.0)));
  }
  return filteredWater(mask, at);
}

// Wet strands lie, and a ray that comes down passes many of them on its way. By steps as long as over the skin it met one of those by chance, which
// were grain in one picture and felt in the mean of samples. So long, in texels of the mip level across strands, are those of a picture that
// is drawn once, and of samples.
const vec2 kTexelsAcross = vec2(3.2, 1.3);
// Such a step in fur lengths.
float stepAcross() {
  float texels = length(vTile.zw - tipTile * (perTop * vPath.x)) * tileTexels * min(exp2(-vLight.w), 1.0);
  return (finer > 0.0 ? kTexelsAcross.y : kTexelsAcross.x) / max(texels, 1e-3);
}

void enterWater() {
  tileFromAtlas = inverse(atlasFromTile());
  atlasLength = sqrt(abs(determinant(tileFromAtlas)));
  // Charts are stretched, each in its own way: what is drawn aside is drawn aside on the skin.
  mat2 tileFromFur = mat2(vTileOfFur.xy, 0.0, vTileOfFur.z);
  furFromTile = inverse(tileFromFur);
  furLengths = sqrt(abs(determinant(furFromTile)));
  shortness = shortnessOf(coatHere());
  furOfAtlas = atlasLength * furLengths;
  perLocks = clumpRadius * tilesPerUnit / locksInClump(shortness);
  locksAcross = 1.0 / perLocks;
  vec2 water = waterOfLine(tileFromFur);
  entryHeld = water.x;
  entryClump = maskAt(mask, vAtlas);
  entryChart = chartOf(entryClump);
  entryClump.x -= entryChart;
  entryRadius = entryClump.a > 0.0 ? entryClump.z : 0.0;
  seenApart = smoothstep(0.4, 0.8, entryHeld);
  soakedShare = sheetOf(entryHeld, shortness);
  // In the pixels that are shown: where fewer are drawn for a while, all stays as it is; with still fewer it would be dots. And as if no chart
  // were stretched: from one to the next the level jumps.
  float shown = vLight.w - vTileOfFur.w + log2(max(drawnShare, kFewestDrawn)), far;
  vec2 farLevels = mix(kFarLevels, kShortFarLevels, shortness);
  far = smoothstep(farLevels.x, farLevels.y, shown);
  closed = clumpsClosed(entryHeld, soakedShare, shortness);
  sheet = mix(nearSheet(closed, shortness), closed, far);
  profile = vec3(clumpShape, 1.0 / layers, 1.0 / layersLog);
  drawsNothing = sheet > kNoClumps;
  fillsGaps = drawsNothing ? 0.0 : 0.4 * sheet;
  tuftHere = vec4(0.0, 0.0, FUR_TUFT_RADIUS * perLocks / atlasLength, entryHeld);
  float clumpPixels = clumpRadius * tilesPerUnit * tileTexels * exp2(-shown);
  float smallClumps = 1.0 - smoothstep(kSmallClump, kLargeClump, clumpPixels);
  clumpsSmooth = mix(1.0, mix(kLeastSmooth, 1.0, smoothstep(kLargeClump, 4.0 * kLargeClump, clumpPixels)), soakedShare);
  tufts = tuftsOf(entryHeld, coatHere()) * smoothstep(kTuftPixels.x, kTuftPixels.y, FUR_TUFT_RADIUS * clumpPixels);
  joined = max(soakedShare * (2.0 - soakedShare) * far, min(2.0 * entryHeld, 1.0) * smallClumps);
  joined = max((1.0 + kUnseenSheet) * joined - kUnseenSheet, 0.0) * (1.0 - tufts);
  locked = max(joined, shortness * min(2.0 * entryHeld, 1.0));
  bend = 0.5 * vLean.xy;
  lean = wetLean(bend, water.y, sheetOf(water.y, shortness));
  coatTop = wetTop(upright(entryHeld, soakedShare), length(bend), length(lean), soakedShare);
  tipTile = tileFromFur * lean;
  perTop = 1.0 / coatTop;
  perLength = 1.0 / alongStrand(coatTop, lean + bend * (coatTop * coatTop));
  // Clumps are denser than dry fur, and longer steps find them; twice as long ones missed them: clumps fell into dots.
  // Where the machine has too little time dry fur takes longer steps; clumps would grow darker, and the picture jumps when it goes back.
  float wet = min(2.0 * entryHeld, 1.0);
  stepSize *= (1.0 + 0.3 * min(entryHeld, 1.0)) * mix(1.0, (finer > 0.0 ? kWetSampleStep / kSampleStep : 1.0) / longer, wet);
  stepSize = mix(stepSize, min(stepSize, stepAcross()), wet);
  closes = kClosed * (1.0 - 0.6 * soakedShare - 0.12 * min(entryHeld, 1.0) * (1.0 - sheet));
  enters = 0.0;
  if (vTop > coatTop) {
    bool comesDown;
    enters = rayTo(vTop - coatTop, comesDown);
    if (!comesDown) end = 0.0;
  }
}

float rootsAside() { return entryRadius; }

// Whether what the ray sees roots beside its chart, at the ray's end or anywhere; where it leaves, in the atlas, and its way to there.
bool endsOutside, leaves;
vec2 edge, outwards;
bool isBeyond = false;  // whether what the ray sees roots in the chart beyond a border
#ifdef BORDERS
#include "shell_border.glsl"
#else
// Locks end where two charts meet. shell_border.glsl has the same functions, by which they run on.

// The clump at the atlas point `a`, less this chart's number.
vec4 clumpIn(vec2 a) {
  vec4 clump = maskAt(mask, a);
  clump.x -= entryChart;
  return clump;
}
bool hasLeft(vec4 clump) { return isBeside(clump); }
// Where the ray begins beside the chart, the clump at its entry stands for those there.
bool beginsOutside(vec2 a) { return false; }
void enterGutter(vec2 a) {}
bool isOutside(vec2 a) { return dot(a - edge, outwards) > 0.0; }
bool goesBeyond(bool left, vec2 a, out vec4 clump) { return false; }
vec4 clumpOfNeither(vec2 a) { return entryClump; }
vec2 ownMiddle(vec4 clump) { return clump.xy; }
float isOwn(vec4 clump, vec2 from) { return ownClump(mask, clump, entryChart, from); }
vec2 inOwnTile(vec2 tile) { return tile; }
vec2 wayInThisTile(vec2 way) { return way; }
vec2 furSpot(vec2 root) { return atlasAt(root); }
#endif

#ifdef GROOMED
vec2 furThere;  // where the map has the fur of the strand that was asked for last
#endif

// Where strands that no clump draws aside root which the ray meets at x, in the atlas.
vec2 rootsAt(float x) {
  float h = heightAt(x);
  return atlasAt(tileAt(x, h) - tipTile * (h * perTop));
}
const int kHalvings = 10;  // to a thousandth of the way; by a hundredth clumps there shimmer
// The edge is found once a ray, by halves: at its steps neighbouring rays would leave at other points, and their strands fall into rungs.
void enterChart() {
  vec2 from = rootsAt(enters), to = rootsAt(end);
  bool begins = beginsOutside(from);
  endsOutside = hasLeft(clumpIn(to));
  leaves = (begins || endsOutside) && !drawsNothing;
  edge = vAtlas;
  outwards = (begins ? from : to) - edge;
  if (leaves) {
    vec2 way = outwards;
    for (int i = 0; i < kHalvings; ++i) {
      way *= 0.5;
      edge += way * float(!hasLeft(clumpIn(edge + way)));
    }
    enterGutter(edge + way);
  }
}
#ifdef GROOMED
// Beside the chart lies fur of other parts, or none.
vec2 footInAtlas() { return endsOutside ? vAtlas : atlasAt(foot); }
#endif

const float kFarOn = 2.0;  // fur lengths
// Whether the ray comes to an edge first, behind which there is no such skin, as one that goes on so far may.
bool leavesSkin() { return endsOutside && end > kFarOn; }

// Whether strands that are drawn as one hide all, and skin under them fills what they leave open: nothing is marched for.
bool underSheet() { return reachesSkin && joined > kWholeSheet && !leavesSkin(); }

// The clump that the ray sees at the atlas point `a`. Where it has left its chart and nothing is known of what lies beyond, `a` is mirrored at
// the edge: clumps are as those inside.
vec4 clumpThere(inout vec2 a, out bool mirrored) {
  bool left = leaves && isOutside(a);
  vec4 clump;
  isBeyond = goesBeyond(left, a, clump);
  mirrored = left && !isBeyond;
  if (mirrored) a = 2.0 * edge - a;
  if (!isBeyond) clump = clumpIn(a);
  if (!isBeyond && hasLeft(clump)) clump = clumpOfNeither(a);
  return clump;
}

// The water that draws a clump's strands together.
float drawnBy(vec4 clump) { return clumpingWetness(clump.a, clump.z * furOfAtlas, chanceOfClump(ownMiddle(clump))); }

// Where it roots, what its lock or tuft has drawn to `spot` (tile), leaving so much of the way to the middle of that (`apart`) and to its clump's
// as well (`left`): so close together strands hide one another; of as many as there are, so many are seen as have room, each as wide as it is.
// `from`: its way from the middle.
vec2 rootInLock(vec2 spot, vec2 middle, float apart, float left, out vec2 from) {
  from = (spot - middle) * (1.0 / apart);
  return middle + from * mix(1.0, left, seenApart);
}
// How many strands of a tuft there are that root `from` its middle, 0..1; drawn aside, they are further `along`.
float inTuft(vec2 from, float apart, inout float along) {
  along = length(vec3(along, furFromTile * from * (tufts * (1.0 - apart) * perLength)));
  float across = locksAcross * (1.0 / FUR_TUFT_RADIUS);
  return mix(1.0, insideRim(dot(from, from) * across * across), tufts);
}
// Drawn together, strands are coarser by so many mip levels.
float coarserBy(float left) { return min(2.0 - 2.0 * left, 1.0) * 2.0 * (1.0 - seenApart); }

// clumpPull() there.
float pullAt(float h, float drawn) { return clumpPull(clumpProfile(h, profile.x, profile.y, profile.z), h, drawn, sheet); }

const float kOneSheet = 0.75;  // from here on it does not matter to which clump a strand belongs
const float kMiddle = 0.3;     // whose roots are a clump's own nearly always: squared, 1 at its rim
// The strand that the ray meets at x: the clump there says where it roots and how far along it that is, its lock or tuft which one is seen. Where no
// clump draws it aside, the tuft at the entry stands for one.
Strand standingAt(float x) {
  float h = heightAt(x), share = h * perTop;
  vec2 tile = tileAt(x, h) - tipTile * share, a = atlasAt(tile);
  bool mirrored = false;
  vec4 clump = tuftHere;
  if (!drawsNothing) clump = clumpThere(a, mirrored);
  float drawn = drawnBy(clump), pull = pullAt(share, drawn);
  float side = mirrored ? -1.0 : 1.0;
  vec2 from = (a - clump.xy) * (1.0 / (1.0 - pull)), aside = tileFromAtlas * from * (side * pull);
  float outward = dot(from, from) / max(clump.z * clump.z, 1e-12) * float(clump.a > 0.0), own = insideRim(outward);
  own *= outward > kMiddle && sheet < kOneSheet ? isOwn(clump, from) : 1.0;
  float along = alongStrand(h, lean * share + bend * (h * h) - furFromTile * aside) * perLength * rimTaper(soakedShare, sheet, outward);
  // Locks draw their strands together once more.
  vec2 spot = inOwnTile(tile + aside), middle = lockCentreNear(spot * locksAcross), fromMiddle;
  float inLock = max(lockPull(min(along, 1.0), drawn, lockSheet(sheet, shortness)), tuftPull(min(along, 1.0), tufts, middle));
  float apart = 1.0 - inLock, left = (1.0 - pull) * apart;
  Strand here;
  here.root = rootInLock(spot, middle * perLocks, apart, left, fromMiddle);
  own = (drawsNothing ? 1.0 : own) * inTuft(fromMiddle, apart, along);
#ifdef GROOMED
  furThere = mirrored ? edge : furSpot(here.root);
#endif
  // As many stand there as were drawn together; a sheet closes the gaps between clumps, but near to the eye hardly; all end in points.
  here.open = max(own / (left * left), fillsGaps) * clamp(8.0 - 8.0 * along, 0.0, 1.0);
  here.along = along;
  here.coarser = coarserBy(left);
  if (clump.a < 0.0) clump.a = entryHeld;
  here.clump = vec4(ownMiddle(clump), clump.zw);
  here.from = drawsNothing ? fromMiddle : tileFromAtlas * from * side;
#ifdef TYPES
  here.grows = vec4(0.0);
#endif
  return here;
}
#ifdef GROOMED
vec4 furOn(vec2 a) { return textureLod(groom, a, 0.0); }
vec4 furAt(Strand here) { return furOn(furThere); }
#endif

// Strands that water joins are one as far as light is concerned: as many as a pixel has.
vec4 strandAt(vec4 spot, Strand here) {
  vec4 met = textureLod(strand, strandSpot(spot), lod + 1.5 * min(entryHeld, 1.0));
  return vec4(0.5 + wayInThisTile(met.xy - 0.5), met.zw);
}

// Locks of one size: the one that comes from furthest lies on top, as hair lies over what roots further on. `cells`: of their grid, to a
// tile; `lies`: from root to tip, tiles; `frays`: by how much its strands lie beside where the lock has them, so that rims and tips fray.
// x: to which side of it, 1 at the rim  y, z: `rises` and `chance` of Lying
vec3 locksAt(vec2 tile, vec2 lies, float cells, float frays) {
  vec2 at = tile * cells, way = lies * cells;
  vec3 top = vec3(0.0);  // along and across the lock, its chance
  for (int i = 0; i < FUR_LOCK_LOOKS; ++i) {
    vec2 centre = lockCentreNear(at - way * ((float(i) + 0.5) / float(FUR_LOCK_LOOKS)));
    // No two are alike: of another length and width, and to another side.
    vec2 chances = fract(cellNumber(centre) + vec2(0.31, 0.31 * 7.3 + 3.1 * centre.x));
    vec2 own = way * (0.6 + 0.6 * chances.x) + vec2(-way.y, way.x) * (0.3 * (chances.y - 0.5));
    vec2 on = onLock(at - centre, own, FUR_LOCK_HALF_WIDTH * (0.75 + 0.5 * chances.y));
    on += vec2(0.25 * abs(frays), frays);
    top = mix(top, vec3(on, chances.x), step(top.x, on.x) * step(on.x, 1.0) * step(abs(on.y), 1.0));
    if (i + 1 == FUR_LOCK_LOOKS) break;
  }
  float rises = float(top.x > 0.0) * (1.0 - top.y * top.y) * min(0.35 + 2.0 * top.x, 1.0);
  return vec3(top.y, rises, min(2.0 * rises, 1.0) * (top.z - 0.5 + 0.5 * (0.5 - top.x)));
}

const float kHidesLying = 6.0;  // what a strand that lies hides of the skin, beside one that stands
const float kLockGloss = 0.25, kUnseenLocks = 0.12;  // the smoothness of locks: strands in one are not even; of those that are too small to be seen
const float kLockPixels = 7.0, kLargestLock = 1.7;  // from further off larger locks are seen: of that many pixels, or as many times as large
const float kMeanRise = 0.6;  // of locks that lie over one another
// Of two sizes, as large as the fur there is long: as it grows shorter each goes over into the next.
void lieDown(vec2 tile, float frays, float line) {
  float width = max(FUR_LOCK_WIDTH / furLengths, FUR_LEAST_LOCK * clumpRadius * tilesPerUnit);
  width = clamp(kLockPixels * exp2(vLight.w - vTileOfFur.w) / tileTexels, width, kLargestLock * width);
  float size = -log2(width), large = floor(size), small = size - large;
  float lies = length(lean);
  vec2 way = tipTile * (max(0.85, FUR_LOCK_LENGTH * width * furLengths) / max(lies, 1e-3));
  // What is smaller than seven pixels goes over into its mean.
  float pixels = tileTexels * exp2(-large - vLight.w);
  float lie = smoothstep(0.05, 0.3, lies);
  small = smoothstep(0.2, 0.8, small);  // seldom are there both sizes: each costs as much as all the rest of the light
  vec2 seen = locked * lie * vec2(1.0 - small, small) * smoothstep(vec2(2.0), vec2(7.0), vec2(pixels, 0.5 * pixels));
  vec2 beside = furFromTile * vec2(-way.y, way.x);
  float rises = kMeanRise, across = 0.0;
  for (int i = seen.x > 0.0 ? 0 : seen.y > 0.0 ? 1 : 2; i < 2; ++i) {
    vec3 lock = locksAt(tile, (i > 0 ? 0.7 : 1.0) * way, exp2(large + float(i)), frays);
    across += seen[i] * lock.x;
    lying.chance += seen[i] * lock.z;
    rises *= mix(1.0, lock.y / kMeanRise, seen[i]);
    if (i > 0 || seen.y <= 0.0) break;
  }
  lying.outward = beside * ((0.85 * across + joined * line) / max(length(beside), 1e-6));
  lying.rises = mix(1.0, min(rises, 1.0), locked * lie);
  lying.smoothness = mix(lying.smoothness, mix(kLockGloss, kUnseenLocks, lie - (seen.x + seen.y) / locked), 0.5 * (joined + locked));
  lying.tilt = -0.6 * lying.outward;
}

// Strands that come from where it is dry, or of another chart, where a ray leaves its own, are as wet as what lies round them, nearly.
const float kWetAsAround = 0.9;

// Where strands are drawn as one, those that lie in line are shown instead of the one that the march met: its chance would be grain there.
// Near to the eye soaked clumps, and strands in them, lie up or down by chance, or light would run in rings round the body, and get the
// light of a lower height.
void joinStrands(inout Met met, float furry) {
  met.x = mix(met.x, enters, joined);
  met.held = max(mix(met.here.clump.a, entryHeld, closed), kWetAsAround * entryHeld);
  lying = Lying(vec2(0.0), 1.0, 0.0, vec2(0.0), clumpsSmooth);
  float ofStrand = soakedShare * (1.0 - joined) * liesBy(chanceOfClump(met.here.clump.xy), met.number, shortness);
  if (locked > 0.0) {
    // In a sheet light knows strands by those that lie in line where the ray comes to it. Where they are seen, not where they root: over the
    // length of a strand stretched charts would turn the lines aside.
    vec2 seenAt = tileAt(enters, min(vTop, coatTop));
    float layer = inLineLayer + FUR_STREAK_TURNS * firstLayer(met.spot.z) / storedLayers;  // of the type that was met
    vec4 inLine = strandsInLine(seenAt, layer, 0.35), some = strandsInLine(seenAt, layer, 1.2), many = strandsInLine(seenAt, layer, 4.0);
    lieDown(seenAt, 2.0 * (inLine.z - 0.5) + 1.0 * (some.z - 0.5), 4.0 * (inLine.z - 0.5) + 2.0 * (some.z - 0.5));
    float deep = clamp(0.8 + 2.0 * (some.z - 0.5) + 5.0 * (many.z - 0.5), 0.4, 1.0);
    lying.rises *= mix(1.0, deep, joined);
    met.number = mix(met.number, clamp(0.45 + 2.5 * (some.z - 0.5) + 4.5 * (inLine.z - 0.5), 0.15, 0.9), joined);
    inLine.z = clamp(0.5 + 2.0 * (inLine.z - 0.5), 0.0, 1.0);
    met.strand = mix(met.strand, inLine, joined);
    // No two locks lie alike, nor two lines of strands in one: light breaks into glints instead of running in rings round the body.
    lying.chance *= 2.0 * met.number;
    met.h = mix(mix(met.h, 0.7, joined * (1.0 - met.closed)), 0.5 + 0.4 * met.number, joined);
    // Through a sparse coat skin shows all the same, between lines of strands: lying ones hide more than those that stand.
    float share = min(kHidesLying * densityShown(), 1.0), hides = clamp(share + 4.0 * (share - 1.0 + (met.number - 0.15) / 0.75), 0.0, 1.0);
    if (reachesSkin) met.closed = mix(met.closed, 1.0, joined * furry * hides);
  }
  lying.rises = mix(lying.rises, 1.0, tufts);
  lying.outward *= 1.0 - tufts;
  lying.chance += ofStrand;
}

vec2 tiltOf(Met met) {
  vec2 tilt = furFromTile * (met.strand.xy * 2.0 - 1.0) / furLengths;
  return tilt / max(length(tilt), 1.0);
}

// Eq. 4: the strand moves by -d, in fur lengths.
vec2 clumpTilt(Met met, March march) {
  float along = heightAt(march.metX) * perTop, drawn = drawnBy(met.here.clump);
  // The slope there, by a hundredth of the height.
  float turns = 100.0 * (pullAt(along - 0.01, drawn) - pullAt(along, drawn));
  // The strands of a sheet stick to those below: they lie flatter than the coat is high, however little water made it.
  float flatter = (1.0 + 1.5 * min(2.0 * joined, 1.0) / clamp(entryHeld, 0.3, 1.0)) / max(1.0 + 1.6 * lying.chance, 0.1);
  return furFromTile * met.here.from * (turns * (1.0 - joined)) + lean * (flatter * perTop) + lying.tilt;
}

// Where a strand gets its light: the march comes deeper between clumps than one sees when every strand is drawn, the most when
// clumps hold all they can and are no sheet yet. Half wet, wetter, soaked.
const vec3 kSeenDeeper = vec3(0.25, 0.55, 0.4);
float litHeight(Met met) {
  float deeper = mix(mix(kSeenDeeper.x, kSeenDeeper.y, smoothstep(0.4, 0.75, met.held)), kSeenDeeper.z, soakedShare);
  return mix(met.h, 1.0, deeper * min(2.0 * met.held, 1.0)) * litLower(met.held);
}
// Half-wet strands let light through to the next.
float shadeOfOne() { return FUR_SHADE_OF_ONE * (1.0 - joined) * max(1.0 - 2.0 * entryHeld, 0.0); }
vec3 soaked(vec3 albedo, float rho) { return wetCoatAlbedo(albedo, rho); }

vec3 waterLight(vec3 color, vec3 albedo, Met met, vec3 T, vec3 L, vec3 V, float lit) {
  vec2 back = lean * (lying.chance / max(length(lean), 1e-3)), outward = met.here.from / max(met.here.clump.z * atlasLength, 1e-6);
  outward *= (1.0 - shortness * (1.0 - tufts)) * (1.0 - joined) / max(length(outward), 1.0);
  vec3 n = normalize(clumpNormal(outward, sheet) + vec3(0.8 * joined * tiltOf(met) + lying.outward - back, 0.0));
  color *= mix(FUR_LOCK_GAP, 1.0, lying.rises);
  // On half-wet short fur single strands glinted like grains of rice.
  float even = min(3.0 * shortness, 1.0) * (1.0 - smoothstep(0.6, 1.0, entryHeld));
  float glints = mix(met.number, 0.25 + 0.3 * met.number, even) * mix(FUR_WET_GLINTS, 0.65 + 0.6 * abs(lying.chance), joined);
  vec3 upwards = inTurnedFrame(vec3(vUp, vView.w), vPath.zw * met.x);
  return clumpLight(color, albedo, T, n, L, V, litHeight(met), met.held, sheet, lit, upwards, glints, lying.smoothness);
}
