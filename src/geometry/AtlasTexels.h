// A square map over the atlas, texel by texel: which triangle lies under it, and where on that triangle.
//
// A texel belongs to the triangle that contains its centre; a triangle too small to contain any centre gets the texels under
// its corners. Round each chart runs a gutter of kGutter texels; each repeats the nearest texel of a chart, so that
// filtering at a border does not mix charts. Deterministic.
#pragma once

#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "geometry/Surface.h"

namespace fur::geometry {

// Texels [x0, x1) x [y0, y1); empty when x0 >= x1.
struct TexelRect {
  int x0 = 0, y0 = 0, x1 = 0, y1 = 0;
  bool empty() const { return x0 >= x1 || y0 >= y1; }
  bool meets(const TexelRect& other) const { return x0 < other.x1 && other.x0 < x1 && y0 < other.y1 && other.y0 < y1; }
  void include(int x, int y);
  bool operator==(const TexelRect&) const = default;
};
TexelRect unite(const TexelRect& a, const TexelRect& b);

// The atlas corners of a triangle, in texels whose centres are whole numbers, counter-clockwise.
struct AtlasTriangle {
  AtlasTriangle(const Vec2& a, const Vec2& b, const Vec2& c, int size);
  // Whether a square of 2 * margin texels round the texel's centre meets the triangle; for texels of bounds(margin) only.
  // False for a triangle without area.
  bool meets(int x, int y, float margin) const;
  // The texels that may meet it, within the map.
  TexelRect bounds(float margin) const;

  Vec2 p[3];
  float area;  // twice
  int size;
};

class AtlasTexels {
 public:
  static constexpr int kGutter = 2;

  // `without`: one a triangle, those that have no texels, nor others where these and their gutters would be; empty: all have.
  AtlasTexels(const Surface& surface, int size, std::span<const std::uint8_t> without = {});

  int size() const { return size_; }
  // size * size, row-major; kNoTriangle (Adjacency.h) in gutters and between charts.
  const std::vector<std::uint32_t>& triangleOf() const { return triangleOf_; }
  // Pairs of a gutter texel and the texel that it repeats; row-major.
  const std::vector<std::pair<std::uint32_t, std::uint32_t>>& gutter() const { return gutter_; }

  // Calls visit(texel, weights) for each texel of the triangle. The weights are barycentric, of the texel's centre, or of
  // a point of the triangle near it where the centre lies outside.
  template <class Visit>
  void forTexelsOf(const Surface& surface, std::uint32_t triangle, Visit visit) const {
    const AtlasTriangle flat = flatten(surface, triangle);
    const TexelRect box = flat.bounds(1.0f);
    for (int y = box.y0; y < box.y1; ++y)
      for (int x = box.x0; x < box.x1; ++x) {
        const auto texel = static_cast<std::uint32_t>(y * size_ + x);
        if (triangleOf_[texel] == triangle) visit(texel, weightsAt(surface, triangle, texel));
      }
  }
  Vec3 weightsAt(const Surface& surface, std::uint32_t triangle, std::uint32_t texel) const;

 private:
  AtlasTriangle flatten(const Surface& surface, std::uint32_t triangle) const;
  void rasterise(const Surface& surface);
  void growGutter();
  void leaveOut(std::span<const std::uint8_t> without);

  int size_;
  std::vector<std::uint32_t> triangleOf_;
  std::vector<std::pair<std::uint32_t, std::uint32_t>> gutter_;
};

}  // namespace fur::geometry
