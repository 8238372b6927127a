#include "scene/import/CornerMesh.h"

#include <numeric>

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

CornerWeld buildMesh(const CornerLists& lists, Model& model) {
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
  geometry::fitToUnitSphere(mesh);
  return weld;
}

}  // namespace fur::scene
