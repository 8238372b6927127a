// A scalp: where on the model long hair grows, its guides and its numbers. A model has up to kMostScalps: a mane, a tail, a forelock.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "groom/Groom.h"
#include "hair/Body.h"
#include "hair/Guides.h"
#include "hair/HairValues.h"

namespace fur::hair {

inline constexpr std::size_t kMostScalps = 8;

// A name of at most 64 bytes, whole characters of UTF-8.
std::string soundName(std::string_view name);

struct Scalp {
  std::string name = "hair";
  HairValues values;
  // Over the model's atlas: r density, g width, b length, a rotation (Wisps.h). Black is no scalp.
  groom::GroomMap map{groom::GroomMap::kUsualSize, groom::GroomMap::kBlank};
  Guides guides;
  std::vector<std::uint8_t> wetness;  // in files, of each node: 200 is soaked, 250 the most. Empty: dry
};

// Moves the density towards `density` in balls (model space; w: radius), all of the way but for the outermost eighth of the radius.
void paintDensity(groom::GroomMap& map, const groom::GroomSurface& skin, std::span<const Vec4> balls, float density);

struct Hairstyle {
  std::vector<Scalp> scalps;  // up to kMostScalps
  std::vector<Body> bodies;  // up to kMostBodies
  bool empty() const { return scalps.empty() && bodies.empty(); }
};

}  // namespace fur::hair
