// What water makes of the coat that a ray marches through. shell_dry.glsl has the same functions for dry fur.
uniform sampler2D mask;
uniform sampler2DArray streaks;  // strand, the mean of those in line: layers turn by a half

in vec3 vTileOfFur;  // tiles that a fur length covers: along axisS (x, y), along axisT (0, z)

// From here on what the march finds of a sheet does not show (what it finds is weighted by 1 - joined): that many steps.
const float kWholeSheet = 0.98;
#ifdef GROOMED
const int kSheetSteps = 1;  // which fur there is
#else
const int kSheetSteps = 0;
#endif

// Of the whole ray, by where it enters.
float entryHeld, entryChart;      // the water there; chartOf()
float entryRadius;                // of its clump, 0: it is dry
float sheet, joined;              // how much of a sheet the coat is; how much of what is shown
float coatTop;                    // how high it stands
float enters, closes;             // where the ray comes to that; what hides all
vec2 lean, tipTile;               // where its tips are from their roots: fur lengths, tiles
float furLengths, atlasLength;    // how many fur lengths a tile is on average, how many tiles the atlas
mat2 tileFromAtlas, furFromTile;  // fur lengths along axisS, axisT (shell.vert)

// What lies on top of a sheet where the ray comes to it.
struct Lying {
  vec2 outward;  // of its lock in the surface's frame, 1 at the rim; of locksAt(): x: to which side, 1 at the rim
  float rises;   // how far it is out of the gaps between locks, 0..1
  float chance;  // how far it is up (above 0) or down: of the lock, falling to its tip; of a sheet, by the strand as well
  vec2 tilt;     // of its strands to the tip of the lock
};
Lying lying;

void enterWater() {
  tileFromAtlas = inverse(atlasFromTile());
  atlasLength = sqrt(abs(determinant(tileFromAtlas)));
  // Charts are stretched, each in its own way: what is drawn aside is drawn aside on the skin.
  mat2 tileFromFur = mat2(vTileOfFur.xy, 0.0, vTileOfFur.z);
  furFromTile = inverse(tileFromFur);
  furLengths = sqrt(abs(determinant(furFromTile)));
  entryHeld = filteredWetness(mask, vAtlas);
  vec4 entryClump = maskAt(mask, vAtlas);
  entryChart = chartOf(entryClump);
  entryRadius = entryClump.a > 0.0 ? entryClump.z : 0.0;
  sheet = sheetOf(entryHeld, shortnessOf(coatHere()));
  joined = sheet * (2.0 - sheet);
  coatTop = upright(entryHeld, sheet);
  lean = wetLean(0.5 * vLean.xy, entryHeld, sheet);
  tipTile = tileFromFur * lean;
  // Clumps are denser than dry fur: they close sooner, and longer steps find them.
  stepSize *= 1.0 + 0.7 * min(entryHeld, 1.0);
  closes = kClosed * (1.0 - 0.6 * sheet);
  enters = 0.0;
  if (vTop > coatTop) {
    bool comesDown;
    enters = rayTo(vTop - coatTop, comesDown);
    if (!comesDown) end = 0.0;
  }
}

float rootsAside() { return entryRadius; }
bool underSheet() { return reachesSkin && joined > kWholeSheet; }

const float kFarOn = 2.0;  // fur lengths
// Whether the ray comes to an edge first, behind which there is no such skin, as one that goes on so far may.
bool leavesSkin() {
  if (end <= kFarOn) return false;
  vec4 texel = maskAt(mask, atlasAt(foot));
  texel.x -= entryChart;
  return isBeside(texel);
}

// The clump at the atlas point `a`, less its chart's number.
vec4 clumpIn(vec2 a) {
  vec4 clump = maskAt(mask, a);
  clump.x -= entryChart;
  return clump;
}

// The strand that the ray meets at height h.
Strand standingAt(float h, inout March march) {
  Strand here;
  vec2 tile = tileAt(march.x, h) - tipTile * (h / coatTop), a = atlasAt(tile);
  here.clump = clumpIn(a);
  float side = 1.0;
  if (isBeside(here.clump)) {
    // Where a ray along the outline soon is: clumps as inside the chart, mirrored where it left.
    a = 2.0 * march.inside - a;
    side = -1.0;
    here.clump = clumpIn(a);
    if (isBeside(here.clump)) here.clump.a = -1.0;
  } else {
    march.inside = a;
  }
  bool clumped = here.clump.a > 0.0;
  if (here.clump.a < 0.0) here.clump.a = entryHeld;
  here.along = h / coatTop;
  here.pull = clumped ? clumpPull(here.along, clumpingWetness(here.clump.a, here.clump.z * atlasLength * furLengths), sheet) : 0.0;
  vec2 from = (a - here.clump.xy) / (1.0 - here.pull);
  here.from = tileFromAtlas * from * side;
  vec2 aside = here.from * here.pull;
  here.root = tile + aside;
  here.along = alongStrand(here.along, furFromTile * aside);
  if (clumped) here.along *= rimTaper(here.clump.a, sheet, dot(from, from) / (here.clump.z * here.clump.z + 1e-12));
  // A sheet nearly closes the gaps.
  float own = mix(ownStrand(mask, here.clump, entryChart, from), 1.0, 0.7 * sheet) * (1.0 + 2.0 * here.pull + sheet);
  here.open = (clumped ? own : 1.0) * float(here.along <= 1.0);
  return here;
}

// Strands that water joins are one as far as light is concerned: as many as a pixel has.
vec4 strandAt(vec4 spot, Strand here) { return textureLod(strand, spot.xyz, spot.w + 1.5 * min(here.clump.a, 1.0)); }

// In a sheet light knows strands by those that lie in line where the ray comes to it; `stored`: of the type that was met.
vec4 strandsInLine(float stored) {
  float top = min(vTop, coatTop), turn = floor(atan(tipTile.y, tipTile.x + 1e-9) * (FUR_STREAK_TURNS / 3.14159265) + 0.5);
  // Where they are seen, not where they root: over the length of a strand stretched charts would turn the lines aside.
  vec3 place = vec3(2.0 * tileAt(enters, top), mod(turn, FUR_STREAK_TURNS) + firstLayer(stored) / storedLayers * FUR_STREAK_TURNS);
  return textureLod(streaks, place, max(vLight.w - 0.5, 0.0));
}

// Locks of one size: the one that comes from furthest lies on top, as hair lies over what roots further on. `cells`: of their grid, to a
// tile; `lies`: from root to tip, tiles.
Lying locksAt(vec2 tile, vec2 lies, float cells) {
  Lying top = Lying(vec2(0.0), 0.0, 0.0, vec2(0.0));
  vec2 at = tile * cells, way = lies * cells;
  float along = 0.0;
  for (int i = 0; i < FUR_LOCK_LOOKS; ++i) {
    // At the middle of the map's texel the centre is exact: all of a lock agree on it.
    vec2 texel = floor((at - way * ((float(i) + 0.5) / float(FUR_LOCK_LOOKS))) * FUR_LOCK_TEXELS) + 0.5, centre = lockCentre(texel / FUR_LOCK_TEXELS);
    vec2 on = onLock(at - centre, way, FUR_LOCK_HALF_WIDTH);
    if (on.x <= along || on.x >= 1.0 || abs(on.y) >= 1.0) continue;
    along = on.x;
    top.outward.x = on.y;
    top.rises = (1.0 - on.y * on.y) * min(3.0 * on.x, 1.0);
    float chance = fract(dot(floor(centre), vec2(0.7548777, 0.5698403)) + 0.31) - 0.5;
    top.chance = min(2.0 * top.rises, 1.0) * (chance + 0.5 * (0.5 - on.x));
  }
  return top;
}

const float kMeanRise = 0.6;  // of locks that lie over one another
// Of two sizes, as large as the fur there is long: as it grows shorter the one goes over into the other.
void lieDown() {
  float width = max(FUR_LOCK_WIDTH / furLengths, FUR_LEAST_LOCK * clumpRadius * tilesPerUnit), size = -log2(width), large = floor(size), small = size - large;
  float lies = length(lean);
  vec2 tile = tileAt(enters, min(vTop, coatTop)), way = tipTile * (max(0.85, FUR_LOCK_LENGTH * width * furLengths) / max(lies, 1e-3));
  Lying one = locksAt(tile, way, exp2(large)), two = locksAt(tile, way, exp2(large + 1.0));
  // What is smaller than two pixels is seen as its mean.
  float pixels = tileTexels * exp2(-large - vLight.w);
  float lie = smoothstep(0.05, 0.3, lies);
  vec2 seen = joined * lie * smoothstep(vec2(1.0), vec2(2.5), vec2(pixels, 0.5 * pixels));
  vec2 rises = mix(vec2(kMeanRise), vec2(one.rises, two.rises), seen / max(joined * lie, 1e-6));
  vec2 beside = furFromTile * vec2(-way.y, way.x);
  lying.outward = beside * (mix(seen.x * one.outward.x, seen.y * two.outward.x, small) / max(length(beside), 1e-6));
  lying.chance = mix(seen.x * one.chance, seen.y * two.chance, small);
  lying.rises = mix(1.0, mix(rises.x, rises.y, small), joined * lie);
  lying.tilt = -0.4 * lying.outward;
}

// In a sheet those that lie in line are shown instead of the one that the march met: its chance would be grain there.
void joinStrands(inout Met met, float furry) {
  met.x = mix(met.x, enters, joined);
  met.held = mix(met.here.clump.a, entryHeld, joined);
  lying = Lying(vec2(0.0), 1.0, 0.0, vec2(0.0));
  if (sheet <= 0.0) return;
  lieDown();
  vec4 inLine = strandsInLine(met.spot.z);
  met.strand = mix(met.strand, inLine, joined);
  met.number = mix(met.number, clamp(0.5 + 3.0 * (inLine.z - 0.5), 0.0, 1.0), joined);
  // No two locks lie alike, nor two lines of strands in one: light breaks into glints instead of running in rings round the body.
  lying.chance *= 2.0 * met.number;
  met.h = mix(mix(met.h, 0.7, joined * (1.0 - met.closed)), 0.3 + 0.4 * met.number, joined);
  // Through a sparse coat skin shows all the same.
  if (reachesSkin) met.closed = mix(met.closed, 1.0, joined * furry * min(3.0 * densityShown(), 1.0));
}

vec2 tiltOf(Met met) {
  vec2 tilt = furFromTile * (met.strand.xy * 2.0 - 1.0) / furLengths;
  return tilt / max(length(tilt), 1.0);
}

// Eq. 4: the strand moves by -d, in fur lengths.
vec2 clumpTilt(Met met, March march) {
  float along = heightAt(march.metX) / coatTop, held = clumpingWetness(met.here.clump.a, met.here.clump.z * atlasLength * furLengths);
  float rises = clumpPull(along - 1.0 / layers, held, sheet) - clumpPull(along, held, sheet);
  // The strands of a sheet stick to those below: they lie flatter than the coat is high, however little water made it.
  float flatter = (1.0 + 1.5 * min(2.0 * joined, 1.0) / clamp(entryHeld, 0.3, 1.0)) / max(1.0 + 1.6 * lying.chance, 0.1);
  return furFromTile * met.here.from * (rises * layers * (1.0 - joined)) + lean * (flatter / coatTop) + lying.tilt;
}

float shadeOfOne() { return FUR_SHADE_OF_ONE * (1.0 - joined); }
vec3 soaked(vec3 albedo, float rho) { return wetAlbedo(albedo, rho); }

vec3 waterLight(vec3 color, Met met, vec3 T, vec3 L, vec3 V, float lit) {
  vec2 back = lean * (lying.chance / max(length(lean), 1e-3)), outward = met.here.from / max(met.here.clump.z * atlasLength, 1e-6);
  outward *= (1.0 - joined) / max(length(outward), 1.0);
  vec3 n = normalize(clumpNormal(outward, sheet) + vec3(0.8 * joined * tiltOf(met) + lying.outward - back, 0.0));
  color *= 0.2 + 0.8 * lying.rises;
  float glints = met.number * mix(1.0, 0.65 + 0.6 * abs(lying.chance), joined);
  return clumpLight(color, T, n, L, V, met.h, met.held, sheet, lit, vView.w, glints);
}
