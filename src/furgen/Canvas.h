// A small picture onto which strands are drawn as swept discs, softened over a texel. Knows of every
// texel how much of it is covered and what covers most of it.
#pragma once

#include <cstdint>
#include <vector>

#include "core/Math.h"

namespace fur::furgen {

// Straight way of a disc, in texels across.
struct Stroke {
  Vec2 from, way;
  float radius;
  std::uint16_t strand;  // strokes of one strand, one after the other, cover a texel together as one
};

class Canvas {
 public:
  // `columns` is a power of two: they wrap round. Rows wrap if `rowsWrap` (then they must be a power of two
  // too); a row is `pitch` texels high.
  Canvas(int columns, int rows, bool rowsWrap, float pitch);

  void clear();
  // `id` (not 0) is what owner() tells of texels that this stroke covers most.
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
  // The strands' shares added up; the share and the name of the strand that was drawn last; the largest
  // share of any.
  std::vector<float> cover_, own_, strongest_;
  std::vector<std::uint16_t> ownStrand_;
  std::vector<std::uint32_t> owner_;
};

}  // namespace fur::furgen
