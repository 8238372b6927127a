// What a march through the coat meets and gathers.
uniform sampler2DArray coverage;  // r
uniform sampler2DArray strand;    // xy: tangent  z: variance  w: dominance
#if defined(TEXTURED) || defined(PAINTED) || defined(VIEW_OFFSET)
uniform sampler2DArray offset;    // 0.5 + the way back to the strand's root, in tiles
#endif

// A strand where the ray meets it.
struct Strand {
  vec2 root;   // tile
  float along; // its own length, 0..1; more: past its tip
  float open;  // how many stand there: 0 none, 1 as in the tile, more where many are drawn together
  float coarser; // mip levels: drawn together, strands are thinner than a pixel
#ifdef WET
  vec4 clump;  // a: the water it holds
  vec2 from;   // of its root from the clump's middle, tiles
#endif
#ifdef TYPES
  vec4 grows;  // presence of each fur type
#endif
};

struct March {
  float x;
  float alpha;  // how much strands hide so far
  float xSum;   // what each adds to that, weighted by x
  float metX;   // where the strand was met that is shown: the last one that hid more than all before it
  float furry;  // how much of a coat there is where the ray is
#if defined(WET) || defined(GROOMED)
  float hSum;   // height along the strands, weighted as x is
#endif
#ifdef GROOMED
  vec4 spot;    // of that strand: tile, layer, mip level
#endif
#ifdef TYPES
  vec4 types;   // what each adds
#endif
};

// Nothing met so far; `enters`: where fur begins.
March marchFrom(float x, float enters) {
  March march;
  march.x = x;
  march.metX = enters;
  march.alpha = march.xSum = 0.0;
  march.furry = grown;
#if defined(WET) || defined(GROOMED)
  march.hSum = 0.0;
#endif
#ifdef GROOMED
  march.spot = vec4(vTile.xy, 0.0, lod);
#endif
#ifdef TYPES
  march.types = vec4(0.0);
#endif
  return march;
}

// The height along strands of all that it met.
float heightMet(March march, float perStrand, float x) {
#if defined(WET) || defined(GROOMED)
  return march.hSum * perStrand;
#else
  return heightAt(x);
#endif
}

// What is shown of what the march met.
struct Met {
  float x;       // fur lengths along the ray
  float h;       // height along the strand
  float closed;  // how much strands hide of the skin
  float held;    // the water there
  Strand here;   // the strand that stands there
  vec4 spot;     // its tile, layer, mip level
  vec4 strand;   // as the texture has it
  float number;  // by which its glints differ from its neighbours', 0..1
};

// The colours of a strand, and how much they vary from one to the next.
struct StrandColors {
  vec3 root, tip;
  float variance;
};

// Rounded as the texture would: software rasterisers are quicker with whole levels.
float levelOf(Strand here) { return floor(lod + here.coarser + 0.5); }

// How much there is of what `open` strands cover. Magnified strands get edges one pixel wide; minified ones keep their
// fractional coverage. Wet strands that are drawn together grow towards each other.
float coverAt(vec4 spot, float open) {
#ifdef WET
  return clamp((textureLod(coverage, spot.xyz, spot.w).r * open - 0.5) * sharp + 0.5, 0.0, 1.0);
#else
  return min(clamp((textureLod(coverage, spot.xyz, spot.w).r - 0.5) * sharp + 0.5, 0.0, 1.0) * open, 1.0);
#endif
}
// Stands in for 1 - (1 - c)^softness.
float stepCover(float cover) { return min(cover * mix(softness, 1.0, cover), 1.0); }

// A strand that adds so much to what is hidden.
void meet(inout March march, float add, float h, vec4 spot) {
#if defined(WET) || defined(GROOMED)
  march.hSum += add * h;
#endif
  if (add > march.alpha) {
    march.metX = march.x;
#ifdef GROOMED
    march.spot = spot;
#endif
  }
}
