#include "furgen/Occupancy.h"

#include <algorithm>
#include <cmath>

namespace fur::furgen {

namespace {

float wrapped(float x, float size) { return x - size * std::floor(x / size); }

int sliceOf(float low, float high) {
  return std::clamp(static_cast<int>(0.5f * (low + high) * kPlanes), 0, kPlanes - 1);
}

float reachOf(const Vec2& half, float radius) { return std::max(std::abs(half.x), std::abs(half.y)) + radius; }

}  // namespace

Occupancy::Occupancy(int size, float maxRadius) : size_(static_cast<float>(size)) {
  cells_ = std::max(1, static_cast<int>(size_ / std::max(2.5f * maxRadius, 1.0f)));
  cellSize_ = size_ / static_cast<float>(cells_);
  heads_.assign(static_cast<std::size_t>(kPlanes) * cells_ * cells_, -1);
  widest_.assign(kPlanes, 0.0f);
}

int Occupancy::cellOf(float x) const { return std::min(static_cast<int>(x / cellSize_), cells_ - 1); }

std::size_t Occupancy::cellAt(int slice, int x, int y) const {
  return (static_cast<std::size_t>(slice) * cells_ + y) * cells_ + x;
}

Occupancy::Piece Occupancy::pieceBetween(const Vec2& root, const Node& a, const Node& b) {
  const Node& low = a.height <= b.height ? a : b;
  const Node& high = a.height <= b.height ? b : a;
  return {root + 0.5f * (low.shift + high.shift), 0.5f * (high.shift - low.shift), low.height, high.height,
          low.radius, high.radius, -1};
}

// Within the heights that both have in common their distance and their radii run straight, so that the
// gap between them, squared, is a quadratic in the height.
bool Occupancy::touches(const Piece& a, const Piece& b) const {
  const float low = std::max(a.low, b.low), high = std::min(a.high, b.high);
  if (low > high) return false;
  const auto at = [](const Piece& p, float h) { return p.high > p.low ? (h - p.low) / (p.high - p.low) : 0.5f; };
  const float a0 = at(a, low), a1 = at(a, high), b0 = at(b, low), b1 = at(b, high);
  const Vec2 middles(torusDelta(a.middle.x, b.middle.x, size_), torusDelta(a.middle.y, b.middle.y, size_));
  const Vec2 d0 = middles + a.half * (2 * a0 - 1) - b.half * (2 * b0 - 1);
  const Vec2 d1 = middles + a.half * (2 * a1 - 1) - b.half * (2 * b1 - 1);
  const auto radius = [](const Piece& p, float t) { return p.lowRadius + (p.highRadius - p.lowRadius) * t; };
  const float r0 = radius(a, a0) + radius(b, b0), r1 = radius(a, a1) + radius(b, b1);
  const float c = d0.x * d0.x + d0.y * d0.y - r0 * r0;
  if (c < 0) return true;
  if (d1.x * d1.x + d1.y * d1.y < r1 * r1) return true;
  const Vec2 d = d1 - d0;
  const float r = r1 - r0;
  const float square = d.x * d.x + d.y * d.y - r * r, slope = d0.x * d.x + d0.y * d.y - r0 * r;
  if (square <= 0 || slope >= 0 || -slope >= square) return false;
  return c * square < slope * slope;
}

// The cells that [x - reach, x + reach] touches round the torus, each once.
Occupancy::CellRange Occupancy::cellsAround(float x, float reach) const {
  const int first = static_cast<int>(std::floor((x - reach) / cellSize_));
  const int last = static_cast<int>(std::floor((x + reach) / cellSize_));
  return {(first % cells_ + cells_) % cells_, std::min(last - first + 1, cells_)};
}

bool Occupancy::collides(int slice, const Piece& piece) const {
  const float reach = reachOf(piece.half, std::max(piece.lowRadius, piece.highRadius)) + widest_[slice];
  const CellRange columns = cellsAround(piece.middle.x, reach), rows = cellsAround(piece.middle.y, reach);
  for (int dy = 0; dy < rows.count; ++dy) {
    const int y = (rows.first + dy) % cells_;
    for (int dx = 0; dx < columns.count; ++dx) {
      const int x = (columns.first + dx) % cells_;
      for (std::int32_t i = heads_[cellAt(slice, x, y)]; i >= 0; i = pieces_[i].next)
        if (touches(piece, pieces_[i])) return true;
    }
  }
  return false;
}

bool Occupancy::collides(const Vec2& root, float radius) const {
  return collides(0, Piece{root, Vec2(0), 0.0f, 0.0f, radius, radius, -1});
}

bool Occupancy::collides(const Vec2& root, std::span<const Node> nodes) const {
  for (std::size_t i = 0; i + 1 < nodes.size(); ++i)
    if (collides(sliceOf(nodes[i].height, nodes[i + 1].height), pieceBetween(root, nodes[i], nodes[i + 1]))) return true;
  return false;
}

void Occupancy::add(const Vec2& root, std::span<const Node> nodes) {
  for (std::size_t i = 0; i + 1 < nodes.size(); ++i) {
    Piece piece = pieceBetween(root, nodes[i], nodes[i + 1]);
    piece.middle = {wrapped(piece.middle.x, size_), wrapped(piece.middle.y, size_)};
    const int slice = sliceOf(piece.low, piece.high);
    std::int32_t& first = heads_[cellAt(slice, cellOf(piece.middle.x), cellOf(piece.middle.y))];
    piece.next = first;
    first = static_cast<std::int32_t>(pieces_.size());
    widest_[slice] = std::max(widest_[slice], reachOf(piece.half, std::max(piece.lowRadius, piece.highRadius)));
    pieces_.push_back(piece);
  }
}

}  // namespace fur::furgen
