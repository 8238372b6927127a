// Which strands stand where: answers whether a new one would touch any, at any height, round the torus.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "furgen/Coat.h"

namespace fur::furgen {

class Occupancy {
 public:
  // `maxRadius`: no strand is wider, in texels.
  Occupancy(int size, float maxRadius);

  // At the skin alone, which settles most of the cases.
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
  std::vector<float> widest_;         // per slice: the farthest that a piece reaches from its middle, with its radius
  std::vector<Piece> pieces_;
};

}  // namespace fur::furgen
