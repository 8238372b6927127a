// What shaders of long hair share with C++, as Blocks.h; apart from it, as a block counts as used wherever it is declared.
#ifdef __cplusplus
#pragma once
#include "shared/Blocks.h"
namespace fur::render::shared {
#endif

// Long hair. One a scalp.
FUR_BLOCK(HairBlock) {
  vec4 hairRootColor;  // linear
  vec4 hairTipColor;   // linear
  vec4 nodesLow;       // the corner of the box that holds all nodes, model space
  vec4 nodesSpan;      // and its sides

  float guideNodes;    // of each guide
  float cubicGuides;   // 1: curves run between them; 0: lines
  float curl;          // radius of a wisp's curls as a share of its width
  float curls;         // their turns from root to tip

  float tipWidth;      // of a wisp as a share of that at its root
  float hairDepth;     // of a wisp as a share of its width
  float strandWidth;   // model units, at the root
  float hairVariance;  // of colours

  float firstWisp;     // that is drawn
  float strandsDrawn;  // of each wisp
  float pointStep;     // points of a wisp from one that is drawn to the next
  float hairOpacity;   // of a strip in the opacity layers

  float hairShininess; // exponent of the highlight on dry hair
  float widening;      // of strands, as fewer than all are drawn
  float hairExtinction; // log2(e) k of the fur's shadow on hair
  float hairShadowBias; // so far behind the first surface it begins, model units

  float hairOcclusion; // how far what lies about hair takes light from all around it
  float hairGloss;     // strength of the highlight
  float hairBlend;     // 0: covers samples; 1: what covers half a pixel and more; 2: the rest, blended; wisps are in order where it is not 0
  float skinCover;     // of the skin under it, as hair that lies on it

  float wispsDrawn;    // as strips, the last of them thinner
  float wispWidening;  // of them, as fewer than all are drawn
};

#define FUR_UNIT_HAIR_AMBIENT 24
#define FUR_UNIT_WISP_ORDER 26
#define FUR_UNIT_BASE_TANGENTS 27
// Vertices in a row of the texture of base tangents (hair/BaseTangents.h).
#define FUR_BASE_TANGENTS_ROW 1024

// Of views: lines, an instance each; and colours, of wisps or over the atlas.
#define FUR_LINE_FROM 0  // model space; w: width, pixels
#define FUR_LINE_TO 1    // w: hair::ViewLine::lift
#define FUR_LINE_COLOR 2
#define FUR_UNIT_HAIR_COLORS 25

// Texels of a wisp: its offset and width at the root; weights of its guides and length; what its magnet adds to those weights
// and its rotation; numbers of its guides and its random number; the skin's normal and its splits.
#define FUR_WISP_OFFSET 0
#define FUR_WISP_WEIGHTS 1
#define FUR_WISP_MAGNET 2
#define FUR_WISP_GUIDES 3
#define FUR_WISP_NORMAL 4
#define FUR_WISP_TEXELS 5
// Segments of a wisp from root to tip, and sets of strands in it (hair/Wisps.h, MemberStrands.h).
#define FUR_WISP_SEGMENTS 16
#define FUR_WISP_KINDS 4
// By so much of its width a soaked wisp is thinner at its tip.
#define FUR_WET_GATHERS 0.65
// By so much a soaked wisp leaves where it is dry for its nearest guide, at its tip: wet hair draws together to locks.
#define FUR_WET_DRAWS 0.8
// A strip is so much wider than its wisp.
#define FUR_STRIP_REACH 1.25

#ifdef __cplusplus
}  // namespace fur::render::shared
#endif
