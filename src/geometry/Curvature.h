// How a surface curves: the shape operator of every vertex.
#pragma once

#include <cstdint>
#include <vector>

#include "geometry/Surface.h"
#include "geometry/Weld.h"

namespace fur::geometry {

// Sets SurfaceVertex::curvature from how vertex normals change over the triangles round a point: a fit for each triangle,
// averaged by area (Rusinkiewicz 2004, "Estimating Curvatures and Their Derivatives on Triangle Meshes"). Vertices of one
// position get the same. `triangles` cover the surface once; `weld` is over all its vertices; gradS must be set.
// `turned`: see SurfaceSteps.h.
void computeCurvature(Surface& surface, const std::vector<std::uint32_t>& triangles, const Weld& weld, bool turned = false);

// Sets hessianS and hessianT from how gradS and gradT, which must be set, change over `triangles`: fits and means as above. `pointOf`: as
// furPoints() in SurfaceSteps.h has it, one mean for each.
void computeHessians(Surface& surface, const std::vector<std::uint32_t>& triangles, const std::vector<std::uint32_t>& pointOf);

// The smallest rotation from one unit vector to another; the identity for opposite ones.
glm::dmat3 turnBetween(const glm::dvec3& from, const glm::dvec3& to);

// The tangent axes of `curvature`: s along gradS, t = across the normal and s.
void tangentAxes(const SurfaceVertex& vertex, Vec3& s, Vec3& t);

}  // namespace fur::geometry
