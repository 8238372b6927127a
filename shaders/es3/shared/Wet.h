// The constants of wet fur that shaders and C++ share: valid as GLSL ES 3.00 and as C++. wet/Clump.h gives them C++ names.
#ifdef __cplusplus
#pragma once
#endif

// No strand is drawn further aside than this share of its length.
#define FUR_MAX_DISPLACEMENT 0.7
// The strands at the rim of a soaked clump look so much shorter.
#define FUR_RIM_TAPER 0.7

// Soaked clumps close into a sheet from this wetness on. Sheets and saturated clumps stand by so much lower.
#define FUR_SHEET_FROM 0.82
#define FUR_SHEET_SINKS 0.5
#define FUR_CLUMPS_SINK 0.3

// A clump that holds less water than FUR_SHEET_FROM draws its strands together as if it held more: by what it lacks of that, times this, as
// a share of what it holds.
#define FUR_EARLY_CLUMPS 0.9
// Clumps form one by one, by chance: the wetness at which they begin to, on the average; how much later the last begins than the first; and
// how much more water one takes to form.
#define FUR_CLUMPS_BEGIN 0.1
#define FUR_CLUMPS_APART 0.5
#define FUR_CLUMP_FORMS 0.3
// Up to the first of these a clump that is drawn together by so much draws tips alone, as the square of their height; from the second on strands
// from the root on: between the clumps of lightly wet fur there are notches, no cracks.
#define FUR_TIPS_DRAWN 0.3
#define FUR_ALL_DRAWN 0.64

// How much of a sheet of long fur is one where its strands are seen, near to the eye: the rest stays in clumps.
#define FUR_NEAR_SHEET 0.4
// The share of their glints that strands in clumps have. With all of them wet fur flickers more than dry fur while the camera moves.
#define FUR_WET_GLINTS 0.75

// Fur is short where clumps are as wide as it is long: their radius as a share of its length, from which on it is rather short, and
// wholly. It makes no clumps, which would be beads, but a sheet from that little water on, whole from that much.
#define FUR_SHORT_FROM 0.34
#define FUR_SHORT 0.58
#define FUR_SHORT_SHEET_FROM 0.05
#define FUR_SHORT_SHEET 1.0

// The share of their height at which soaked strands get light, and the wetness from which on they get it lower than dry ones.
#define FUR_WET_LIT 0.5
#define FUR_WET_LIT_FROM 0.2

// Locks that lie in a sheet: how wide, as a share of the length of the fur, but no less than that share of a clump's radius; and that
// many times as long at least, as hairs that are shorter stick to those beside them. Half their width at the root, in cells of their
// grid (furgen/LockCentres.h).
#define FUR_LOCK_WIDTH 0.3
#define FUR_LEAST_LOCK 0.5
#define FUR_LOCK_LENGTH 3.5
#define FUR_LOCK_HALF_WIDTH 0.6
// The light that strands in the gaps between locks have left. Skin between clumps gets as much as at that height of the coat.
#define FUR_LOCK_GAP 0.55
#define FUR_WET_SKIN_HEIGHT 0.55
// Look-ups for one, from the tip of the one that comes from furthest on.
#define FUR_LOCK_LOOKS 4

// The wetness from and up to which a strand holds a bead at its tip: none, as many as there are; as many, none.
#define FUR_BEADS_FROM 0.02
#define FUR_BEADS 0.12
#define FUR_BEADS_RUN 0.3
#define FUR_NO_BEADS 0.5

// The smaller locks that a clump holds: how many along its radius, and how far soaked strands draw together to them at their tips.
#define FUR_LOCKS_IN_CLUMP 2.0
#define FUR_LOCK_IN_CLUMP_PULL 0.6

// Short fur, which makes no clumps, is drawn together into tufts while it is half wet: cells of the grid of locks (furgen/LockCentres.h), a
// clump's radius across. How far their strands go to the middle at their tips, and by how much less in some, by chance; and how wide a tuft is
// from its middle on, in cells.
#define FUR_TUFT_PULL 0.8
#define FUR_TUFTS_DIFFER 0.6
#define FUR_TUFT_RADIUS 0.6
// From this shortness on that grid is one of tufts, up to it one of locks in clumps.
#define FUR_TUFTS_SHORT 0.5
// The wetness from which on there are some, from which on all; up to which all, from which on none: there fur lies in a sheet.
#define FUR_TUFTS_FROM 0.1
#define FUR_TUFTS 0.4
#define FUR_TUFTS_LIE 0.7
#define FUR_NO_TUFTS 1.0
// Still shorter fur makes none: their radius in fur lengths up to which there are all, from which on none.
#define FUR_WIDE_TUFT 0.35
#define FUR_WIDEST_TUFT 0.8

// The encoded mask (wet/MaskEncoding.h) tells the chart of a texel beside its clump's centre: u is stored with FUR_CHART_STEP
// times the chart's number, and half as much again, which keeps it positive where the centre lies beside the atlas. Numbers
// go round after FUR_CHART_NUMBERS.
#define FUR_CHART_STEP 4.0
#define FUR_CHART_NUMBERS 64
// v of a gutter's texel is stored with FUR_BORDER_STEP times the number of the border beside it (wet/ChartBorders.h), from 1 on; rows below the
// mask tell how the chart goes on there, each in so many texels, of which a row has a whole number. Of these v is exact to a quarter of a texel of
// 256, at least.
#define FUR_BORDER_STEP 2.0
#define FUR_BORDER_TEXELS 4
#define FUR_MOST_BORDERS 8191
// And the water by which fur lies down beside its clump's radius: z is stored with so much for each of that many steps.
#define FUR_LYING_STEP 4.0
#define FUR_LYING_STEPS 255.0
