// The water round each texel of the mask: means over the skin near it, on whichever charts that lies, so that what is made of them shows
// no border between charts.
//
// Places are put together into cells, squares of texels of one chart about kCell wide. A mean is one of cells, weighted by
//   a (1 - d^2 / R^2)^2 n.n'
// a: the cell's area, d: the distance of its middle, n, n': the normals, so that an ear knows nothing of its other side.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "geometry/AtlasTexels.h"
#include "wet/ChangedTiles.h"
#include "wet/SurfaceTexels.h"
#include "wet/WetnessMask.h"

namespace fur::wet {

class WaterAround {
 public:
  static constexpr float kCell = 0.045f;  // model units

  // What lies round a place: of water up to 1, and above, up to 1 more.
  struct Means {
    float held, film;  // standard deviation about 0.026 model units
    float wide;        // held within 0.06
    float widest;      // within 0.09
  };

  // `placeOf`: one a texel, gutters lead to what they repeat (SurfaceTexels::placeOf()); `width`: of a place on average, model units.
  WaterAround(int size, std::span<const SurfaceTexels::Place> places, std::span<const std::uint32_t> placeOf, float width);
  explicit WaterAround(const SurfaceTexels& texels) : WaterAround(texels.size(), texels.places(), texels.placesOfTexels(), texels.meanWidth()) {}

  // Takes in what has changed there in the mask.
  void update(const WetnessMask& mask, std::span<const geometry::TexelRect> changed);
  // Where means have changed since the last call, and what was passed to update().
  std::vector<geometry::TexelRect> takeChanged() { return changed_.takeParts(); }

  // Of a texel on a chart, its gutter, or beside it up to kBeside texels off; all 0 elsewhere.
  static constexpr int kBeside = 3;
  Means at(std::size_t texel) const;
  // A length in the atlas on average, model units.
  float onSkin(float atlas) const { return atlas * static_cast<float>(size_) * width_; }

 private:
  static constexpr int kShares = 6;  // cells that a place's means are of, at most
  struct Cell {
    Vec3 centre{0}, normal{0};
    float area = 0;
    geometry::TexelRect rect;
  };
  struct Texel {
    std::uint32_t at;
    float area;
  };
  // In whole steps, so that a change ends somewhere.
  struct Water {
    float held = 0, film = 0, wide = 0, widest = 0;
    bool operator==(const Water&) const = default;
  };
  struct Share {
    std::uint8_t which[kShares], weight[kShares];  // of the cells near its own; 0: none
  };

  void makeCells(std::span<const SurfaceTexels::Place> places);
  void findNear();
  void share(std::span<const SurfaceTexels::Place> places);
  void spreadBeside(std::span<const std::uint32_t> placeOf);
  Water sum(const WetnessMask& mask, std::size_t cell) const;
  void widen();

  int size_, cellTexels_;
  float width_;                         // of a place on average
  float radius_;                        // R of the near means
  std::vector<Cell> cells_;
  std::vector<std::uint32_t> firstTexel_;        // of each cell; one more for the end
  std::vector<Texel> texels_;                    // cell by cell
  std::vector<std::uint32_t> cellOf_;   // one a place
  std::vector<std::uint32_t> nearStart_, near_;  // the cells near each, itself among them
  std::vector<float> nearWeight_;
  std::vector<Share> shares_;           // one a place
  std::vector<std::uint32_t> placeOf_;  // one a texel, some beside charts among them
  std::vector<Water> water_;            // one a cell
  ChangedTiles changed_;
  bool fresh_ = true;
};

}  // namespace fur::wet
