#include "wet/SurfaceWetting.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/Assert.h"
#include "core/Sort.h"
#include "geometry/Adjacency.h"
#include "geometry/AtlasTexels.h"

namespace fur::wet {

namespace {

// Where the atlas is badly stretched (the poles of a globe) triangles hardly agree where the centre
// is; so many answers are enough.
constexpr std::size_t kMaxSheets = 8;

const geometry::SurfaceVertex& cornerOf(const geometry::Surface& surface, std::size_t triangle, int k) {
  return surface.vertices[surface.indices[triangle * 3 + static_cast<std::size_t>(k)]];
}

std::uint16_t chartOf(const geometry::Surface& surface, std::size_t triangle) {
  const std::uint32_t chart = cornerOf(surface, triangle, 0).chart;
  return chart < SurfaceWetting::kNoChart ? static_cast<std::uint16_t>(chart) : SurfaceWetting::kNoChart;
}

float cross2(const Vec2& a, const Vec2& b) { return a.x * b.y - a.y * b.x; }

}  // namespace

SurfaceWetting::SurfaceWetting(const geometry::Surface& surface, int maskSize, std::span<const std::uint8_t> bare)
    : atlas_(surface, maskSize, bare), chartOfTexel_(static_cast<std::size_t>(maskSize) * maskSize, kNoChart) {
  faces_.reserve(surface.triangleCount());
  for (std::size_t t = 0; t < surface.triangleCount(); ++t) faces_.push_back(!bare.empty() && bare[t] ? Face{} : mapFace(surface, t));
  for (std::size_t i = 0; i < chartOfTexel_.size(); ++i)
    if (atlas_.triangleOf()[i] != geometry::kNoTriangle) chartOfTexel_[i] = chartOf(surface, atlas_.triangleOf()[i]);
  for (const auto& [texel, source] : atlas_.gutter()) chartOfTexel_[texel] = chartOfTexel_[source];
}

SurfaceWetting::Face SurfaceWetting::mapFace(const geometry::Surface& surface, std::size_t triangle) {
  const auto& a = cornerOf(surface, triangle, 0);
  const auto& b = cornerOf(surface, triangle, 1);
  const auto& c = cornerOf(surface, triangle, 2);
  const Vec3 ab = b.position - a.position, ac = c.position - a.position, up = glm::cross(ab, ac);
  const Vec2 uvAb = b.atlas - a.atlas, uvAc = c.atlas - a.atlas;
  const float squared = glm::dot(up, up), atlasArea = std::abs(cross2(uvAb, uvAc));
  Face face{};
  if (!(squared > 1e-24f) || !(atlasArea > 1e-14f)) return face;
  // The reciprocal basis of (ab, ac) within their plane.
  const Vec3 alongAb = glm::cross(ac, up) / squared, alongAc = glm::cross(up, ab) / squared;
  face.gradU = alongAb * uvAb.x + alongAc * uvAc.x;
  face.gradV = alongAb * uvAb.y + alongAc * uvAc.y;
  face.origin = a.atlas - Vec2(glm::dot(face.gradU, a.position), glm::dot(face.gradV, a.position));
  const float length = std::sqrt(squared);
  face.normal = up / length;
  face.area = 0.5f * length;
  face.scale = std::sqrt(atlasArea / length);
  const float uu = glm::dot(face.gradU, face.gradU), uv = glm::dot(face.gradU, face.gradV), vv = glm::dot(face.gradV, face.gradV);
  face.stretch = Vec3(vv, -uv, uu) / (uu * vv - uv * uv);
  return face;
}

// What is stretched less is taken for even, so that a flat chart gives the circles of the paper to the bit; what is
// stretched more (a fold of a bad atlas) is no ellipse that a texel could hold.
Vec3 SurfaceWetting::Sheet::shape() const {
  constexpr float kEven = 0.03f, kMost = 10.0f;
  const float squared = stretch.x * stretch.z - stretch.y * stretch.y;
  if (!(squared > 0.0f)) return {1, 0, 1};
  const Vec3 shape = stretch / std::sqrt(squared);
  const bool even = std::abs(shape.x - 1) < kEven && std::abs(shape.y) < kEven && std::abs(shape.z - 1) < kEven;
  return even || !(shape.x + shape.z < kMost) ? Vec3(1, 0, 1) : shape;
}

SurfaceWetting::Sheet SurfaceWetting::sheetOf(const geometry::Surface& surface, std::uint32_t triangle, const Vec3& centre) const {
  const Face& face = faces_[triangle];
  return {chartOf(surface, triangle), face.origin + Vec2(glm::dot(face.gradU, centre), glm::dot(face.gradV, centre)), face.area,
          face.area * face.scale, face.area * face.stretch};
}

std::vector<SurfaceWetting::Sheet> SurfaceWetting::sheetsAt(const geometry::Surface& surface,
                                                            const geometry::SurfaceQuery& query, const Vec3& centre,
                                                            const Vec3& normal, float radius) const {
  FUR_ASSERT(surface.triangleCount() == faces_.size(), "SurfaceWetting::sheetsAt()", "the surface it was built from",
             surface.triangleCount());
  std::vector<std::pair<float, std::uint32_t>> near;
  for (const std::uint32_t t : query.trianglesWithin(centre, radius)) {
    if (faces_[t].area <= 0.0f || glm::dot(faces_[t].normal, normal) <= 0.0f) continue;
    const Vec3 a = cornerOf(surface, t, 0).position, b = cornerOf(surface, t, 1).position, c = cornerOf(surface, t, 2).position;
    const Vec3 weights = geometry::nearestWeights(centre, a, b, c);
    const Vec3 way = centre - (a * weights.x + b * weights.y + c * weights.z);
    near.emplace_back(glm::dot(way, way), t);
  }
  // The nearest triangle of a sheet says where its centre is, the others only agree.
  sortStably(near.begin(), near.end());
  std::vector<Sheet> sheets;
  for (const auto& [distance, t] : near) {
    const Sheet alone = sheetOf(surface, t, centre);
    const auto same = std::find_if(sheets.begin(), sheets.end(), [&](const Sheet& sheet) {
      const Vec2 apart = alone.centre - sheet.centre;
      const float reach = radius * sheet.scale();
      return sheet.chart == alone.chart && glm::dot(apart, apart) <= reach * reach;
    });
    if (same != sheets.end()) {
      same->area += alone.area;
      same->scaledArea += alone.scaledArea;
      same->stretch += alone.stretch;
    } else if (sheets.size() < kMaxSheets) {
      sheets.push_back(alone);
    }
  }
  return sheets;
}

void SurfaceWetting::addDroplet(WetnessMask& mask, const geometry::Surface& surface,
                                const geometry::SurfaceQuery& query, const Vec3& centre, const Vec3& normal,
                                float radius, float wetness) const {
  FUR_ASSERT(mask.size() == atlas_.size(), "SurfaceWetting::addDroplet()", "a mask of the size it was built for", mask.size());
  for (const Sheet& sheet : sheetsAt(surface, query, centre, normal, radius))
    mask.addDroplet({sheet.centre, radius * sheet.scale(), wetness, sheet.shape()}, chartOfTexel_.data(), sheet.chart);
}

void SurfaceWetting::dryAt(WetnessMask& mask, const geometry::Surface& surface, const geometry::SurfaceQuery& query,
                           const Vec3& centre, const Vec3& normal, float radius, float amount) const {
  FUR_ASSERT(mask.size() == atlas_.size(), "SurfaceWetting::dryAt()", "a mask of the size it was built for", mask.size());
  for (const Sheet& sheet : sheetsAt(surface, query, centre, normal, radius))
    mask.dryAt({sheet.centre, radius * sheet.scale(), amount, sheet.shape()}, chartOfTexel_.data(), sheet.chart);
}

}  // namespace fur::wet
