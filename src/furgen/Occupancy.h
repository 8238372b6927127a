// Collision tests between strands on the torus, at every height.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "furgen/Coat.h"

namespace fur::furgen {

class Occupancy {
 public:
  // `maxRadius`: of the widest strand, texels.
  Occupancy(int size, float maxRadius);

  // Tests at the skin only, which decides most cases.
  bool collides(const Vec2& root, float radius) const;
  bool collides(const Vec2& root, std::span<const Node> nodes) const;
  void add(const Vec2& root, std::span<const Node> nodes);

 private:
  // A straight piece of a strand inside one of the kPlanes slices of the volume.
  struct Piece {
    Vec2 middle;  // in [0, size)^2
    Vec2 half;    // from the middle to the upper end
    float low, high;            // heights
    float lowRadius, highRadius;
    std::int32_t next;
  };

  struct CellRange {
    int first, count;
  };

  static Piece pieceBetween(const Vec2& root, const Node& a, const Node& b);
  bool touches(const Piece& a, const Piece& b) const;
  bool collides(int slice, const Piece& piece) const;
  CellRange cellsAround(float x, float reach) const;
  int cellOf(float x) const;
  std::size_t cellAt(int slice, int x, int y) const;

  float size_;
  int cells_;
  float cellSize_;
  std::vector<std::int32_t> heads_;   // [slice][y][x]
  std::vector<float> widest_;         // per slice: the largest extent of a piece from its middle, radius included
  std::vector<Piece> pieces_;
};

}  // namespace fur::furgen
