// The texels of the mask that lie on the model, as places on its surface between which water runs. Each place owns one texel;
// gutter texels repeat it. Places are ordered by blocks of kBlock x kBlock texels.
//
// Links connect a place with its eight neighbours in the map, and across a chart's border with the place next to it in space.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "geometry/AtlasTexels.h"
#include "geometry/Surface.h"
#include "geometry/SurfaceQuery.h"

namespace fur::wet {

class SurfaceTexels {
 public:
  static constexpr std::uint32_t kNone = 0xffffffffu;
  static constexpr int kBlock = 8;

  struct Place {
    Vec3 position, normal;  // model space
    float area;             // model units squared, > 0
    std::uint32_t texel, triangle;
  };
  static constexpr int kSides = 8;
  // The steps in the map of the eight links, in order round the texel; even ones go along u or v.
  static constexpr int kSteps[kSides][2] = {{1, 0}, {1, 1}, {0, 1}, {-1, 1}, {-1, 0}, {-1, -1}, {0, -1}, {1, -1}};
  using Links = std::array<std::uint32_t, kSides>;  // kNone: the surface ends there
  // A link across a border that leads to two places in turns, first to that of links(). Texels of two charts do not line up,
  // and each texel along a border has to be reached.
  struct Crossing {
    std::uint32_t from;
    int side;
    std::array<std::uint32_t, 2> to;
  };
  struct Block {
    std::uint32_t first, end;  // its places
    geometry::TexelRect rect;  // of texels, with the gutters that repeat them
    Vec3 centre;
    float radius;
    bool repeated = false;  // gutters repeat some of them
  };

  // Links across borders are missing until link() is done.
  SurfaceTexels(const geometry::Surface& surface, const geometry::AtlasTexels& atlas);
  // Links up to `places` more places; true when all are linked. The result does not depend on the slicing.
  bool link(const geometry::Surface& surface, const geometry::SurfaceQuery& query, std::uint32_t places);

  int size() const { return size_; }
  const std::vector<Place>& places() const { return places_; }
  const std::vector<Links>& links() const { return links_; }
  const std::vector<Block>& blocks() const { return blocks_; }
  float meanWidth() const { return meanWidth_; }  // of the places, model units
  // The blocks that links of a block's places lead to, itself not among them; once link() is done.
  std::span<const std::uint32_t> blocksBeside(std::uint32_t block) const {
    return {&besideBlocks_[besideStart_[block]], besideStart_[block + 1] - besideStart_[block]};
  }
  // The crossings from a block's places; once link() is done.
  std::span<const Crossing> crossingsFrom(std::uint32_t block) const {
    return {crossings_.data() + crossingStart_[block], crossingStart_[block + 1] - crossingStart_[block]};
  }
  std::uint32_t blockOf(std::uint32_t place) const { return blockOf_[place]; }
  // The place that owns a texel's water; kNone off the model.
  std::uint32_t placeOf(std::uint32_t texel) const { return placeOf_[texel]; }
  const std::vector<std::uint32_t>& placesOfTexels() const { return placeOf_; }  // of all
  std::uint32_t placeAt(const Vec2& atlas) const;
  // The vectors from texel to texel in u and in v along the place's triangle, model units; 0 for a triangle without area.
  std::pair<Vec3, Vec3> stepsAt(const geometry::Surface& surface, std::uint32_t place) const;
  // The coordinates of a direction along the skin in these two steps, which need not be perpendicular.
  Vec2 partsOf(const geometry::Surface& surface, std::uint32_t place, const Vec3& direction) const;
  // Calls visit(texel) for the gutter texels that repeat the place.
  template <class Visit>
  void forMirrors(std::uint32_t place, Visit visit) const {
    for (std::uint32_t i = mirrorStart_[place]; i < mirrorStart_[place + 1]; ++i) visit(mirrors_[i]);
  }
  // Calls visit(place), in order, for places within the ball whose normals do not face away from `normal`.
  template <class Visit>
  void forPlacesWithin(const Vec3& centre, const Vec3& normal, float radius, Visit visit) const {
    for (const Block& block : blocks_) {
      const Vec3 way = block.centre - centre;
      const float reach = block.radius + radius;
      if (glm::dot(way, way) > reach * reach) continue;
      for (std::uint32_t i = block.first; i < block.end; ++i) {
        const Vec3 apart = places_[i].position - centre;
        if (glm::dot(apart, apart) <= radius * radius && glm::dot(places_[i].normal, normal) > 0.0f) visit(i);
      }
    }
  }

 private:
  void joinBlocks();
  std::uint32_t acrossBorder(const geometry::Surface& surface, const geometry::SurfaceQuery& query, std::uint32_t place,
                             int side, float aside) const;

  int size_;
  float meanWidth_ = 0;
  std::uint32_t linked_ = 0;
  std::vector<Place> places_;
  std::vector<Links> links_;
  std::vector<Crossing> crossings_;
  std::vector<Block> blocks_;
  std::vector<std::uint32_t> placeOf_;  // one a texel; gutters lead to what they repeat
  std::vector<std::uint32_t> blockOf_;  // one a place
  std::vector<std::uint32_t> mirrorStart_, mirrors_;
  // One a block, and one for the end.
  std::vector<std::uint32_t> besideStart_, besideBlocks_, crossingStart_;
};

}  // namespace fur::wet
