#include <algorithm>
#include <cmath>

#include "furgen/Canvas.h"
#include "furgen/Layers.h"
#include "furgen/NearestFill.h"
#include "furgen/Packing.h"

namespace fur::furgen {

namespace {

constexpr float kFinStrip = 0.06f;  // share of the tile whose strands make the fin map (Sheppard 4.2.3)

// A piece of a strand as the fin shows it.
struct Piece {
  std::uint16_t strand;
  std::int8_t tangent[3];
};

void drawStrand(const Coat& coat, std::uint16_t index, Canvas& canvas, std::vector<Piece>& pieces) {
  const Strand& strand = coat.strands[index];
  const auto nodes = coat.nodesOf(strand);
  for (std::size_t i = 0; i + 1 < nodes.size(); ++i) {
    const Node& a = nodes[i];
    const Node& b = nodes[i + 1];
    Piece piece{index, {}};
    packTangent(b.shift - a.shift, b.height - a.height, piece.tangent);
    pieces.push_back(piece);
    const Vec2 from(strand.root.x + a.shift.x, a.height * kHeightTexels);
    const Vec2 to(strand.root.x + b.shift.x, b.height * kHeightTexels);
    canvas.draw({from, to - from, 0.5f * (a.radius + b.radius), index}, static_cast<std::uint32_t>(pieces.size()));
  }
}

// Empty texels take the nearest piece of their row; an empty row takes that of the row below.
void fillRows(std::vector<std::uint32_t>& owners, int columns) {
  for (std::size_t row = 0; row < owners.size(); row += static_cast<std::size_t>(columns)) {
    std::uint32_t* first = &owners[row];
    if (!fillRow(first, columns) && row) std::copy_n(first - columns, columns, first);
  }
}

}  // namespace

FinMaps paintFin(const Coat& coat, int rows) {
  const int size = coat.parameters.size;
  const float extent = static_cast<float>(size);
  Canvas canvas(size, rows, false, kHeightTexels / static_cast<float>(rows));
  std::vector<Piece> pieces;
  for (std::size_t i = 0; i < coat.strands.size(); ++i)
    if (std::abs(coat.strands[i].root.y - 0.5f * extent) < 0.5f * kFinStrip * extent)
      drawStrand(coat, static_cast<std::uint16_t>(i), canvas, pieces);
  std::vector<std::uint32_t>& owners = canvas.owners();
  fillRows(owners, size);

  FinMaps out;
  out.rows = rows;
  out.coverage.resize(owners.size()), out.dominance.assign(owners.size(), 255), out.variance.resize(owners.size());
  out.tangent.assign(owners.size() * 3, 0);
  for (std::size_t texel = 0; texel < owners.size(); ++texel) {
    out.coverage[texel] = unitByte(canvas.cover(texel));
    out.tangent[texel * 3 + 2] = 127;
    if (owners[texel] == 0) continue;
    const Piece& piece = pieces[owners[texel] - 1];
    out.dominance[texel] = unitByte(coat.strands[piece.strand].dominance);
    out.variance[texel] = unitByte(coat.strands[piece.strand].variance);
    std::copy(piece.tangent, piece.tangent + 3, &out.tangent[texel * 3]);
  }
  return out;
}

}  // namespace fur::furgen
