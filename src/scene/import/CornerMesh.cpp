#include "scene/import/CornerMesh.h"

#include <cmath>
#include <numeric>
#include <utility>

#include "geometry/Adjacency.h"
#include "scene/import/ImportError.h"

namespace fur::scene {

namespace {

// Sorts `order` by one of the three numbers and keeps the order of equals.
void sortBy(std::size_t list, std::uint32_t limit, const std::vector<Corner>& corners, std::vector<std::uint32_t>& order) {
  std::vector<std::uint32_t> start(std::size_t{limit} + 2, 0);
  for (const Corner& corner : corners) ++start[corner[list] + 1];
  std::partial_sum(start.begin(), start.end(), start.begin());
  std::vector<std::uint32_t> sorted(order.size());
  for (const std::uint32_t corner : order) sorted[start[corners[corner][list]]++] = corner;
  order = std::move(sorted);
}

// Faces that meet at more than 60 degrees are those of a box, not of a round body.
constexpr float kCreaseCosine = 0.5f;

// Of a file without normals that has creases: corners joined by faces that meet smoothly get one normal, by their angles
// and areas, each side of a crease its own.
void addCreasedNormals(CornerLists& lists) {
  std::vector<std::uint32_t> indices;
  for (const auto& [position, texcoord, normal] : lists.corners) {
    if (normal) return;
    indices.push_back(position - 1);
  }
  const auto at = [&](std::size_t corner) -> const Vec3& { return lists.positions[indices[corner]]; };
  std::vector<Vec3> faces;  // normals times twice the areas
  for (std::size_t i = 0; i < indices.size(); i += 3) faces.push_back(glm::cross(at(i + 1) - at(i), at(i + 2) - at(i)));
  const geometry::Weld weld = geometry::weldPositions(lists.positions);
  const std::vector<std::uint32_t> across = geometry::neighboursAcrossSides(geometry::sortedSides(indices, weld), faces.size());
  std::vector<std::uint32_t> joined(indices.size());
  std::iota(joined.begin(), joined.end(), 0u);
  const auto first = [&](std::uint32_t corner) {
    while (joined[corner] != corner) corner = joined[corner] = joined[joined[corner]];
    return corner;
  };
  bool creased = false;
  for (std::uint32_t i = 0; i < across.size(); ++i) {
    const std::uint32_t other = across[i], triangle = i / 3;
    if (other == geometry::kNoTriangle) continue;
    // What has no area has no side either.
    const float lengths = glm::length(faces[triangle]) * glm::length(faces[other]);
    if (lengths > 0.0f && glm::dot(faces[triangle], faces[other]) < kCreaseCosine * lengths) {
      creased = true;
      continue;
    }
    for (const std::uint32_t end : {i, 3 * triangle + (i + 1) % 3})
      for (std::uint32_t k = 3 * other; k < 3 * other + 3; ++k)
        if (weld.idOf[indices[k]] == weld.idOf[indices[end]]) joined[first(k)] = first(end);
  }
  if (!creased) return;
  lists.normals.assign(indices.size(), Vec3(0));
  for (std::uint32_t i = 0; i < indices.size(); ++i) {
    const std::uint32_t triangle = i / 3, next = 3 * triangle + (i + 1) % 3, last = 3 * triangle + (i + 2) % 3;
    const float cosine = glm::dot(normalizeOr(at(next) - at(i), Vec3(0)), normalizeOr(at(last) - at(i), Vec3(0)));
    lists.normals[first(i)] += faces[triangle] * std::acos(glm::clamp(cosine, -1.0f, 1.0f));
    lists.corners[i][2] = first(i) + 1;
  }
}

}  // namespace

std::vector<std::uint32_t> sortedCorners(const std::vector<Corner>& corners, const Corner& limits) {
  std::vector<std::uint32_t> order(corners.size());
  std::iota(order.begin(), order.end(), 0u);
  for (std::size_t list = 0; list < 3; ++list) sortBy(list, limits[list], corners, order);
  return order;
}

CornerWeld weldCorners(const std::vector<Corner>& corners, const Corner& limits) {
  const std::vector<std::uint32_t> order = sortedCorners(corners, limits);
  CornerWeld weld;
  weld.vertexOf.resize(corners.size());
  // Of equal corners the first in the file comes first, and stands for all.
  for (std::size_t i = 0, first = 0; i < order.size(); ++i) {
    if (corners[order[i]] != corners[order[first]]) first = i;
    weld.vertexOf[order[i]] = order[first];
  }
  for (std::uint32_t corner = 0; corner < corners.size(); ++corner) {
    const std::uint32_t first = weld.vertexOf[corner];
    if (first == corner) weld.cornerOf.push_back(corner);
    // A first corner comes before its equals, so it has its vertex by now.
    weld.vertexOf[corner] = first == corner ? static_cast<std::uint32_t>(weld.cornerOf.size() - 1) : weld.vertexOf[first];
  }
  return weld;
}

Vec2 usableTexcoord(const Vec2& uv) {
  return std::abs(uv.x) < 1e6f && std::abs(uv.y) < 1e6f ? uv : Vec2(0.0f);
}

CornerWeld buildMesh(CornerLists lists, Model& model) {
  addCreasedNormals(lists);
  const auto limit = [](std::size_t count) { return static_cast<std::uint32_t>(count); };
  CornerWeld weld = weldCorners(
      lists.corners, {limit(lists.positions.size()), limit(lists.texcoords.size()), limit(lists.normals.size())});
  if (weld.cornerOf.size() > kMaxVertices) {
    throw ImportError({ErrorId::TooLarge, formatted("%.200s: its faces have over %zu different corners, which is the limit",
                                                    model.name.c_str(), kMaxVertices)});
  }
  geometry::Mesh& mesh = model.mesh;
  mesh.indices = weld.vertexOf;
  std::size_t withTexcoords = 0;
  for (const std::uint32_t corner : weld.cornerOf) {
    const auto [position, texcoord, normal] = lists.corners[corner];
    mesh.positions.push_back(lists.positions[position - 1]);
    mesh.uv.push_back(texcoord ? usableTexcoord(lists.texcoords[texcoord - 1]) : Vec2(0.0f));
    if (texcoord) ++withTexcoords;
  }
  if (withTexcoords == 0) mesh.uv.clear();
  model.hasTexcoords = withTexcoords == mesh.positions.size();
  geometry::computeNormals(mesh);
  for (std::size_t vertex = 0; vertex < weld.cornerOf.size(); ++vertex) {
    const std::uint32_t normal = lists.corners[weld.cornerOf[vertex]][2];
    if (normal) mesh.normals[vertex] = normalizeOr(lists.normals[normal - 1], mesh.normals[vertex]);
  }
  model.bounds = geometry::bounds(mesh);
  weld.scale = geometry::fitToUnitSphere(mesh).scale;
  return weld;
}

}  // namespace fur::scene
