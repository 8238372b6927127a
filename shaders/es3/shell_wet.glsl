// What water makes of the coat that a ray marches through.
uniform sampler2D mask;
uniform sampler2DArray streaks;  // strand, the mean of those in line: layers turn by a half

// From here on what the march finds of a sheet does not show (what it finds is weighted by 1 - joined): that many steps.
const float kWholeSheet = 0.98;
#ifdef GROOMED
const int kSheetSteps = 1;  // which fur there is
#else
const int kSheetSteps = 0;
#endif

// Of the whole ray, by where it enters: the water there, how much of a sheet the coat is, how high it stands, where its tips lie
// from their roots (tiles); how many fur lengths a tile is on average, how many tiles the atlas.
float entryHeld, sheet, coatTop, furLengths, atlasLength;
float entryChart;  // chartOf() where it enters
vec2 lie;
mat2 tileFromAtlas, furFromTile;  // fur lengths along axisS, axisT (shell.vert)

const float kFarOn = 2.0;  // fur lengths
bool leavesChart(vec2 a) {
  vec4 texel = maskAt(mask, a);
  texel.x -= entryChart;
  return isBeside(texel);
}

// The strand that the ray meets at height h over the tile point `at`.
struct WetStrand {
  vec2 root;   // tile
  float along; // itself, 0..1
  float open;  // 0: none; more than 1 where many are drawn together
  float pull;  // s
  vec4 clump;  // w: the water it holds
  vec2 from;   // of its root from the clump's middle, tiles
};
// `a`: the atlas point; `inside`: the last one that lay in the chart.
WetStrand wetStrandAt(vec2 at, vec2 a, float h, inout vec2 inside) {
  WetStrand strand;
  strand.clump = maskAt(mask, a);
  strand.clump.x -= entryChart;
  float side = 1.0;
  if (isBeside(strand.clump)) {
    // Where a ray along the outline soon is: clumps as inside the chart, mirrored where it left.
    a = 2.0 * inside - a;
    side = -1.0;
    strand.clump = maskAt(mask, a);
    strand.clump.x -= entryChart;
    if (isBeside(strand.clump)) strand.clump.a = -1.0;
  } else {
    inside = a;
  }
  bool clumped = strand.clump.a > 0.0;
  if (strand.clump.a < 0.0) strand.clump.a = entryHeld;
  strand.along = h / coatTop;
  strand.pull = clumped ? clumpPull(strand.along, clumpingWetness(strand.clump.a, strand.clump.z * atlasLength * furLengths), sheet) : 0.0;
  vec2 from = (a - strand.clump.xy) / (1.0 - strand.pull);
  strand.from = tileFromAtlas * from * side;
  vec2 aside = strand.from * strand.pull;
  strand.root = at + aside;
  strand.along = alongStrand(strand.along, furFromTile * aside);
  if (clumped) strand.along *= rimTaper(strand.clump.a, sheet, dot(from, from) / (strand.clump.z * strand.clump.z + 1e-12));
  // A sheet nearly closes the gaps.
  float own = mix(ownStrand(mask, strand.clump, entryChart, from), 1.0, 0.7 * sheet) * (1.0 + 2.0 * strand.pull + sheet);
  strand.open = (clumped ? own : 1.0) * float(strand.along <= 1.0);
  return strand;
}
// In a sheet light knows strands by those that lie in line where the ray comes to it, `enters` fur lengths on; `stored`: of
// the type that was met.
vec4 strandsInLine(float enters, float stored) {
  float top = min(vTop, coatTop), turn = floor(atan(lie.y, lie.x + 1e-9) * (FUR_STREAK_TURNS / 3.14159265) + 0.5);
  // Where they are seen, not where they root: over the length of a strand stretched charts would turn the lines aside.
  vec3 place = vec3(2.0 * tileAt(enters, top), mod(turn, FUR_STREAK_TURNS));
#ifdef TYPES
  place.z += floor(stored / storedLayers) * FUR_STREAK_TURNS;
#endif
  return textureLod(streaks, place, max(vLight.w - 0.5, 0.0));
}
