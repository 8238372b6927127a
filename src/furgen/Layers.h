// Cuts a coat into the maps of its layers and of its fins.
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "furgen/Coat.h"

namespace fur::furgen {

// One layer of a FurVolume; texels have the same meaning as there.
struct LayerMaps {
  std::vector<std::uint8_t> coverage, dominance, variance;
  std::vector<std::int8_t> tangent;
  std::vector<std::int16_t> offset;
  std::vector<std::uint16_t> strandId;
};

// Holds the scratch memory of one layer. The coat must outlive it.
class LayerPainter {
 public:
  explicit LayerPainter(const Coat& coat);
  ~LayerPainter();
  LayerPainter(LayerPainter&&) noexcept;

  // Layer `layer` of `layers`: the part of the coat within half a layer's spacing of its height; for the lowest layer also
  // all that lies below.
  void paint(int layer, int layers, LayerMaps& out);
  // A quarter of that work, for callers that have to stay responsive; true when the layer is complete. Until then it must be
  // called with the same layer.
  bool step(int layer, int layers, LayerMaps& out);

 private:
  struct Scratch;
  std::unique_ptr<Scratch> scratch_;
};

// `rows` rows from the skin up, `size` columns: the strands rooted in the tile's central 6 %, from the side.
struct FinMaps {
  int rows = 0;
  std::vector<std::uint8_t> coverage, dominance, variance;
  std::vector<std::int8_t> tangent;  // x runs along the edge
};
FinMaps paintFin(const Coat& coat, int rows);

// Rows of the fin map of a volume of that many layers: 64 or more.
int finRows(int layers);

// All of it at once.
FurVolume volumeOf(const Coat& coat, int layers);

// Mean of a coverage map, 0..1.
float meanCover(std::span<const std::uint8_t> coverage);

}  // namespace fur::furgen
