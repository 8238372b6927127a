// Where a ray leaves its chart, it meets the clumps and the very strands that root in the chart beyond the border (wet/ChartBorders.h): locks run
// on. It takes a fifth longer, so that samples after the first have it (Look.cpp).

// Whether skin goes on beyond the border where the ray leaves its chart, and how atlas and tile do there (origin: of the atlas, of the tile).
bool goesOn = false;
mat2 atlasBeyond, tileBeyond;
vec4 originBeyond;
// While isBeyond: the number of the chart there; the middle of the clump that the ray sees, as that chart has it.
float chartBeyond;
vec2 middleBeyond;

bool leadsOn(vec4 texel) { return borderOf(texel) > 0.0; }
// The clump at the atlas point `a`, less `chart`; v of gutters has the number of their border.
vec4 clumpOf(float chart, vec2 a) {
  vec4 clump = storedAt(mask, a);
  clump.x -= chart;
  clump.z -= FUR_LYING_STEP * floor(clump.z / FUR_LYING_STEP);
  return clump;
}
vec4 clumpIn(vec2 a) { return clumpOf(entryChart, a); }
// Whether it is none of its chart. Gutters are beside it where a border leads on, as notches between the teeth of one are no wider.
bool hasLeft(vec4 clump) { return isBeside(clump) || leadsOn(clump); }

bool isOutside(vec2 a) { return hasLeft(clumpIn(a)); }
bool beginsOutside(vec2 a) { return isOutside(a); }

// `a`: in the gutter where the ray leaves its chart. It leads to texels below the mask, which tell how the skin goes on.
void enterGutter(vec2 a) {
  vec4 gutter = clumpIn(a);
  goesOn = leadsOn(gutter) && !isBeside(gutter);
  int first = FUR_BORDER_TEXELS * max(int(borderOf(gutter)) - 1, 0), across = int(maskTexels);
  ivec2 at = ivec2(first % across, across + first / across);
  vec4 atlas = texelFetch(mask, at, 0), tile = texelFetch(mask, at + ivec2(1, 0), 0), origin = texelFetch(mask, at + ivec2(2, 0), 0);
  atlasBeyond = mat2(atlas.xy, atlas.zw);
  tileBeyond = mat2(tile.xy, tile.zw);
  originBeyond = origin * vec4(1.0, 1.0, tilesPerUnit, tilesPerUnit);
}

// Whether there is skin at `a` beyond the border, where the ray has left: the clump there in this chart's atlas.
bool goesBeyond(bool left, vec2 a, out vec4 clump) {
  vec4 found = clumpOf(0.0, atlasBeyond * a + originBeyond.xy);
  bool isSkin = left && goesOn && found.a >= 0.0 && !leadsOn(found);
  if (isSkin) {
    chartBeyond = chartOf(found);
    middleBeyond = found.xy - vec2(chartBeyond, 0.0);
    clump = vec4(inverse(atlasBeyond) * (middleBeyond - originBeyond.xy), found.ba);
  }
  return isSkin;
}
// At the tip of a chart that is narrower than a texel nothing is known of either: clumps are as that of the ray's entry, which may not reach to `a`.
vec4 clumpOfNeither(vec2 a) { return vec4(distance(a, entryClump.xy) > entryClump.z ? a : entryClump.xy, entryClump.zw); }
vec2 ownMiddle(vec4 clump) { return isBeyond ? middleBeyond : clump.xy; }

// Its own chart says whether a strand rooted `from` its middle is of a clump: between the teeth of two borders the texels of this one may lie where
// those do.
float isOwn(vec4 clump, vec2 from) {
  clump.xy = ownMiddle(clump);
  vec4 home = clumpOf(isBeyond ? chartBeyond : entryChart, clump.xy + (isBeyond ? atlasBeyond * from : from));
  return rootsInClump(home, clump, hasLeft(home));
}

// From this chart's tile to that in which the strand roots, and back.
vec2 inOwnTile(vec2 tile) { return isBeyond ? tileBeyond * tile + originBeyond.zw : tile; }
vec2 wayInThisTile(vec2 way) { return isBeyond ? inverse(tileBeyond) * way : way; }
vec2 inThisTile(vec2 tile) { return isBeyond ? wayInThisTile(tile - originBeyond.zw) : tile; }
// Where the groom's map has the fur of a root in its own tile.
vec2 furSpot(vec2 root) {
  vec2 here = atlasAt(inThisTile(root));
  return isBeyond ? atlasBeyond * here + originBeyond.xy : here;
}
