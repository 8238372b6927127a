// Whiskers and tufts: hairs that stand out of the coat one by one (Sheppard 2004, 3.2.2, calls them rogue hairs).
//
// A whisker grows from a point of the skin and is one hair, or a tuft of up to kMostHairs that fan out. A hair is an arc of
// constant length with a slight bend of its own. It also bends with the coat round its root (dynamics::BendField), by less
// the stiffer it is.
//
// A whisker stores its root's position and not its triangle, as triangles are numbered differently by another fur mapping and
// in a saved file. Lengths are in model units.
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
  float stiffness = 0.6f;   // 0..1: 1 - the share of the coat's bend that it takes
  std::uint32_t hairs = 1, seed = 1;
  std::uint32_t color = 0xffffff;  // 0xRRGGBB, sRGB
  bool operator==(const Whisker& other) const { return std::memcmp(this, &other, sizeof other) == 0; }
};
// Files and JavaScript get it as it is in memory (little-endian).
inline constexpr std::size_t kWhiskerBytes = 52;
static_assert(sizeof(Whisker) == kWhiskerBytes);
// As many as the bytes hold; they may be invalid.
std::vector<Whisker> readWhiskers(std::span<const std::uint8_t> bytes);

// The point of the surface at the whisker's root; none when there is none near.
std::optional<geometry::SurfacePoint> rootOf(const Whisker& whisker, const geometry::SurfaceQuery& query);
// Clamps the values of a whisker from outside; false when a number is not finite or it has no direction.
bool makeSound(Whisker& whisker);
// Keeps the valid ones that stand on the surface, at most kMostWhiskers.
void keepSound(std::vector<Whisker>& whiskers, const geometry::SurfaceQuery& query);
// The direction of a whisker whose tip is moved by `pull` (model space); upright for 0.
Vec3 pulledDirection(const Vec3& normal, float length, const Vec3& pull);

// A hair for the renderer: floats only, in the order of shaders/es3/shared/Blocks.h.
struct WhiskerHair {
  Vec3 root;
  float width;
  Vec3 direction;
  float length;
  Vec3 curve;   // its own bend: radians, across the direction
  float give;   // share of the coat's bend that it takes
  Vec3 normal;  // of the skin
  float shade;  // its random number, 0..1
  Vec3 color;   // linear
  float atlasU;
  Vec3 vertices;  // indices of its triangle's vertices
  float atlasV;
  Vec3 weights;   // barycentric
};

// The hairs of all whiskers, in order; deterministic. A whisker off the surface has none.
std::vector<WhiskerHair> whiskerHairs(std::span<const Whisker> whiskers, const geometry::Surface& surface,
                                      const geometry::SurfaceQuery& query);
// The bend of a hair, with one bend of the coat for each vertex (BendField::bends()). Radians, perpendicular to its direction.
Vec3 hairBend(const WhiskerHair& hair, std::span<const Vec4> bends);
// Points from root to tip at even steps along the arc: the twin of whisker.vert. The polyline is at most 0.8 % shorter than
// the hair, which bends by 3 rad at most: its own 0.65 and dynamics::kMostPressed.
std::array<Vec3, kHairPoints> hairPoints(const WhiskerHair& hair, std::span<const Vec4> bends);

}  // namespace fur::groom
