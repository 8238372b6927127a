// A small picture onto which strands are drawn as swept discs with edges one texel wide. It has, for each texel, its coverage
// and the strand that covers most of it.
#pragma once

#include <cstdint>
#include <vector>

#include "core/Math.h"

namespace fur::furgen {

// A disc swept along a straight line, in texels.
struct Stroke {
  Vec2 from, way;
  float radius;
  std::uint16_t strand;  // consecutive strokes of one strand do not cover a texel twice
};

class Canvas {
 public:
  // Columns wrap round; `columns` is a power of two. Rows wrap if `rowsWrap`, and are then a power of two as well. A row is
  // `pitch` texels high.
  Canvas(int columns, int rows, bool rowsWrap, float pitch);

  void clear();
  // `id` (not 0): what owners() has for texels that this stroke covers most.
  void draw(const Stroke& stroke, std::uint32_t id);

  int columns() const { return columns_; }
  int rows() const { return rows_; }
  // 0..1, row-major.
  float cover(std::size_t texel) const { return cover_[texel]; }
  std::vector<std::uint32_t>& owners() { return owner_; }

 private:
  int columns_, rows_;
  bool rowsWrap_;
  float pitch_;
  // The sum of all strands' shares, the share of the strand drawn last, and the largest share of any strand.
  std::vector<float> cover_, own_, strongest_;
  std::vector<std::uint16_t> ownStrand_;
  std::vector<std::uint32_t> owner_;
};

}  // namespace fur::furgen
