// Cuts a coat into the maps of its layers and of its fins.
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "furgen/Coat.h"

namespace fur::furgen {

// One layer of a FurVolume, with the same meaning of every texel.
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

  // Layer `layer` of `layers`: what of the coat stands within half a layer's spacing of its height;
  // of the lowest layer all that lies below, too.
  void paint(int layer, int layers, LayerMaps& out);
  // A fourth of that, for callers who must not stay away long; true when the layer is whole. The same layer is to
  // be asked for until then.
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
