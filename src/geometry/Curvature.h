// How a surface curves: the shape operator of every vertex.
#pragma once

#include <cstdint>
#include <vector>

#include "geometry/Surface.h"
#include "geometry/Weld.h"

namespace fur::geometry {

// Sets SurfaceVertex::curvature from how the vertex normals turn over the triangles round a point: one fit a
// triangle, means weighted by area (Rusinkiewicz 2004, "Estimating Curvatures and Their Derivatives on Triangle
// Meshes"), so that vertices of one position share one. `triangles` cover the surface once; `weld` is over all its
// vertices; gradS must be set. `turned` as in SurfaceSteps.h: how far normals turn along the skin, whichever way that lies.
void computeCurvature(Surface& surface, const std::vector<std::uint32_t>& triangles, const Weld& weld, bool turned = false);

// The least rotation from one unit vector to another; between opposite ones none.
glm::dmat3 turnBetween(const glm::dvec3& from, const glm::dvec3& to);

// The axes that `curvature` is given in: along gradS, and across it and the normal.
void tangentAxes(const SurfaceVertex& vertex, Vec3& s, Vec3& t);

}  // namespace fur::geometry
