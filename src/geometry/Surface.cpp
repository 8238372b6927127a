#include "geometry/Surface.h"

#include <cmath>

#include "core/Numbering.h"
#include "geometry/Adjacency.h"
#include "geometry/AtlasUv.h"
#include "geometry/ChartPacking.h"
#include "geometry/Curvature.h"
#include "geometry/FurCharts.h"
#include "geometry/FurOverlap.h"
#include "geometry/SurfaceEdges.h"
#include "geometry/SurfaceSteps.h"
#include "geometry/Weld.h"

namespace fur::geometry {

namespace {

// Leaves out triangles without an area, and what the layout says of them.
void keepTrianglesWithArea(Mesh& mesh) {
  AtlasLayout& layout = mesh.layout;
  const bool laidOut = layout.corners.size() == mesh.indices.size() && layout.chartOf.size() == mesh.triangleCount();
  if (!laidOut) layout = {};
  std::size_t kept = 0;
  for (std::size_t t = 0; t < mesh.triangleCount(); ++t) {
    if (!hasArea(mesh, t)) continue;
    for (std::size_t k = 0; k < 3; ++k) {
      mesh.indices[3 * kept + k] = mesh.indices[3 * t + k];
      if (laidOut) layout.corners[3 * kept + k] = layout.corners[3 * t + k];
    }
    if (laidOut) layout.chartOf[kept] = layout.chartOf[t];
    ++kept;
  }
  mesh.indices.resize(3 * kept);
  if (laidOut) layout.corners.resize(3 * kept), layout.chartOf.resize(kept);
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

AtlasLayout ownLayout(const Mesh& mesh, const std::vector<Vec2>& uv, const Weld& weld) {
  AtlasLayout layout;
  const auto across = neighboursAcrossSides(sortedSides(mesh.indices, weld), mesh.triangleCount());
  layout.chartOf = uvIslands(mesh.positions, uv, mesh.indices, across, layout.chartCount);
  layout.corners.reserve(mesh.indices.size());
  for (const std::uint32_t vertex : mesh.indices) layout.corners.push_back(uv[vertex]);
  return layout;
}

AtlasLayout packedLayout(const Charts& charts) {
  const std::vector<Placement> placements = packCharts(charts);
  AtlasLayout layout{charts.count, charts.chartOf, {}};
  layout.corners.reserve(charts.corners.size());
  for (std::size_t i = 0; i < charts.corners.size(); ++i)
    layout.corners.push_back(placements[charts.chartOf[i / 3]].apply(charts.corners[i]));
  return layout;
}

// Copies every vertex once for each pair of fur chart and atlas chart that uses it.
void splitVertices(Surface& surface, const Mesh& mesh, const Charts& fur, const AtlasLayout& atlas) {
  Numbering pairs, copies;
  surface.indices.reserve(mesh.indices.size());
  for (std::size_t i = 0; i < mesh.indices.size(); ++i) {
    const std::uint64_t charts = std::uint64_t{fur.chartOf[i / 3]} << 32 | atlas.chartOf[i / 3];
    const std::uint64_t pair = pairs.of(charts);
    const std::uint32_t source = mesh.indices[i];
    surface.indices.push_back(copies.of(pair << 32 | source));
    if (surface.indices.back() < surface.vertices.size()) continue;
    SurfaceVertex vertex{};
    vertex.position = mesh.positions[source];
    vertex.normal = mesh.normals[source];
    vertex.uv = mesh.uv.size() == mesh.positions.size() ? mesh.uv[source] : Vec2(0.0f);
    if (mesh.otherUv.size() == mesh.positions.size()) vertex.otherUv = mesh.otherUv[source];
    vertex.atlas = atlas.corners[i];
    vertex.fur = fur.corners[i];
    vertex.chart = atlas.chartOf[i / 3];
    vertex.source = source;
    surface.vertices.push_back(vertex);
  }
  surface.chartCount = atlas.chartCount;
  surface.trueVertexCount = surface.vertices.size();
}

// The layouts as those of the rounded mesh's triangles.
void follow(const RoundedMesh& rounded, std::vector<std::uint32_t>& chartOf, std::vector<Vec2>& corners) {
  corners = ofRoundedCorners(rounded, corners);
  std::vector<std::uint32_t> charts;
  charts.reserve(rounded.triangleOf.size());
  for (const std::uint32_t t : rounded.triangleOf) charts.push_back(chartOf[t]);
  chartOf = std::move(charts);
}

// The corners of the mesh's own triangles among those of the rounded one.
std::vector<std::uint32_t> ownCorners(const RoundedMesh& rounded, const std::vector<std::uint32_t>& indices, std::size_t count) {
  std::vector<std::uint32_t> own(count);
  for (std::size_t i = 0; i < indices.size(); ++i)
    for (int k = 0; k < 3; ++k)
      if (rounded.weights[i][k] == 1.0f) own[3 * std::size_t{rounded.triangleOf[i / 3]} + static_cast<std::size_t>(k)] = indices[i];
  return own;
}

void findFacets(Surface& surface, const std::vector<Vec3>& given) {
  constexpr float kFlat = 0.999f, kTurned = 0.978f;
  for (SurfaceEdge& edge : surface.edges)
    edge.betweenFacets = glm::dot(edge.faceNormal0, edge.faceNormal1) < kTurned &&
                         glm::dot(given[surface.vertices[edge.a].source], edge.faceNormal0) > kFlat &&
                         glm::dot(given[surface.vertices[edge.b].source], edge.faceNormal0) > kFlat;
}

void measureLean(Surface& surface, const std::vector<Vec3>& given) {
  for (SurfaceVertex& v : surface.vertices) {
    Vec3 s, t;
    tangentAxes(v, s, t);
    const Vec3& face = given[v.source];
    if (face != v.normal) v.lean = Vec2(glm::dot(face, s), glm::dot(face, t));
  }
}

Weld weldVertices(const Surface& surface) {
  std::vector<Vec3> positions(surface.vertices.size());
  for (std::size_t i = 0; i < positions.size(); ++i) positions[i] = surface.vertices[i].position;
  return weldPositions(positions);
}

}  // namespace

Result<Surface> buildSurface(const Mesh& mesh, FurMapping mapping) {
  Mesh whole = mesh;
  keepTrianglesWithArea(whole);
  if (whole.indices.empty()) return Error{ErrorId::BadFile, "the model has no triangle with an area"};
  whole.normals = unitNormals(whole);

  const Weld weld = weldPositions(whole.positions);
  Charts fur = furCharts(whole, weld, mapping);
  AtlasLayout atlas;
  if (!whole.layout.empty()) atlas = whole.layout;
  else if (whole.atlas.size() == whole.positions.size()) atlas = ownLayout(whole, whole.atlas, weld);
  else if (isUniqueAtlas(whole, whole.indices)) atlas = ownLayout(whole, whole.uv, weld);
  else if (mapping == FurMapping::Charts && whole.furUv.empty()) atlas = packedLayout(fur);
  else atlas = packedLayout(makeCharts(whole.positions, whole.indices, weld));

  Surface surface;
  RoundedMesh rounded = roundHardEdges(whole);
  surface.turned = rounded.changed;
  surface.sheets = rounded.sheets;
  if (surface.turned) {
    follow(rounded, fur.chartOf, fur.corners);
    follow(rounded, atlas.chartOf, atlas.corners);
    splitVertices(surface, rounded.mesh, fur, atlas);
    if (!rounded.inserted.empty()) surface.meshIndices = ownCorners(rounded, surface.indices, whole.indices.size());
    surface.inserted = std::move(rounded.inserted);
  } else {
    splitVertices(surface, whole, fur, atlas);
  }
  const Weld trueWeld = weldVertices(surface);
  surface.edges = findEdges(surface.vertices, surface.indices, trueWeld);
  if (surface.turned) findFacets(surface, rounded.given);
  const FurOverlap overlap = overlapFurCharts(surface, fur.chartOf, fur.count, trueWeld);
  std::vector<std::uint32_t> triangles = surface.indices;
  triangles.insert(triangles.end(), surface.furIndices.begin() + static_cast<std::ptrdiff_t>(overlap.firstCopy),
                   surface.furIndices.end());
  const Weld weldAll = weldVertices(surface);
  const std::vector<std::uint32_t> points = furPoints(surface.vertices, overlap.chartOfVertex, weldAll);
  computeSteps(surface, triangles, points, surface.turned);
  computeHessians(surface, triangles, points);
  computeCurvature(surface, surface.indices, weldAll, surface.turned);
  if (surface.turned) measureLean(surface, rounded.given);
  std::vector<std::uint32_t> furChartOf(overlap.triangleOf.size());
  for (std::size_t t = 0; t < furChartOf.size(); ++t) furChartOf[t] = overlap.chartOfVertex[surface.furIndices[3 * t]];
  surface.furClusters = makeFurClusters(surface, overlap.triangleOf, furChartOf);
  return surface;
}

OwnSurface ownSurface(const Surface& surface, const Mesh& mesh) {
  OwnSurface own;
  const std::vector<std::uint32_t>& indices = surface.inserted.empty() ? surface.indices : surface.meshIndices;
  Numbering kept;
  for (const std::uint32_t vertex : indices) {
    own.surface.indices.push_back(kept.of(vertex));
    if (own.surface.indices.back() < own.vertexOf.size()) continue;
    own.vertexOf.push_back(vertex);
    SurfaceVertex& v = own.surface.vertices.emplace_back(surface.vertices[vertex]);
    if (surface.turned && mesh.normals.size() == mesh.positions.size()) v.normal = normalizeOr(mesh.normals[v.source], v.normal);
  }
  own.surface.trueVertexCount = own.vertexOf.size();
  own.surface.chartCount = surface.chartCount;
  return own;
}

}  // namespace fur::geometry
