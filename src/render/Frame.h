// What one picture needs besides the uploaded model: plain values, made anew each frame.
#pragma once

#include <array>
#include <cstdint>
#include <span>

#include "core/Math.h"
#include "settings/Settings.h"
#include "wet/Drop.h"
#include "wet/Puddles.h"

namespace fur::render {

struct CameraPose {
  Vec3 eye{0, 0, 3};  // world
  Vec3 target{0};
  float fovY = 0.6f;  // radians
};

struct Frame {
  settings::Settings settings;
  float coatLength = 0.12f;  // of the longest strand of all fur types, model units
  std::array<float, settings::kFurTypes> typeHeights{1, 1, 1, 1};  // of each type, a share of that; 0: bald
  Mat4 worldFromModel{1.0f};  // rigid
  CameraPose camera;
  int width = 1, height = 1;  // pixels of the drawing buffer
  float groundHeight = -1;    // world y
  float reach = 1;            // of the skin from the model's origin, whatever it plays
  Vec4 ball{0};               // its centre in the world; w: radius, 0: none
  // Shells from which rays enter the coat: the outermost alone, or up to two below it as well. They are for rays that leave the
  // coat of one part of the body within that of another. Hidden ones are rejected by the depth test.
  int shellCount = 1;
  // The march's steps are this many times as long as is good for the picture: 1 and more.
  float stepLength = 1;
  // Long hair has this share of its strands, as much wider: above 0, up to 1.
  float hairShare = 1;
  // The picture is drawn in this share of its width and of its height, then enlarged: above 0, up to 1.
  float pixelScale = 1;
  // Which of a picture's samples (Samples.h) this is; 0: the picture that is drawn once.
  int sample = 0;
  // It is added to the mean of those before it, of which 0 is the first, and the framebuffer has that mean after the last band.
  bool gathers = false;
  // It gathers, and nothing but water has moved since the sample before: the latest samples count the most, none is finer than a picture
  // that is drawn once, and drops are drawn over the mean, or they would leave trails in it. After each band the mean of
  // the whole samples is shown.
  bool flows = false;
  // A picture that gathers is drawn in so many bands, one a call: band 0 is the lowest. All else must be the same for all of them, and what
  // the framebuffer has between two is nothing to be shown.
  int bands = 1, band = 0;
  // Neither background nor ground: what nothing covers has no colour and no alpha, and colours come multiplied by their alpha.
  bool transparent = false;
  int bottomRow = 0;  // the lowest that the framebuffer has: of a picture in parts, each in a framebuffer of its own
  int rows = 0;       // that it has; 0: all from there on
  bool castsShadows = true;   // false: as the setting `shadows`, but nothing casts any, on the ground neither: no shader is needed for them
  bool wet = false;           // any texel of the mask is: picks the shaders that look at it
  bool wetHair = false;       // long hair is: likewise
  bool groomed = false;       // the groom's map says more than full length of one type: likewise
  bool types = false;         // and more than one fur type
  bool painted = false;       // there is paint: likewise
  bool shaped = false;        // brushes have changed the shape of strands: likewise
  Vec4 baseColorFactor{1.0f};
  // Both are looked at while the frame is drawn; none cost nothing.
  std::span<const wet::Drop> drops;
  wet::Puddles puddles;
};

// Of the square of ground that takes the model's shadow, and water; world.
inline constexpr float kGroundHalfSide = wet::kGroundReach;

// In the order of the settings' "view" choice. README.md says what each shows.
enum class View {
  Final, Skin, Shells, Fins, Layer, Exploded, Silhouette, Coverage, Tangents, Normals, Dominance, Types, Offset,
  Wetness, Clumps, Shadow, Overdraw, Steps, Bends, Forces, Layout
};

// Whether it is a sample that is made finer than a picture which is drawn once (Samples.h).
inline bool isFiner(const Frame& frame) { return frame.sample > 0 && !frame.flows; }

Mat4 clipFromWorld(const Frame& frame);
// Pixels that a model unit covers at distance 1 from the eye; divide by the distance for others.
float pixelsPerUnit(const Frame& frame);

}  // namespace fur::render
