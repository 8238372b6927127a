#include "geometry/Surface.h"

#include <cmath>
#include <iterator>
#include <optional>
#include <utility>

#include "core/Numbering.h"
#include "geometry/Adjacency.h"
#include "geometry/AtlasUv.h"
#include "geometry/ChartPacking.h"
#include "geometry/CoatThickness.h"
#include "geometry/Curvature.h"
#include "geometry/FurCharts.h"
#include "geometry/FurDirections.h"
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
    // A unit stays as it is: what is saved comes back the same to the bit.
    const bool isUnit = given && std::abs(glm::dot(mesh.normals[i], mesh.normals[i]) - 1) < 1e-6f;
    normals[i] = isUnit ? mesh.normals[i] : given ? normalizeOr(mesh.normals[i], fallback) : fallback;
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

}  // namespace

Weld weldVertices(std::span<const SurfaceVertex> vertices) {
  std::vector<Vec3> positions;
  positions.reserve(vertices.size());
  for (const SurfaceVertex& vertex : vertices) positions.push_back(vertex.position);
  return weldPositions(positions);
}

class SurfaceBuilding::Work {
 public:
  Work(Mesh mesh, FurMapping mapping) : whole_(std::move(mesh)), mapping_(mapping) {}

  bool step() {
    static constexpr bool (Work::*kSteps[])() = {&Work::begin, &Work::cutFurCharts, &Work::layAtlas,     &Work::cutAtlas,
                                                 &Work::round, &Work::findDirections, &Work::split,         &Work::overlapCharts,
                                                 &Work::measureSteps, &Work::measureCurvature};
    if ((this->*kSteps[next_])()) ++next_;
    return whole_.indices.empty() || next_ == std::size(kSteps);
  }

  Result<Surface> take() {
    if (whole_.indices.empty()) return Error{ErrorId::BadFile, "the model has no triangle with an area"};
    return std::move(surface_);
  }

 private:
  // Each: whether it is done.
  bool begin() {
    keepTrianglesWithArea(whole_);
    if (whole_.indices.empty()) return true;
    whole_.normals = unitNormals(whole_);
    weld_ = weldPositions(whole_.positions);
    if (auto given = givenFurCharts(whole_, weld_, mapping_)) fur_ = std::move(*given);
    else cut();
    return true;
  }

  void cut() { making_.emplace(whole_.positions, whole_.indices, weld_); }

  bool cutFurCharts() {
    if (!making_) return true;
    if (!making_->step()) return false;
    fur_ = making_->take();
    making_.reset();
    return true;
  }

  bool layAtlas() {
    if (!whole_.layout.empty()) atlas_ = whole_.layout;
    else if (whole_.atlas.size() == whole_.positions.size()) atlas_ = ownLayout(whole_, whole_.atlas, weld_);
    else if (isUniqueAtlas(whole_, whole_.indices)) atlas_ = ownLayout(whole_, whole_.uv, weld_);
    else if (mapping_ == FurMapping::Charts && whole_.furUv.empty()) atlas_ = packedLayout(fur_);
    else cut();
    return true;
  }

  bool cutAtlas() {
    if (!making_) return true;
    if (!making_->step()) return false;
    atlas_ = packedLayout(making_->take());
    making_.reset();
    return true;
  }

  bool round() {
    rounded_ = roundHardEdges(whole_);
    surface_.turned = rounded_.changed;
    surface_.sheets = rounded_.sheets;
    directions_.emplace(shape(), rounded_.given);
    return true;
  }

  // Of which the surface is made.
  Mesh& shape() { return surface_.turned ? rounded_.mesh : whole_; }

  bool findDirections() {
    if (!directions_->step()) return false;
    std::vector<Vec3> directions = directions_->directions();
    directions_.reset();
    // Fur leans over hard edges from where it would grow without them.
    for (std::size_t i = 0; i < rounded_.given.size(); ++i)
      if (rounded_.given[i] == rounded_.mesh.normals[i]) rounded_.given[i] = directions[i];
    shape().normals = std::move(directions);
    return true;
  }

  bool split() {
    if (surface_.turned) {
      follow(rounded_, fur_.chartOf, fur_.corners);
      follow(rounded_, atlas_.chartOf, atlas_.corners);
    }
    splitVertices(surface_, shape(), fur_, atlas_);
    if (!rounded_.inserted.empty()) surface_.meshIndices = ownCorners(rounded_, surface_.indices, whole_.indices.size());
    surface_.inserted = std::move(rounded_.inserted);
    trueWeld_ = weldVertices(surface_.vertices);
    surface_.edges = findEdges(surface_.vertices, surface_.indices, trueWeld_);
    if (surface_.turned) findFacets(surface_, rounded_.given);
    return true;
  }

  bool overlapCharts() {
    overlap_ = overlapFurCharts(surface_, fur_.chartOf, fur_.count, trueWeld_);
    return true;
  }

  bool measureSteps() {
    std::vector<std::uint32_t> triangles = surface_.indices;
    triangles.insert(triangles.end(), surface_.furIndices.begin() + static_cast<std::ptrdiff_t>(overlap_.firstCopy),
                     surface_.furIndices.end());
    weldAll_ = weldVertices(surface_.vertices);
    const std::vector<std::uint32_t> points = furPoints(surface_.vertices, overlap_.chartOfVertex, weldAll_);
    computeSteps(surface_, triangles, points, surface_.turned);
    computeHessians(surface_, triangles, points);
    return true;
  }

  bool measureCurvature() {
    computeCurvature(surface_, surface_.indices, weldAll_, surface_.turned);
    measureRoom(surface_, surface_.indices, weldAll_);
    if (surface_.turned) measureLean(surface_, rounded_.given);
    std::vector<std::uint32_t> furChartOf(overlap_.triangleOf.size());
    for (std::size_t t = 0; t < furChartOf.size(); ++t) furChartOf[t] = overlap_.chartOfVertex[surface_.furIndices[3 * t]];
    surface_.furClusters = makeFurClusters(surface_, overlap_.triangleOf, furChartOf);
    return true;
  }

  Mesh whole_;
  FurMapping mapping_;
  std::size_t next_ = 0;
  Weld weld_, trueWeld_, weldAll_;
  std::optional<ChartMaking> making_;
  Charts fur_;
  AtlasLayout atlas_;
  RoundedMesh rounded_;
  std::optional<FurDirections> directions_;
  FurOverlap overlap_;
  Surface surface_;
};

SurfaceBuilding::SurfaceBuilding(Mesh mesh, FurMapping mapping) : work_(std::make_unique<Work>(std::move(mesh), mapping)) {}
SurfaceBuilding::SurfaceBuilding(SurfaceBuilding&&) noexcept = default;
SurfaceBuilding& SurfaceBuilding::operator=(SurfaceBuilding&&) noexcept = default;
SurfaceBuilding::~SurfaceBuilding() = default;
bool SurfaceBuilding::step() { return work_->step(); }
Result<Surface> SurfaceBuilding::take() { return work_->take(); }

Result<Surface> buildSurface(const Mesh& mesh, FurMapping mapping) {
  SurfaceBuilding building(mesh, mapping);
  while (!building.step()) {}
  return building.take();
}

OwnSurface ownSurface(const Surface& surface, const Mesh& mesh) {
  OwnSurface own;
  const std::vector<std::uint32_t>& indices = surface.inserted.empty() ? surface.indices : surface.meshIndices;
  const std::vector<Vec3> normals = unitNormals(mesh);
  Numbering kept;
  for (const std::uint32_t vertex : indices) {
    own.surface.indices.push_back(kept.of(vertex));
    if (own.surface.indices.back() < own.vertexOf.size()) continue;
    own.vertexOf.push_back(vertex);
    SurfaceVertex& v = own.surface.vertices.emplace_back(surface.vertices[vertex]);
    if (v.source < normals.size()) v.normal = normals[v.source];
  }
  own.surface.trueVertexCount = own.vertexOf.size();
  own.surface.chartCount = surface.chartCount;
  return own;
}

}  // namespace fur::geometry
