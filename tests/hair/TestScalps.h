// Surfaces with scalps on them: where the tests of guides and wisps work.
#pragma once

#include "geometry/AtlasTexels.h"
#include "geometry/Primitives.h"
#include "geometry/SurfaceQuery.h"
#include "hair/PlantGuides.h"

namespace fur::hair::test {

struct TestScalp {
  explicit TestScalp(const geometry::Mesh& mesh, int size = 128)
      : surface(geometry::buildSurface(mesh).value()), query(surface), map(size, groom::GroomMap::kBlank), atlas(surface, size) {
    paint([](const Vec3&) { return groom::GroomMap::Texel{255, 255, 255, 255}; });
  }

  // The texel for each place, by visit(position).
  template <class Visit>
  void paint(Visit visit) {
    for (std::uint32_t t = 0; t < surface.triangleCount(); ++t)
      atlas.forTexelsOf(surface, t, [&](std::uint32_t texel, const Vec3& weights) {
        map.set(texel, visit(positionAt(surface, geometry::SurfacePoint{t, weights, 0})));
      });
    map.fillGutter(atlas, {0, 0, map.size(), map.size()});
  }

  ScalpSurface scalp() const { return {surface, map}; }
  std::vector<RootFrame> roots(const Guides& guides) const { return rootFrames(surface, query, guides); }

  geometry::Surface surface;
  geometry::SurfaceQuery query;
  groom::GroomMap map;
  geometry::AtlasTexels atlas;
};

// Straight guides from these places, leaning by `lean(place)`.
template <class Lean>
Guides guidesAt(const std::vector<Vec3>& places, Lean lean, int nodes = 8) {
  Guides out;
  out.nodes = nodes;
  out.flags.assign(places.size(), 0);
  for (const Vec3& place : places)
    for (int i = 0; i < nodes; ++i) out.positions.push_back(place + lean(place) * (static_cast<float>(i) / static_cast<float>(nodes - 1)));
  return out;
}

}  // namespace fur::hair::test
