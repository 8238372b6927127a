// Solids with hard edges, as programs for construction make them: few triangles, flat normals, a vertex for each face.
#pragma once

#include <initializer_list>
#include <vector>

#include "geometry/Mesh.h"

namespace fur::geometry::test {

// A flat convex face, counter-clockwise from outside.
inline void addFace(Mesh& mesh, const std::vector<Vec3>& corners) {
  const auto first = static_cast<std::uint32_t>(mesh.positions.size());
  const Vec3 normal = glm::normalize(glm::cross(corners[1] - corners[0], corners[2] - corners[0]));
  for (const Vec3& corner : corners) mesh.positions.push_back(corner), mesh.normals.push_back(normal);
  for (std::uint32_t k = 2; k < corners.size(); ++k) mesh.indices.insert(mesh.indices.end(), {first, first + k - 1, first + k});
}

// A polygon in x and y, counter-clockwise, as thick as 2 z: its sides, and caps made of `parts` of it, which are convex.
inline Mesh makePrism(const std::vector<Vec2>& outline, const std::vector<std::vector<std::size_t>>& parts, float z) {
  Mesh mesh;
  for (std::size_t i = 0; i < outline.size(); ++i) {
    const Vec2 a = outline[i], b = outline[(i + 1) % outline.size()];
    addFace(mesh, {Vec3(a, -z), Vec3(b, -z), Vec3(b, z), Vec3(a, z)});
  }
  for (const auto& part : parts) {
    std::vector<Vec3> front, back;
    for (const std::size_t i : part) front.push_back(Vec3(outline[i], z)), back.insert(back.begin(), Vec3(outline[i], -z));
    addFace(mesh, front);
    addFace(mesh, back);
  }
  fitToUnitSphere(mesh);
  return mesh;
}

inline Mesh makeBox(float x, float y, float z) {
  return makePrism({{-x, -y}, {x, -y}, {x, y}, {-x, y}}, {{0, 1, 2, 3}}, z);
}
inline Mesh makeCube() { return makeBox(1, 1, 1); }
inline Mesh makePlate() { return makeBox(1, 0.7f, 0.025f); }
inline Mesh makeRod() { return makeBox(0.04f, 1, 0.04f); }
inline Mesh makeL() {
  return makePrism({{-1, -1}, {1, -1}, {1, 0}, {0, 0}, {0, 1}, {-1, 1}}, {{0, 1, 2, 3}, {0, 3, 4, 5}}, 0.6f);
}
// Flat normals, or round ones on its side.
inline Mesh makeCylinder(std::size_t sides = 32, bool round = true) {
  std::vector<Vec2> outline;
  std::vector<std::size_t> all;
  for (std::size_t i = 0; i < sides; ++i) {
    const float angle = 2.0f * kPi * static_cast<float>(i) / static_cast<float>(sides);
    outline.push_back(Vec2(std::cos(angle), std::sin(angle)) * 0.7f);
    all.push_back(i);
  }
  Mesh mesh = makePrism(outline, {all}, 1);
  for (std::size_t v = 0; round && v < 4 * sides; ++v) mesh.normals[v] = glm::normalize(Vec3(Vec2(mesh.positions[v]), 0));
  return mesh;
}
// One side of a rectangle.
inline Mesh makeSheet() {
  Mesh mesh;
  addFace(mesh, {{-1, -0.7f, 0}, {1, -0.7f, 0}, {1, 0.7f, 0}, {-1, 0.7f, 0}});
  fitToUnitSphere(mesh);
  return mesh;
}

}  // namespace fur::geometry::test
