// A sphere in several charts and a plain groom on it: where the groom's tests work.
#pragma once

#include "geometry/Adjacency.h"
#include "geometry/Primitives.h"
#include "groom/Groom.h"

namespace fur::groom {

inline geometry::Surface chartedSphere() {
  geometry::Mesh mesh = geometry::makeSphere();
  mesh.uv.clear();
  return geometry::buildSurface(mesh).value();
}

struct Setting {
  explicit Setting(int size = 256, geometry::Surface given = chartedSphere())
      : surface(std::move(given)), query(surface), atlas(surface, size), points(surface), groom(plainGroom(size, points)) {}
  GroomSurface groomSurface() const { return {surface, query, atlas, points}; }
  // Calls visit(texel, position) for every texel of the surface.
  template <class Visit>
  void forTexels(Visit visit) const {
    for (std::uint32_t t = 0; t < surface.triangleCount(); ++t)
      atlas.forTexelsOf(surface, t, [&](std::uint32_t texel, const Vec3& weights) {
        visit(texel, positionAt(surface, geometry::SurfacePoint{t, weights, 0}));
      });
  }

  geometry::Surface surface;
  geometry::SurfaceQuery query;
  geometry::AtlasTexels atlas;
  SurfacePoints points;
  Groom groom;
};

}  // namespace fur::groom
