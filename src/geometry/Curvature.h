// How a surface curves: the shape operator of every vertex.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "geometry/Surface.h"
#include "geometry/Weld.h"

namespace fur::geometry {

// Sets SurfaceVertex::curvature from how vertex normals change over the triangles round a point: a fit for each triangle,
// averaged by area (Rusinkiewicz 2004, "Estimating Curvatures and Their Derivatives on Triangle Meshes"), then smoothed by the same areas.
// Vertices of one position get the same. `triangles` cover the surface once; `weld` is over all its vertices; gradS must be set.
// `turned`: see SurfaceSteps.h.
void computeCurvature(Surface& surface, const std::vector<std::uint32_t>& triangles, const Weld& weld, bool turned = false);

// The same for a surface that moves, in single precision: of each triangle the map from ways in it to how the normal turns along them.
class MovingCurvature {
 public:
  // `triangles` may cover the surface several times. Vertices at one position get the same.
  MovingCurvature(std::span<const std::uint32_t> triangles, const std::vector<Vec3>& positions);
  // As many positions and unit normals as there were.
  void update(std::span<const Vec3> positions, std::span<const Vec3> normals);
  // Of a vertex, along its tangent axes: (ss, st, tt), 1 / unit.
  Vec3 along(std::uint32_t vertex, const Vec3& s, const Vec3& t) const;

 private:
  std::vector<std::uint32_t> triangles_;
  Weld weld_;
  std::vector<Vec3> sums_;  // four a position: the columns of the operator, times the area, and (area, 0, 0)
};

// Sets hessianS and hessianT from how gradS and gradT, which must be set, change over `triangles`: fits and means as above. `pointOf`: as
// furPoints() in SurfaceSteps.h has it, one mean for each.
void computeHessians(Surface& surface, const std::vector<std::uint32_t>& triangles, const std::vector<std::uint32_t>& pointOf);

// The smallest rotation from one unit vector to another; the identity for opposite ones.
glm::dmat3 turnBetween(const glm::dvec3& from, const glm::dvec3& to);

// The tangent axes of `curvature`: s along gradS, t = across the normal and s.
void tangentAxes(const SurfaceVertex& vertex, Vec3& s, Vec3& t);

}  // namespace fur::geometry
