// Whiskers and tufts: hairs that stand out of the coat one by one (Sheppard 2004, 3.2.2, calls them rogue hairs).
//
// A whisker is planted at a point of the skin and is one hair, or a tuft of up to kMostHairs that fan out. A hair is an
// arc of constant length, slightly bent of its own, which leans as the coat round its root does: wind, weight and comb
// move it by the law that moves shells and fins (dynamics::BendField), by less the stiffer it is.
//
// A whisker keeps where it stands in space and not on which triangle: another fur mapping and a saved file number those
// otherwise. Lengths are in model units, the bounding radii of the model. Knows no picture and no time.
#pragma once

#include <array>
#include <cstdint>
#include <cstring>
#include <optional>
#include <span>
#include <vector>

#include "geometry/Surface.h"
#include "geometry/SurfaceQuery.h"

namespace fur::groom {

inline constexpr std::size_t kMostWhiskers = 512;
inline constexpr std::uint32_t kMostHairs = 8;
inline constexpr int kHairPoints = 8;  // as many as Sheppard's have

struct Whisker {
  Vec3 root{0};
  Vec3 direction{0, 1, 0};  // unit: where it leaves the skin
  float length = 0.45f;     // of its longest hair
  float width = 0.004f;     // of a hair at its root; it tapers to nothing
  float spread = 0.3f;      // 0..1: how far the hairs of a tuft fan out
  float stiffness = 0.6f;   // 0..1: the share of the coat's lean that it does not take
  std::uint32_t hairs = 1, seed = 1;
  std::uint32_t color = 0xffffff;  // 0xRRGGBB, sRGB
  bool operator==(const Whisker& other) const { return std::memcmp(this, &other, sizeof other) == 0; }
};
// Files and other programs get it as it lies in memory (little-endian).
inline constexpr std::size_t kWhiskerBytes = 52;
static_assert(sizeof(Whisker) == kWhiskerBytes);
// As many as the bytes hold, unsound ones too.
std::vector<Whisker> readWhiskers(std::span<const std::uint8_t> bytes);

// Where the hair comes out of the skin, close to its root; none where that is off the surface.
std::optional<geometry::SurfacePoint> rootOf(const Whisker& whisker, const geometry::SurfaceQuery& query);
// Brings one from anywhere within bounds; false when a number of it is not finite or it points nowhere.
bool makeSound(Whisker& whisker);
// Leaves those that are sound and stand on the surface, the first kMostWhiskers of them.
void keepSound(std::vector<Whisker>& whiskers, const geometry::SurfaceQuery& query);
// Where a whisker points that is pulled by `pull` (model space) while its root is held: 0 is straight up.
Vec3 pulledDirection(const Vec3& normal, float length, const Vec3& pull);

// A hair as the renderer takes it: floats alone, in the order of shaders/es3/shared/Blocks.h.
struct WhiskerHair {
  Vec3 root;
  float width;
  Vec3 direction;
  float length;
  Vec3 curve;   // its own bend: radians, across the direction
  float give;   // share of the coat's lean that it takes
  Vec3 normal;  // of the skin
  float shade;  // its random number, 0..1
  Vec3 color;   // linear
  float atlasU;
  Vec3 vertices;  // the three of its triangle, and their shares of what happens there
  float atlasV;
  Vec3 weights;
};

// The same hairs for the same whiskers, those of one whisker one after another. None for one off the surface.
std::vector<WhiskerHair> whiskerHairs(std::span<const Whisker> whiskers, const geometry::Surface& surface,
                                      const geometry::SurfaceQuery& query);
// How a hair is bent where the coat is so: one bend a vertex, as BendField::bends(). Radians, across its direction.
Vec3 hairBend(const WhiskerHair& hair, std::span<const Vec4> bends);
// Root to tip, even steps along the arc: the twin of whisker.vert. Straight lines between them are at most 0.8 % shorter
// than the hair, which turns by 3 rad at most: its own 0.65 and dynamics::kMostPressed.
std::array<Vec3, kHairPoints> hairPoints(const WhiskerHair& hair, std::span<const Vec4> bends);

}  // namespace fur::groom
