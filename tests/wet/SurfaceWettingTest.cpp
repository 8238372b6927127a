#include "wet/SurfaceWetting.h"

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <tuple>

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

// A texel, and how its triangle lies in space and in the atlas.
struct TexelOnSurface {
  Vec3 position, alongU, alongV;
  Vec2 atlas;
};
TexelOnSurface texelOnSurface(const Surface& surface, const geometry::AtlasTexels& atlas, std::uint32_t texel) {
  const std::uint32_t triangle = atlas.triangleOf()[texel];
  const geometry::SurfacePoint point{triangle, atlas.weightsAt(surface, triangle, texel), 0};
  const auto &a = surface.vertices[surface.indices[3 * triangle]], &b = surface.vertices[surface.indices[3 * triangle + 1]],
             &c = surface.vertices[surface.indices[3 * triangle + 2]];
  const glm::mat2 uv(b.atlas - a.atlas, c.atlas - a.atlas);
  const glm::mat2x3 steps = glm::mat2x3(b.position - a.position, c.position - a.position) * glm::inverse(uv);
  return {positionAt(surface, point), steps[0], steps[1], atlasAt(surface, point)};
}

TEST(SurfaceWetting, HasOneCentreInSpaceOnBothSidesOfEverySeam) {
  geometry::Mesh torus = geometry::makeTorus();
  torus.uv.clear();
  for (const Surface& surface : {chartedSphere(), geometry::buildSurface(torus).value()}) {
    const SurfaceQuery query(surface);
    const SurfaceWetting wetting(surface, kSize);
    // Points that several charts share.
    std::map<std::tuple<float, float, float>, std::vector<std::uint32_t>> vertices;
    for (std::uint32_t i = 0; i < surface.trueVertexCount; ++i) {
      const Vec3 p = surface.vertices[i].position;
      vertices[{p.x, p.y, p.z}].push_back(i);
    }
    int seams = 0;
    for (const auto& [at, same] : vertices) {
      bool border = false;
      for (const std::uint32_t i : same) border |= surface.vertices[i].chart != surface.vertices[same[0]].chart;
      if (!border || ++seams % 7) continue;
      const Vec3 centre = surface.vertices[same[0]].position;
      const float radius = 0.08f;
      WetnessMask mask(kSize);
      wetting.addDroplet(mask, surface, query, centre, surface.vertices[same[0]].normal, radius, 0.5f);
      std::map<int, int> charts;
      for (std::uint32_t i = 0; i < mask.texels().size(); ++i) {
        const Vec4& texel = mask.texels()[i];
        if (texel.w <= 0 || wetting.atlas().triangleOf()[i] == 0xffffffffu) continue;
        const TexelOnSurface spot = texelOnSurface(surface, wetting.atlas(), i);
        const float distance = glm::length(spot.position - centre);
        ++charts[wetting.chartOfTexel()[i]];
        // Farther off the texel's plane is no longer the skin at the centre.
        if (distance > 0.5f * radius) continue;
        const Vec2 way = Vec2(texel) - spot.atlas;
        const float step = std::max(glm::length(spot.alongU), glm::length(spot.alongV)) / kSize;
        ASSERT_LT(glm::length(spot.position + spot.alongU * way.x + spot.alongV * way.y - centre), step);
      }
      EXPECT_GE(charts.size(), 2u);
    }
    EXPECT_GT(seams, 20);
  }
}

TEST(SurfaceWetting, IsRoundOnTheSkinWhereTheAtlasIsStretched) {
  // A globe in its own uv: at a latitude of 60 degrees a degree of longitude is half as long.
  const Surface surface = geometry::buildSurface(geometry::makeSphere()).value();
  const SurfaceQuery query(surface);
  const SurfaceWetting wetting(surface, kSize);
  const float radius = 0.15f, latitude = kPi / 3;
  const Vec3 up = Vec3(std::sin(2.0f) * std::cos(latitude), std::sin(latitude), std::cos(2.0f) * std::cos(latitude));
  const auto hit = query.castRay(2.0f * up, -up);
  ASSERT_TRUE(hit);
  const Vec3 centre = positionAt(surface, *hit);
  WetnessMask mask(kSize);
  wetting.addDroplet(mask, surface, query, centre, up, radius, 0.5f);
  float low = 1e9f, high = 0;
  for (std::uint32_t i = 0; i < mask.texels().size(); ++i) {
    if (wetting.atlas().triangleOf()[i] == 0xffffffffu) continue;
    const TexelOnSurface spot = texelOnSurface(surface, wetting.atlas(), i);
    const float distance = glm::length(spot.position - centre);
    const Vec4 texel = mask.texels()[i];
    // One stretch for all of it: the latitude changes by a seventh of a radian across.
    if (distance < 0.85f * radius) ASSERT_GT(texel.w, 0.0f) << distance;
    if (distance > 1.2f * radius) ASSERT_EQ(texel.w, 0.0f) << distance;
    if (texel.w <= 0 || distance < 0.5f * radius) continue;
    // How far it is from the centre in radii, as the shaders see it, against how far it is in space.
    const float seen = glm::length(spot.atlas - Vec2(texel)) / texel.z;
    low = std::min(low, seen * radius / distance);
    high = std::max(high, seen * radius / distance);
  }
  EXPECT_GT(low, 0.8f);
  EXPECT_LT(high, 1.25f);
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
