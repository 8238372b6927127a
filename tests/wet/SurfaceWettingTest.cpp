#include "wet/SurfaceWetting.h"

#include <gtest/gtest.h>

#include <cmath>
#include <map>

#include "geometry/Primitives.h"

namespace fur::wet {
namespace {

using geometry::Surface;
using geometry::SurfaceQuery;

constexpr int kSize = 256;

Surface chartedSphere() {
  geometry::Mesh mesh = geometry::makeSphere();
  mesh.uv.clear();
  return geometry::buildSurface(mesh).value();
}

// Two squares side by side in the plane y = 0, met at x = 0; the right one lies elsewhere in the
// atlas, turned by a quarter.
Surface twoCharts() {
  Surface s;
  const auto add = [&s](Vec3 position, Vec2 atlas, std::uint32_t chart) {
    geometry::SurfaceVertex v{};
    v.position = position;
    v.normal = Vec3(0, 1, 0);
    v.atlas = atlas;
    v.chart = chart;
    s.vertices.push_back(v);
  };
  add({-0.4f, 0, -0.2f}, {0.05f, 0.05f}, 0);
  add({0, 0, -0.2f}, {0.45f, 0.05f}, 0);
  add({0, 0, 0.2f}, {0.45f, 0.45f}, 0);
  add({-0.4f, 0, 0.2f}, {0.05f, 0.45f}, 0);
  add({0, 0, -0.2f}, {0.95f, 0.55f}, 1);
  add({0.4f, 0, -0.2f}, {0.95f, 0.95f}, 1);
  add({0.4f, 0, 0.2f}, {0.55f, 0.95f}, 1);
  add({0, 0, 0.2f}, {0.55f, 0.55f}, 1);
  s.indices = {0, 2, 1, 0, 3, 2, 4, 6, 5, 4, 7, 6};
  s.chartCount = 2;
  return s;
}

// Where a clump centre of that chart lies in space (the inverse of the atlas above).
Vec3 inSpace(const Vec4& texel, int chart) {
  if (chart == 0) return {texel.x - 0.45f, 0, texel.y - 0.25f};
  return {texel.y - 0.55f, 0, 0.75f - texel.x};
}

TEST(SurfaceWetting, WetsBothSidesOfAChartBorderWithOneCentre) {
  const Surface surface = twoCharts();
  const SurfaceQuery query(surface);
  const SurfaceWetting wetting(surface, kSize);
  const Vec3 centre(-0.03f, 0, 0.04f);
  WetnessMask mask(kSize);
  wetting.addDroplet(mask, surface, query, centre, Vec3(0, 1, 0), 0.1f, 0.5f);
  std::map<int, int> wet;
  for (std::size_t i = 0; i < mask.texels().size(); ++i) {
    const Vec4& texel = mask.texels()[i];
    if (texel.w <= 0) continue;
    const int chart = wetting.chartOfTexel()[i];
    ++wet[chart];
    ASSERT_LT(glm::length(inSpace(texel, chart) - centre), 1.0f / kSize);
    ASSERT_NEAR(texel.z, 0.1f, 1e-4f);
  }
  EXPECT_GT(wet[0], wet[1]);  // the centre is on the side of chart 0
  // A disc of 0.1 at 1 atlas unit per model unit; its rim adds or drops some texels, the gutter adds more.
  EXPECT_NEAR(wet[0] + wet[1], 3.14159 * 25.6 * 25.6, 250);
  EXPECT_EQ(wet.count(SurfaceWetting::kNoChart), 0u);
}

TEST(SurfaceWetting, DriesBothSidesOfAChartBorder) {
  const Surface surface = twoCharts();
  const SurfaceQuery query(surface);
  const SurfaceWetting wetting(surface, kSize);
  WetnessMask mask(kSize);
  wetting.addDroplet(mask, surface, query, Vec3(0), Vec3(0, 1, 0), 0.1f, 0.5f);
  wetting.dryAt(mask, surface, query, Vec3(0), Vec3(0, 1, 0), 0.15f, 1.0f);
  EXPECT_TRUE(mask.isDry());
}

TEST(SurfaceWetting, LeavesTheFarSideOfAThinSheetDry) {
  Surface surface = twoCharts();
  // Fold the right half back under the left one, a hair below.
  for (int k = 4; k < 8; ++k) surface.vertices[k].position = Vec3(-1, 1, 1) * surface.vertices[k].position + Vec3(0, -0.01f, 0);
  const SurfaceQuery query(surface);
  const SurfaceWetting wetting(surface, kSize);
  WetnessMask mask(kSize);
  wetting.addDroplet(mask, surface, query, Vec3(-0.2f, 0, 0), Vec3(0, 1, 0), 0.05f, 0.5f);
  EXPECT_FALSE(mask.isDry());
  for (std::size_t i = 0; i < mask.texels().size(); ++i)
    ASSERT_TRUE(mask.texels()[i].w <= 0 || wetting.chartOfTexel()[i] == 0);
}

TEST(SurfaceWetting, GivesEverySurfacePointATexelOfItsChart) {
  const Surface surface = chartedSphere();
  const SurfaceWetting wetting(surface, kSize);
  for (std::uint32_t t = 0; t < surface.triangleCount(); ++t)
    for (const Vec3& weights : {Vec3(1 / 3.0f), Vec3(0.98f, 0.01f, 0.01f), Vec3(0, 0.5f, 0.5f)}) {
      const Vec2 at = geometry::atlasAt(surface, {t, weights, 0});
      const int x = static_cast<int>(at.x * kSize), y = static_cast<int>(at.y * kSize);
      ASSERT_EQ(wetting.chartOfTexel()[static_cast<std::size_t>(y) * kSize + x],
                surface.vertices[surface.indices[t * 3]].chart);
    }
}

TEST(SurfaceWetting, WetsADiscInSpaceAcrossTheChartsOfASphere) {
  const Surface surface = chartedSphere();
  const SurfaceQuery query(surface);
  const SurfaceWetting wetting(surface, kSize);
  const float radius = 0.12f;
  for (const Vec3& direction : {Vec3(1, 0, 0), Vec3(1, 1, 0), Vec3(1, 1, 1), Vec3(-1, 0.9f, 0.2f), Vec3(0, -1, 0.8f)}) {
    const Vec3 centre = glm::normalize(direction);
    WetnessMask mask(kSize);
    wetting.addDroplet(mask, surface, query, centre, centre, radius, 0.5f);
    for (std::uint32_t t = 0; t < surface.triangleCount(); ++t) {
      const geometry::SurfacePoint middle{t, Vec3(1 / 3.0f), 0};
      const float distance = glm::length(geometry::positionAt(surface, middle) - centre);
      const Vec2 at = geometry::atlasAt(surface, middle);
      // Between: texels are coarse and the charts flatten the sphere.
      const bool wet = mask.at(at.x, at.y).w > 0.0f;
      ASSERT_TRUE(wet || distance >= 0.75f * radius) << distance;
      ASSERT_TRUE(!wet || distance <= 1.4f * radius) << distance;
    }
  }
}

TEST(SurfaceWetting, ClosesOverTheDateLineOfAGlobe) {
  // The sphere's own uv: one chart that meets itself at longitude 0.
  const Surface surface = geometry::buildSurface(geometry::makeSphere()).value();
  const SurfaceQuery query(surface);
  const SurfaceWetting wetting(surface, kSize);
  for (const auto& vertex : surface.vertices) {
    if (std::abs(vertex.position.y) > 0.2f) continue;
    WetnessMask mask(kSize);
    wetting.addDroplet(mask, surface, query, vertex.position, vertex.normal, 0.12f, 0.5f);
    for (std::uint32_t t = 0; t < surface.triangleCount(); ++t) {
      const geometry::SurfacePoint middle{t, Vec3(1 / 3.0f), 0};
      if (glm::length(geometry::positionAt(surface, middle) - vertex.position) > 0.07f) continue;
      const Vec2 at = geometry::atlasAt(surface, middle);
      ASSERT_GT(mask.at(at.x, at.y).w, 0.0f);
    }
  }
}

TEST(SurfaceWetting, DoesNothingAwayFromTheSurface) {
  const Surface surface = twoCharts();
  const SurfaceQuery query(surface);
  const SurfaceWetting wetting(surface, kSize);
  WetnessMask mask(kSize);
  wetting.addDroplet(mask, surface, query, Vec3(0, 5, 0), Vec3(0, 1, 0), 0.1f, 0.5f);
  wetting.addDroplet(mask, surface, query, Vec3(0), Vec3(0, 1, 0), 0.0f, 0.5f);
  wetting.addDroplet(mask, surface, query, Vec3(std::nanf("")), Vec3(0, 1, 0), 0.1f, 0.5f);
  EXPECT_TRUE(mask.isDry());
}

}  // namespace
}  // namespace fur::wet
