#include "wet/SurfaceWetting.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/Assert.h"

namespace fur::wet {

namespace {

constexpr int kGutter = 2;
// Where the atlas is badly stretched (the poles of a globe) triangles hardly agree where the centre
// is; so many answers are enough.
constexpr std::size_t kMaxSheets = 8;

// Ericson, Real-Time Collision Detection, 5.1.5.
Vec3 closestOnTriangle(const Vec3& p, const Vec3& a, const Vec3& b, const Vec3& c) {
  const Vec3 ab = b - a, ac = c - a, ap = p - a, bp = p - b, cp = p - c;
  const float d1 = glm::dot(ab, ap), d2 = glm::dot(ac, ap);
  if (d1 <= 0.0f && d2 <= 0.0f) return a;
  const float d3 = glm::dot(ab, bp), d4 = glm::dot(ac, bp);
  if (d3 >= 0.0f && d4 <= d3) return b;
  const float d5 = glm::dot(ab, cp), d6 = glm::dot(ac, cp);
  if (d6 >= 0.0f && d5 <= d6) return c;
  const float vc = d1 * d4 - d3 * d2;
  if (vc <= 0.0f && d1 >= 0.0f && d3 <= 0.0f) return a + ab * (d1 / (d1 - d3));
  const float vb = d5 * d2 - d1 * d6;
  if (vb <= 0.0f && d2 >= 0.0f && d6 <= 0.0f) return a + ac * (d2 / (d2 - d6));
  const float va = d3 * d6 - d5 * d4;
  if (va <= 0.0f && d4 >= d3 && d5 >= d6) return b + (c - b) * ((d4 - d3) / ((d4 - d3) + (d5 - d6)));
  const float sum = va + vb + vc;
  return sum > 0.0f ? a + ab * (vb / sum) + ac * (vc / sum) : a;
}

const geometry::SurfaceVertex& corner(const geometry::Surface& surface, std::size_t triangle, int k) {
  return surface.vertices[surface.indices[triangle * 3 + static_cast<std::size_t>(k)]];
}

std::uint16_t chartOf(const geometry::Surface& surface, std::size_t triangle) {
  const std::uint32_t chart = corner(surface, triangle, 0).chart;
  return chart < SurfaceWetting::kNoChart ? static_cast<std::uint16_t>(chart) : SurfaceWetting::kNoChart;
}

float cross2(const Vec2& a, const Vec2& b) { return a.x * b.y - a.y * b.x; }

int texelOf(float x, int size) { return static_cast<int>(glm::clamp(x, 0.0f, static_cast<float>(size - 1))); }

}  // namespace

SurfaceWetting::SurfaceWetting(const geometry::Surface& surface, int maskSize)
    : size_(maskSize), chartOfTexel_(static_cast<std::size_t>(maskSize) * maskSize, kNoChart) {
  faces_.reserve(surface.triangleCount());
  for (std::size_t t = 0; t < surface.triangleCount(); ++t) faces_.push_back(mapFace(surface, t));
  rasterise(surface);
  for (int step = 0; step < kGutter; ++step) dilate();
}

SurfaceWetting::Face SurfaceWetting::mapFace(const geometry::Surface& surface, std::size_t triangle) {
  const auto& a = corner(surface, triangle, 0);
  const auto& b = corner(surface, triangle, 1);
  const auto& c = corner(surface, triangle, 2);
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
  return face;
}

void SurfaceWetting::rasterise(const geometry::Surface& surface) {
  const float scale = static_cast<float>(size_);
  for (std::size_t t = 0; t < surface.triangleCount(); ++t) {
    const std::uint16_t chart = chartOf(surface, t);
    // In texels, whose centres are whole numbers here.
    Vec2 p[3];
    for (int k = 0; k < 3; ++k) p[k] = corner(surface, t, k).atlas * scale - 0.5f;
    float area = cross2(p[1] - p[0], p[2] - p[0]);
    if (area < 0.0f) std::swap(p[1], p[2]), area = -area;
    const Vec2 low = glm::min(p[0], glm::min(p[1], p[2])), high = glm::max(p[0], glm::max(p[1], p[2]));
    for (int y = texelOf(std::ceil(low.y), size_); y <= texelOf(std::floor(high.y), size_); ++y)
      for (int x = texelOf(std::ceil(low.x), size_); x <= texelOf(std::floor(high.x), size_); ++x) {
        const Vec2 at(static_cast<float>(x), static_cast<float>(y));
        bool inside = area > 0.0f;
        for (int k = 0; k < 3; ++k) inside = inside && cross2(p[(k + 1) % 3] - p[k], at - p[k]) >= 0.0f;
        if (inside) chartOfTexel_[static_cast<std::size_t>(y) * size_ + x] = chart;
      }
  }
  // Triangles too fine to hold a texel's centre.
  for (const auto& vertex : surface.vertices) {
    const int x = texelOf(vertex.atlas.x * scale, size_), y = texelOf(vertex.atlas.y * scale, size_);
    std::uint16_t& chart = chartOfTexel_[static_cast<std::size_t>(y) * size_ + x];
    if (chart == kNoChart && vertex.chart < kNoChart) chart = static_cast<std::uint16_t>(vertex.chart);
  }
}

void SurfaceWetting::dilate() {
  const std::vector<std::uint16_t> before = chartOfTexel_;
  // Straight neighbours first: they are nearer.
  constexpr int kSteps[8][2] = {{1, 0}, {-1, 0}, {0, 1}, {0, -1}, {1, 1}, {-1, 1}, {1, -1}, {-1, -1}};
  for (int y = 0; y < size_; ++y)
    for (int x = 0; x < size_; ++x) {
      const std::size_t texel = static_cast<std::size_t>(y) * size_ + x;
      for (int k = 0; k < 8 && chartOfTexel_[texel] == kNoChart; ++k) {
        const int nx = x + kSteps[k][0], ny = y + kSteps[k][1];
        if (nx < 0 || ny < 0 || nx >= size_ || ny >= size_) continue;
        chartOfTexel_[texel] = before[static_cast<std::size_t>(ny) * size_ + nx];
      }
    }
}

std::vector<SurfaceWetting::Sheet> SurfaceWetting::sheetsAt(const geometry::Surface& surface,
                                                            const geometry::SurfaceQuery& query, const Vec3& centre,
                                                            const Vec3& normal, float radius) const {
  FUR_ASSERT(surface.triangleCount() == faces_.size(), "SurfaceWetting::sheetsAt()", "the surface it was built from",
             surface.triangleCount());
  std::vector<std::pair<float, std::uint32_t>> near;
  for (const std::uint32_t t : query.trianglesWithin(centre, radius)) {
    if (faces_[t].area <= 0.0f || glm::dot(faces_[t].normal, normal) <= 0.0f) continue;
    const Vec3 way = centre - closestOnTriangle(centre, corner(surface, t, 0).position,
                                                corner(surface, t, 1).position, corner(surface, t, 2).position);
    near.emplace_back(glm::dot(way, way), t);
  }
  // The nearest triangle of a sheet says where its centre is, the others only agree.
  std::sort(near.begin(), near.end());
  std::vector<Sheet> sheets;
  for (const auto& [distance, t] : near) {
    const Face& face = faces_[t];
    const std::uint16_t chart = chartOf(surface, t);
    const Vec2 at = face.origin + Vec2(glm::dot(face.gradU, centre), glm::dot(face.gradV, centre));
    const auto same = std::find_if(sheets.begin(), sheets.end(), [&](const Sheet& sheet) {
      const Vec2 apart = at - sheet.centre;
      const float reach = radius * sheet.scale();
      return sheet.chart == chart && glm::dot(apart, apart) <= reach * reach;
    });
    if (same != sheets.end()) {
      same->area += face.area;
      same->scaledArea += face.area * face.scale;
    } else if (sheets.size() < kMaxSheets) {
      sheets.push_back({chart, at, face.area, face.area * face.scale});
    }
  }
  return sheets;
}

void SurfaceWetting::addDroplet(WetnessMask& mask, const geometry::Surface& surface,
                                const geometry::SurfaceQuery& query, const Vec3& centre, const Vec3& normal,
                                float radius, float wetness) const {
  FUR_ASSERT(mask.size() == size_, "SurfaceWetting::addDroplet()", "a mask of the size it was built for", mask.size());
  for (const Sheet& sheet : sheetsAt(surface, query, centre, normal, radius))
    mask.addDroplet({sheet.centre, radius * sheet.scale(), wetness}, chartOfTexel_.data(), sheet.chart);
}

void SurfaceWetting::dryAt(WetnessMask& mask, const geometry::Surface& surface, const geometry::SurfaceQuery& query,
                           const Vec3& centre, const Vec3& normal, float radius, float amount) const {
  FUR_ASSERT(mask.size() == size_, "SurfaceWetting::dryAt()", "a mask of the size it was built for", mask.size());
  for (const Sheet& sheet : sheetsAt(surface, query, centre, normal, radius))
    mask.dryAt({sheet.centre, radius * sheet.scale(), amount}, chartOfTexel_.data(), sheet.chart);
}

}  // namespace fur::wet
