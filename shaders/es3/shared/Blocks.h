// Uniform blocks, attribute locations and texture units, in a subset that is valid as GLSL ES 3.00
// and as C++. BlocksGLTest holds both sides against the driver, member by member.
#ifdef __cplusplus
#pragma once
#include "core/Math.h"
namespace fur::render::shared {
using vec2 = Vec2;
using vec4 = Vec4;
using mat4 = Mat4;
#define FUR_BLOCK(name) struct alignas(16) name
#else
#define FUR_BLOCK(name) layout(std140) uniform name
#endif

#define FUR_TYPES 4

// std140 and C++ agree without padding: matrices and vec4s first, then numbers in rows of four. No vec3: drivers have been
// known to lay out what follows one differently. So points have w = 1, directions w = 0 and colours a = 1.

// One a frame. "Model" is the space of the unit sphere that the model was fitted to; a rigid
// transform takes it to the world.
FUR_BLOCK(FrameBlock) {
  mat4 clipFromModel;
  mat4 clipFromWorld;
  mat4 worldFromModel;
  mat4 lightFromModel;    // to the fur's own shadow map: xy 0..1, z depth along the light in model units
  vec4 eye;               // model space
  vec4 light;             // model space, unit, towards the key light
  vec4 lightWorld;        // world space, unit
  vec4 up;                // model space, unit, the world's +y
  vec4 keyLight;          // linear, its colour by its intensity
  vec4 backLight;         // linear light from behind what the eye sees
  vec4 sky;               // linear light from above
  vec4 floorLight;        // linear light from below
  vec4 backgroundTop;     // sRGB as it is shown
  vec4 backgroundBottom;  // sRGB as it is shown
  vec4 ballCentre;        // world space
  vec4 chance;            // 0..1, of this sample of the picture: added to the noises of pixels

  float pixelsPerUnit;    // pixels that a model unit covers at distance 1
  float lightIntensity;   // of the key light
  float fillLight;        // light from the eye
  float exposure;

  float samples;          // of a pixel
  float viewLayer;        // height of the layer that a view shows, 0..1
  float pictureHeight;    // rows of pixels in the picture
  float bottomRow;        // of the picture: the framebuffer's lowest

  vec2 groundCentre;      // world x and z of the middle of its shadow map
  float groundHeight;     // world y
  float groundHalfSide;   // of its shadow map

  float ballRadius;
  float shadowExtinction; // log2(e) k of the fur's own shadow
  float shadowBias;       // depth map: so far behind the first surface it begins, model units
  float shadowLayerDepth; // layers: how far apart they are, model units

  float shadowSurface;    // height of the first surface, 0..1
  float shadowRange;      // depth that the map spans, model units
  float stepLength;       // of a march's steps, 1 as is good for the picture
  float sampleShare;      // of the mean of this sample and those before it

  float transparent;      // 0 or 1: there is no background
  float finer;            // mip levels by which this sample of a mean reads the coat finer than a picture that stands alone
  float drawnShare;       // pixels that are drawn along a side, as a share of those that are shown
};

// The coat. One a change of the settings. Arrays and vec4s of "type" hold one of each fur type.
FUR_BLOCK(FurBlock) {
  vec4 rootColors[FUR_TYPES];  // linear
  vec4 tipColors[FUR_TYPES];   // linear
  vec4 skinColors[FUR_TYPES];  // linear
  vec4 typeGrows;      // 0 where the type is bald, else 1
  vec4 typeVariance;   // of colours from strand to strand
  vec4 typeRise;       // the length of the coat as a share of the type's
  vec4 typeDensity;    // share of its densest layer that strands cover
  vec4 typeShadow;     // of strands on what lies below them
  vec4 typeOcclusion;  // sigma_occ (Silva et al. 2010, Eq. 5)
  vec4 typeSpecular;
  vec4 typeShininess;     // exponent p when soaked (Eq. 3)
  vec4 typeDryShininess;  // and when dry
  vec4 typePicture;    // layer of its colour map; below 0: it has none

  float furLength;     // model units
  float tilesPerUnit;  // fur tiles along a model unit
  float layers;        // N of the coat
  float layersLog;     // ln N

  float tileTexels;    // along a side of the fur tile
  float storedLayers;  // in its textures
  float densest;       // of typeDensity
  float maskTexels;    // along a side of the wetness mask

  float lambert;       // share of it in the light on a strand
  float textureAmount; // share of the model's picture
  float chartsOverlap; // 0 or 1
  float clumpShape;    // w (Eq. 1)

  float wetDarkening;  // sigma_wet (Eq. 5)
  float wetGloss;      // sigma_spec (Eq. 3)
  float lobePeak;      // 1 / (beta_R sqrt(2 pi)) of Marschner's lobes
  float skinPicture;   // as typePicture, of the skin

  float clumpRadius;   // of clumps that form by themselves, model units
  float strandShare;   // layers of strands among storedLayers: 1 or 1/2
};

#define FUR_FRAME_BINDING 0
#define FUR_COAT_BINDING 1
#define FUR_HAIR_BINDING 2

// Surface vertices (shells, skin, ground shadow).
#define FUR_POSITION 0        // w: curvature S_ss
#define FUR_NORMAL 1          // w: curvature S_st
#define FUR_UV_ATLAS 2        // xy: model uv  zw: atlas
#define FUR_FUR_COORD 3       // xy: st  zw: strands from, to (SurfaceVertex::strands)
#define FUR_GRAD_S 4          // w: curvature S_tt
#define FUR_GRAD_T 5
#define FUR_ATLAS_FROM_FUR 6  // 2x2 by columns
#define FUR_AROUND 7          // xy: atlas  z: how far from there its triangles reach; of all vertices of one place the same
                              // w: how far clumps there sink as well, 0 or 1
#define FUR_LEAN 8            // xy: the skin's normal along axisS and axisT, where fur leans over it  z: SurfaceVertex::room
#define FUR_OTHER_UV 9        // of pictures of bare parts that lie by coordinates of their own; where there are any
#define FUR_HESSIAN_S 10      // second derivatives of s: along axisS, along both axes, along axisT
#define FUR_HESSIAN_T 11      // of t

// Fin instances: one an edge.
#define FUR_FIN_POSITION_A 0  // w: vertex index, for its bend
#define FUR_FIN_POSITION_B 1
#define FUR_FIN_NORMAL_A 2    // w: where the edge starts in the fin map
#define FUR_FIN_NORMAL_B 3    // w: curvature across the edge; -1 where it is sharp or a boundary. Technique shells: the fin's opacity
#define FUR_FIN_FACE_0 4      // w: model u at the edge's middle
#define FUR_FIN_FACE_1 5      // w: model v at the edge's middle
#define FUR_FIN_ATLAS 6       // atlas of a, atlas of b
#define FUR_FIN_ROOM 7        // SurfaceVertex::room of a, of b

#define FUR_WHISKER_ROOT 0       // w: width at the root
#define FUR_WHISKER_DIRECTION 1  // w: length
#define FUR_WHISKER_CURVE 2      // its own bend; w: share of the coat's bend that it takes
#define FUR_WHISKER_NORMAL 3     // of the skin; w: its random number
#define FUR_WHISKER_COLOR 4      // linear; w: atlas u
#define FUR_WHISKER_VERTICES 5   // indices of its triangle's vertices; w: atlas v
#define FUR_WHISKER_WEIGHTS 6    // their shares

#define FUR_DROP_PLACE 0  // world; w: radius
#define FUR_DROP_WAY 1    // on which it is seen in one picture; w: 1 where it flies, 0 where it clings
#define FUR_DROP_KIND 2   // wet::Drop: jet, splash

#define FUR_UNIT_COVERAGE 0
#define FUR_UNIT_STRAND 1
#define FUR_UNIT_MASK 2
#define FUR_UNIT_BEND 3
#define FUR_UNIT_BASE_COLOR 4
#define FUR_UNIT_GROUND 5
#define FUR_UNIT_STRAND_M 6
#define FUR_UNIT_STRAND_N 7
#define FUR_UNIT_SHADOW 8
#define FUR_UNIT_OPACITY 9
#define FUR_UNIT_GROOM 10
#define FUR_UNIT_OFFSET 11
#define FUR_UNIT_FIN_COVERAGE 12
#define FUR_UNIT_FIN_STRAND 13
#define FUR_UNIT_PUDDLES 14
#define FUR_UNIT_STREAKS 15
#define FUR_UNIT_PAINT 16
#define FUR_UNIT_SHAPE 17
#define FUR_UNIT_LOCK_CENTRES 18
#define FUR_UNIT_HAIR_NODES 19
#define FUR_UNIT_WISPS 20
#define FUR_UNIT_HAIR_POINTS 21
#define FUR_UNIT_MEMBER_STRANDS 22
#define FUR_UNIT_STRIPS 23
#define FUR_UNIT_TYPE_COLORS 28
#define FUR_UNIT_EVEN_REACH 29
#define FUR_UNIT_MEAN 30

// Directions over a half turn in which strands are averaged into streaks (furgen/Streaks.h).
#define FUR_STREAK_TURNS 32.0

// Cells along the ground's square.
#define FUR_GROUND_CELLS 16

// Opacity layers of the fur's own shadow map: their targets of four layers each, the shells that fill them.
#define FUR_SHADOW_TARGETS 4
#define FUR_SHADOW_SHELLS 8

// Locks that brushes make: so many across a square of so many texels of the fur tile, which then repeats.
#define FUR_LOCKS_ACROSS 8.0
#define FUR_LOCKS_TEXELS 224.0
// Texels of their map along one.
#define FUR_LOCK_TEXELS 16.0

// Texels of Marschner's tables (hair/Marschner.h).
#define FUR_STRAND_M 128.0
#define FUR_STRAND_N_X 128.0
#define FUR_STRAND_N_Y 32.0

// Steps of a march at most, whatever the numbers are.
#define FUR_MOST_STEPS 256
// Bends are stored this many to a row.
#define FUR_BEND_ROW 1024
// Pixels along the square that the twin tests evaluate.
#define FUR_TWIN_SIZE 33
// A fin shows where (n1.v)(n2.v) is below the first (opacity rises from there to 1 edge-on), and where
// not both faces are turned away by more than the second.
#define FUR_SILHOUETTE 0.06
#define FUR_HORIZON (-0.4)
// Curvature across a fin's edge: fins up to the first and none from the second on.
#define FUR_FIN_FLAT (-0.2)
#define FUR_FIN_ROUND 0.1
// Fins show the coat where it is twice so many pixels high, and are gone from there down: rays then show all there is.
#define FUR_FIN_PIXELS 3.0
// The height at which a fin begins: below it shells show the coat better.
#define FUR_FIN_FOOT 0.3
// Quads of a fin along its height; of one of the technique `shells`, which stand on more edges.
#define FUR_FIN_SEGMENTS 4
#define FUR_CLASSIC_FIN_SEGMENTS 2
// Shells of the exploded view, and how much further apart they are than in the coat, model units.
#define FUR_EXPLODED_SHELLS 8
#define FUR_EXPLODED_GAP 0.035
// Quads of the ball round its axis and from pole to pole.
#define FUR_BALL_AROUND 48
#define FUR_BALL_DOWN 24
// Radians: where Sheppard's force is 1 (dynamics::kMaxBend).
#define FUR_MAX_BEND 1.35
// Points of an arrow of the views of forces and bends; rows of bends of which one vertex in each more has one.
#define FUR_ARROW_POINTS 9
#define FUR_ARROW_ROWS 3
// Points of a whisker, root to tip (groom/Whiskers.h).
#define FUR_WHISKER_POINTS 8

#ifdef __cplusplus
}  // namespace fur::render::shared
#endif
