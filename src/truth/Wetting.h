// Where water takes a strand: the forward formulas of Silva et al. 2010, whose inverse the shaders take at each step (wet/Clump.h).
// A strand belongs to the clump in whose texel of the mask it roots. What the paper leaves open is as src/render/README.md has it:
// wet strands lie down the way they lean and stand lower, soaked clumps open a little, each clump holds smaller locks, and short fur
// stands in tufts. Here a strand keeps its length to the end, and one that roots in a clump's rim is no shorter than the others.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "shared/Blocks.h"
#include "truth/FurMap.h"
#include "truth/Strands.h"
#include "wet/MaskTexels.h"

namespace fur::truth {

class Wetting {
 public:
  // `mask`: all of it, as the shaders read it (wet/MaskEncoding.h). All three must outlive this.
  Wetting(const FurMap& map, const wet::MaskTexels& mask, const render::shared::FurBlock& coat);
  Wetting(const FurMap& map, const wet::MaskTexels& mask, render::shared::FurBlock&& coat) = delete;

  // Of one strand.
  struct Strand {
    Wetness water;
    glm::dvec2 root, centre;  // tile; of its clump
    glm::dvec2 lock;          // the middle of its lock in the clump, or of its tuft
    float tufts = 0;          // wet::tuftsOf()
    float drawn = 0;          // wet::clumpingWetness(); 0: it belongs to no clump
    glm::dvec2 lean{0};       // of the tip, tiles
    float top = 1;            // wet::wetTop()
    float shorter = 1;        // wet::rimTaper()
  };
  // None where it is dry.
  std::optional<Strand> at(const Root& root) const;
  // s of Eq. 1, 0 at the root; a strand goes first to the middle of its lock, by wet::lockPull() or wet::tuftPull().
  float pullAt(const Strand& strand, float h) const;
  // Where the place `dry` of a strand, tile coordinates at height h, is when it is wet; and its share of the coat's height.
  glm::dvec2 tileAt(const Strand& strand, const glm::dvec2& dry, float h) const;
  float heightAt(const Strand& strand, float h) const { return h * strand.top; }

 private:
  glm::dvec2 centreOf(const Root& root, const Vec2& centre) const;
  glm::dvec2 lockOf(const glm::dvec2& tile) const;

  const FurMap& map_;
  const wet::MaskTexels& mask_;
  const render::shared::FurBlock& coat_;
  std::vector<std::array<std::uint8_t, 2>> lockCentres_;  // furgen/LockCentres.h
  double locksPerTile_;
};

// How wet the mask is there, 0 dry, 1 saturated and more; between texels the nearest. Numbers that are none count as dry.
float wetnessAt(const wet::MaskTexels& mask, const Vec2& atlas);

}  // namespace fur::truth
