// The constants of wet fur that shaders and C++ share: valid as GLSL ES 3.00 and as C++. wet/Clump.h gives them C++ names.
#ifdef __cplusplus
#pragma once
#endif

// No strand is drawn further aside than this share of its length.
#define FUR_MAX_DISPLACEMENT 0.7
// The strands at the rim of a clump look so much shorter.
#define FUR_RIM_TAPER 0.7

// Soaked clumps close into a sheet from this wetness on; there strands are drawn together by so much less. Sheets and
// saturated clumps stand by so much lower.
#define FUR_SHEET_FROM 0.85
#define FUR_SHEET_OPENS 0.85
#define FUR_SHEET_SINKS 0.5
#define FUR_CLUMPS_SINK 0.3

// The encoded mask (wet/MaskEncoding.h) tells the chart of a texel beside its clump's centre: u is stored with FUR_CHART_STEP
// times the chart's number, and half as much again, which keeps it positive where the centre lies beside the atlas. Numbers
// go round after FUR_CHART_NUMBERS.
#define FUR_CHART_STEP 4.0
#define FUR_CHART_NUMBERS 64
