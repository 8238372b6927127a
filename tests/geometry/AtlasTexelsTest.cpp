#include "geometry/AtlasTexels.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "core/Random.h"
#include "geometry/Adjacency.h"
#include "geometry/Primitives.h"
#include "geometry/SurfaceQuery.h"

namespace fur::geometry {
namespace {

constexpr int kSize = 128;

Surface chartedTorus() {
  Mesh mesh = makeTorus();
  mesh.uv.clear();
  return buildSurface(mesh).value();
}

int texelAt(const Vec2& atlas, int size) {
  return static_cast<int>(atlas.y * size) * size + static_cast<int>(atlas.x * size);
}

TEST(AtlasTexels, EveryPointOfTheSurfaceLiesOnATexelOfItsChart) {
  const Surface surface = chartedTorus();
  constexpr int kFine = 256;  // between charts lie two texels of such a map (ChartPacking.h): one of kSize may hold points of both
  const AtlasTexels texels(surface, kFine);
  for (std::uint32_t t = 0; t < surface.triangleCount(); ++t)
    for (const Vec3& weights : {Vec3(1 / 3.0f), Vec3(0.98f, 0.01f, 0.01f), Vec3(0, 0.5f, 0.5f)}) {
      std::uint32_t at = static_cast<std::uint32_t>(texelAt(atlasAt(surface, {t, weights, 0}), kFine));
      for (const auto& [texel, source] : texels.gutter())
        if (texel == at) at = source;
      const std::uint32_t owner = texels.triangleOf()[at];
      ASSERT_NE(owner, kNoTriangle);
      ASSERT_EQ(surface.vertices[surface.indices[3 * owner]].chart, surface.vertices[surface.indices[3 * t]].chart);
    }
}

TEST(AtlasTexels, EachTexelIsVisitedOnceAndKnowsWhereItLies) {
  const Surface surface = chartedTorus();
  const AtlasTexels texels(surface, kSize);
  std::vector<int> visits(kSize * kSize, 0);
  for (std::uint32_t t = 0; t < surface.triangleCount(); ++t)
    texels.forTexelsOf(surface, t, [&](std::uint32_t texel, const Vec3& weights) {
      ++visits[texel];
      ASSERT_NEAR(weights.x + weights.y + weights.z, 1, 1e-5);
      const Vec2 centre((static_cast<float>(texel % kSize) + 0.5f) / kSize, (static_cast<float>(texel / kSize) + 0.5f) / kSize);
      // Its own centre; where a triangle only touches the texel, a point of it that is near, if not the nearest.
      ASSERT_LT(glm::length(atlasAt(surface, {t, weights, 0}) - centre), 1.2f / kSize);
    });
  for (std::size_t i = 0; i < visits.size(); ++i) ASSERT_EQ(visits[i], texels.triangleOf()[i] == kNoTriangle ? 0 : 1);
}

// What other maps have there is of the triangles that were left out.
TEST(AtlasTexels, NoGutterGrowsIntoWhereTrianglesWereLeftOut) {
  const Surface surface = chartedTorus();
  const AtlasTexels all(surface, kSize);
  std::vector<std::uint8_t> without(surface.triangleCount());
  for (std::uint32_t t = 0; t < surface.triangleCount(); ++t) without[t] = surface.vertices[surface.indices[3 * t]].chart % 2;
  const AtlasTexels some(surface, kSize, without);
  std::size_t kept = 0;
  for (std::size_t i = 0; i < all.triangleOf().size(); ++i) {
    const std::uint32_t owner = all.triangleOf()[i];
    ASSERT_EQ(some.triangleOf()[i], owner != kNoTriangle && without[owner] ? kNoTriangle : owner);
  }
  for (const auto& [texel, source] : all.gutter()) kept += !without[all.triangleOf()[source]];
  EXPECT_LT(kept, all.gutter().size());
  EXPECT_EQ(some.gutter().size(), kept);
  for (const auto& [texel, source] : some.gutter()) EXPECT_FALSE(without[some.triangleOf()[source]]);
}

TEST(AtlasTexels, GuttersRepeatATexelThatIsNear) {
  const AtlasTexels texels(chartedTorus(), kSize);
  EXPECT_FALSE(texels.gutter().empty());
  EXPECT_TRUE(std::is_sorted(texels.gutter().begin(), texels.gutter().end())) << "row-major";
  for (const auto& [texel, source] : texels.gutter()) {
    ASSERT_EQ(texels.triangleOf()[texel], kNoTriangle);
    ASSERT_NE(texels.triangleOf()[source], kNoTriangle);
    const int dx = static_cast<int>(texel % kSize) - static_cast<int>(source % kSize);
    const int dy = static_cast<int>(texel / kSize) - static_cast<int>(source / kSize);
    ASSERT_LE(std::max(std::abs(dx), std::abs(dy)), AtlasTexels::kGutter);
  }
}

TEST(AtlasTriangle, MeetsTheSquaresThatHoldAPointOfItAndNoneFarAway) {
  Random random(5);
  const auto point = [&] { return Vec2(random.uniform(0.1f, 0.9f), random.uniform(0.1f, 0.9f)); };
  for (int round = 0; round < 200; ++round) {
    const Vec2 a = point(), b = point(), c = point();
    const AtlasTriangle flat(a, b, c, 16);
    if (flat.area < 0.5f) continue;
    const TexelRect box = flat.bounds(1);
    for (int sample = 0; sample < 100; ++sample) {
      float u = random.uniform(), v = random.uniform();
      if (u + v > 1) u = 1 - u, v = 1 - v;
      const Vec2 at = (a + (b - a) * u + (c - a) * v) * 16.0f - 0.5f;
      // The four texels that a filtered look-up there reads.
      for (const int x : {static_cast<int>(std::floor(at.x)), static_cast<int>(std::floor(at.x)) + 1})
        for (const int y : {static_cast<int>(std::floor(at.y)), static_cast<int>(std::floor(at.y)) + 1}) {
          ASSERT_TRUE(flat.meets(x, y, 1));
          ASSERT_TRUE(x >= box.x0 && x < box.x1 && y >= box.y0 && y < box.y1);
        }
    }
    EXPECT_FALSE(flat.meets(-40, 3, 1) && flat.meets(60, 3, 1) && flat.meets(3, -40, 1));
  }
}

}  // namespace
}  // namespace fur::geometry
