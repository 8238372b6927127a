#include "geometry/Surface.h"

#include <cmath>
#include <unordered_map>

#include "geometry/Adjacency.h"
#include "geometry/AtlasUv.h"
#include "geometry/ChartPacking.h"
#include "geometry/Charts.h"
#include "geometry/SurfaceEdges.h"
#include "geometry/Weld.h"

namespace fur::geometry {

namespace {

// Below this a triangle's normal is rounding noise (positions are of size 1).
constexpr double kLeastDoubleArea = 1e-12;

std::vector<std::uint32_t> trianglesWithArea(const Mesh& mesh) {
  std::vector<std::uint32_t> kept;
  kept.reserve(mesh.indices.size());
  for (std::size_t i = 0; i + 2 < mesh.indices.size(); i += 3) {
    const glm::dvec3 a = mesh.positions[mesh.indices[i]];
    const glm::dvec3 cross = glm::cross(glm::dvec3(mesh.positions[mesh.indices[i + 1]]) - a,
                                        glm::dvec3(mesh.positions[mesh.indices[i + 2]]) - a);
    if (!(glm::dot(cross, cross) > kLeastDoubleArea * kLeastDoubleArea)) continue;
    kept.insert(kept.end(), mesh.indices.begin() + static_cast<std::ptrdiff_t>(i),
                mesh.indices.begin() + static_cast<std::ptrdiff_t>(i + 3));
  }
  return kept;
}

std::vector<Vec3> unitNormals(const Mesh& mesh) {
  Mesh computed;
  computed.positions = mesh.positions;
  computed.indices = mesh.indices;
  const bool given = mesh.normals.size() == mesh.positions.size();
  bool whole = given;
  for (std::size_t i = 0; whole && i < mesh.normals.size(); ++i) {
    const float squared = glm::dot(mesh.normals[i], mesh.normals[i]);
    whole = squared > 1e-12f && squared < 1e12f;
  }
  if (!whole) computeNormals(computed);
  std::vector<Vec3> normals(mesh.positions.size());
  for (std::size_t i = 0; i < normals.size(); ++i) {
    const Vec3 fallback = whole ? Vec3(0, 1, 0) : computed.normals[i];
    normals[i] = given ? normalizeOr(mesh.normals[i], fallback) : fallback;
  }
  return normals;
}

// Copies every vertex once for each fur chart that uses it.
class Splitter {
 public:
  Splitter(const Mesh& mesh, std::vector<Vec3> normals) : mesh_(mesh), normals_(std::move(normals)) {
    copies_.reserve(mesh.positions.size() * 2);
  }

  std::uint32_t vertexFor(Surface& surface, std::uint32_t source, std::uint32_t furChart, const Vec2& fur) {
    const std::uint64_t key = std::uint64_t{furChart} << 32 | source;
    const auto [slot, isNew] = copies_.try_emplace(key, static_cast<std::uint32_t>(surface.vertices.size()));
    if (!isNew) return slot->second;
    SurfaceVertex vertex{};
    vertex.position = mesh_.positions[source];
    vertex.normal = normals_[source];
    vertex.uv = mesh_.uv.size() == mesh_.positions.size() ? mesh_.uv[source] : Vec2(0.0f);
    vertex.fur = fur;
    surface.vertices.push_back(vertex);
    return slot->second;
  }

 private:
  const Mesh& mesh_;
  std::vector<Vec3> normals_;
  std::unordered_map<std::uint64_t, std::uint32_t> copies_;  // looked up only: its order never shows
};

void placeInAtlas(Surface& surface, const Charts& charts) {
  const std::vector<Placement> placements = packCharts(charts);
  for (std::size_t i = 0; i < surface.indices.size(); ++i) {
    SurfaceVertex& vertex = surface.vertices[surface.indices[i]];
    const Placement& place = placements[charts.chartOf[i / 3]];
    vertex.atlas = place.apply(vertex.fur);
    vertex.atlasFromFur = Vec4(place.c, -place.s, place.s, place.c) * place.scale;
    vertex.chart = charts.chartOf[i / 3];
  }
  surface.chartCount = charts.count;
}

// The matrix that takes the triangle's fur steps to its atlas steps, times the surface's area.
void sumAtlasFromFur(Surface& surface, std::size_t first, float area) {
  SurfaceVertex* v[3];
  for (std::size_t k = 0; k < 3; ++k) v[k] = &surface.vertices[surface.indices[first + k]];
  const Vec2 f1 = v[1]->fur - v[0]->fur, f2 = v[2]->fur - v[0]->fur;
  const Vec2 a1 = v[1]->atlas - v[0]->atlas, a2 = v[2]->atlas - v[0]->atlas;
  const float det = f1.x * f2.y - f1.y * f2.x;
  if (!(std::abs(det) > 1e-14f)) return;
  const Vec2 perS = (a1 * f2.y - a2 * f1.y) / det, perT = (a2 * f1.x - a1 * f2.x) / det;
  for (SurfaceVertex* vertex : v) vertex->atlasFromFur += Vec4(perS, perT) * area;
}

float areaOf(const Surface& surface, std::size_t first) {
  const Vec3& p = surface.vertices[surface.indices[first]].position;
  const Vec3 cross = glm::cross(surface.vertices[surface.indices[first + 1]].position - p,
                                surface.vertices[surface.indices[first + 2]].position - p);
  return 0.5f * std::sqrt(glm::dot(cross, cross));
}

void keepOwnAtlas(Surface& surface, const std::vector<std::uint32_t>& islands, std::uint32_t count) {
  std::vector<float> areas(surface.vertices.size(), 0.0f);
  double surfaceArea = 0.0, atlasArea = 0.0;
  for (SurfaceVertex& vertex : surface.vertices) vertex.atlas = vertex.uv;
  for (std::size_t i = 0; i < surface.indices.size(); i += 3) {
    const float area = areaOf(surface, i);
    const Vec2& uv = surface.vertices[surface.indices[i]].uv;
    const Vec2 a = surface.vertices[surface.indices[i + 1]].uv - uv, b = surface.vertices[surface.indices[i + 2]].uv - uv;
    surfaceArea += area;
    atlasArea += 0.5 * std::abs(a.x * b.y - a.y * b.x);
    sumAtlasFromFur(surface, i, area);
    for (std::size_t k = 0; k < 3; ++k) {
      areas[surface.indices[i + k]] += area;
      surface.vertices[surface.indices[i + k]].chart = islands[i / 3];
    }
  }
  const float even = static_cast<float>(std::sqrt(atlasArea / surfaceArea));
  for (std::size_t i = 0; i < surface.vertices.size(); ++i) {
    Vec4& m = surface.vertices[i].atlasFromFur;
    if (areas[i] > 0.0f) m /= areas[i];
    const float det = m.x * m.w - m.y * m.z;
    // Where the uv fold or shrink to nothing, a plain step of the mean size stands in.
    if (!(std::abs(det) > 1e-4f * even * even)) m = Vec4(even, 0.0f, 0.0f, even);
  }
  surface.chartCount = count;
}

void computeGradients(Surface& surface) {
  std::vector<float> areas(surface.vertices.size(), 0.0f);
  for (std::size_t i = 0; i < surface.indices.size(); i += 3) {
    SurfaceVertex* v[3];
    for (std::size_t k = 0; k < 3; ++k) v[k] = &surface.vertices[surface.indices[i + k]];
    const glm::dvec3 e1 = glm::dvec3(v[1]->position) - glm::dvec3(v[0]->position);
    const glm::dvec3 e2 = glm::dvec3(v[2]->position) - glm::dvec3(v[0]->position);
    const glm::dvec3 normal = glm::cross(e1, e2);
    const double squared = glm::dot(normal, normal);
    // The vectors dual to e1 and e2 in the triangle's plane.
    const glm::dvec3 d1 = glm::cross(e2, normal) / squared, d2 = glm::cross(normal, e1) / squared;
    const Vec2 f1 = v[1]->fur - v[0]->fur, f2 = v[2]->fur - v[0]->fur;
    const float area = static_cast<float>(0.5 * std::sqrt(squared));
    const Vec3 gradS = Vec3(d1 * static_cast<double>(f1.x) + d2 * static_cast<double>(f2.x));
    const Vec3 gradT = Vec3(d1 * static_cast<double>(f1.y) + d2 * static_cast<double>(f2.y));
    for (std::size_t k = 0; k < 3; ++k) {
      v[k]->gradS += gradS * area;
      v[k]->gradT += gradT * area;
      areas[surface.indices[i + k]] += area;
    }
  }
  for (std::size_t i = 0; i < surface.vertices.size(); ++i) {
    SurfaceVertex& v = surface.vertices[i];
    for (Vec3* gradient : {&v.gradS, &v.gradT}) {
      if (areas[i] > 0.0f) *gradient /= areas[i];
      *gradient -= v.normal * glm::dot(*gradient, v.normal);
    }
  }
}

}  // namespace

Result<Surface> buildSurface(const Mesh& mesh) {
  Mesh whole;
  whole.positions = mesh.positions;
  whole.uv = mesh.uv;
  whole.indices = trianglesWithArea(mesh);
  if (whole.indices.empty()) return Error{ErrorId::BadFile, "the model has no triangle with an area"};
  whole.normals = mesh.normals;
  std::vector<Vec3> normals = unitNormals(whole);

  const Weld weld = weldPositions(whole.positions);
  const Charts charts = makeCharts(whole.positions, whole.indices, weld);
  Surface surface;
  Splitter splitter(whole, std::move(normals));
  surface.indices.reserve(whole.indices.size());
  for (std::size_t i = 0; i < whole.indices.size(); ++i) {
    surface.indices.push_back(splitter.vertexFor(surface, whole.indices[i], charts.chartOf[i / 3], charts.corners[i]));
  }
  if (isUniqueAtlas(whole, whole.indices)) {
    std::uint32_t count = 0;
    const auto across = neighboursAcrossSides(sortedSides(whole.indices, weld), whole.triangleCount());
    const auto islands = uvIslands(whole, whole.indices, across, count);
    keepOwnAtlas(surface, islands, count);
  } else {
    placeInAtlas(surface, charts);
  }
  computeGradients(surface);
  std::vector<Vec3> positions(surface.vertices.size());
  for (std::size_t i = 0; i < positions.size(); ++i) positions[i] = surface.vertices[i].position;
  surface.edges = findEdges(surface.vertices, surface.indices, weldPositions(positions));
  return surface;
}

}  // namespace fur::geometry
