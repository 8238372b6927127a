// Charts, their packing, and the choice of atlas.
#include <gtest/gtest.h>

#include "geometry/ChartPacking.h"
#include "geometry/SurfaceChecks.h"
#include "geometry/TriangleGrid.h"

namespace fur::geometry {
namespace {

struct Shape {
  const char* name;
  Mesh mesh;
};

std::vector<Shape> shapes() {
  return {{"sphere", withoutUv(makeSphere())},
          {"torus", withoutUv(makeTorus())},
          {"plane", withoutUv(makePlane())},
          {"lump", makeLump()}};
}

TEST(Atlas, GivesEverySurfacePointItsOwnTexel) {
  for (const Shape& shape : shapes()) {
    for (const int count : coverage(built(shape.mesh), 512)) ASSERT_LE(count, 1) << shape.name;
  }
}

TEST(Atlas, StaysInsideTheUnitSquare) {
  for (const Shape& shape : shapes()) {
    for (const SurfaceVertex& v : built(shape.mesh).vertices) {
      ASSERT_GE(std::min(v.atlas.x, v.atlas.y), 0.0f) << shape.name;
      ASSERT_LE(std::max(v.atlas.x, v.atlas.y), 1.0f) << shape.name;
    }
  }
}

TEST(Atlas, KeepsAGutterOfTwoTexelsBetweenCharts) {
  for (const Shape& shape : shapes()) {
    // At four times the resolution two texels are eight; a texel less at each end is the raster's own.
    constexpr int kSize = 1024, kReach = 2 * kSize / 256 - 2;
    std::vector<std::uint32_t> chart;
    coverage(built(shape.mesh), kSize, &chart);
    for (int y = kReach; y < kSize; ++y) {
      for (int x = kReach; x < kSize; ++x) {
        const std::uint32_t here = chart[static_cast<std::size_t>(y * kSize + x)];
        const std::uint32_t left = chart[static_cast<std::size_t>(y * kSize + x - kReach)];
        const std::uint32_t above = chart[static_cast<std::size_t>((y - kReach) * kSize + x)];
        if (here == 0xffffffffu) continue;
        ASSERT_TRUE(left == here || left == 0xffffffffu) << shape.name << " at " << x << ", " << y;
        ASSERT_TRUE(above == here || above == 0xffffffffu) << shape.name << " at " << x << ", " << y;
      }
    }
  }
}

TEST(Atlas, HasFewChartsAndUsesTheSquare) {
  for (const Shape& shape : shapes()) {
    const Surface surface = built(shape.mesh);
    double filled = 0.0;
    for (const int count : coverage(surface, 256)) filled += count > 0;
    EXPECT_LE(surface.chartCount, 30u) << shape.name;
    EXPECT_GE(filled / (256.0 * 256.0), 0.33) << shape.name;
  }
}

TEST(Atlas, HasTheSameScaleInEveryChart) {
  // Charts are flattened and then only moved, turned and scaled, all alike.
  const Surface surface = built(makeLump());
  const auto determinant = [](const Vec4& m) { return m.x * m.w - m.y * m.z; };
  const float first = determinant(surface.vertices[0].atlasFromFur);
  EXPECT_GT(first, 0.0f);
  for (std::size_t i = 0; i < surface.trueVertexCount; ++i)
    // Worked out from coordinates of size 1 (6e-8) over edges of a few hundredths.
    ASSERT_NEAR(determinant(surface.vertices[i].atlasFromFur), first, 1e-3f * first);
}

TEST(Atlas, KeepsTheMeshsOwnUniqueUv) {
  for (const Mesh& mesh : {makeSphere(), makeTorus(), makePlane()}) {
    for (const SurfaceVertex& v : built(mesh).vertices) ASSERT_EQ(v.atlas, v.uv);
  }
}

TEST(Atlas, MakesChartsWhereOwnUvOverlapRepeatOrVanish) {
  Mesh mirrored = makeTorus();
  for (Vec2& uv : mirrored.uv) uv.x = 1.0f - std::abs(2.0f * uv.x - 1.0f);
  Mesh repeated = makeTorus();
  for (Vec2& uv : repeated.uv) uv *= 2.0f;
  Mesh point = makeTorus();
  for (Vec2& uv : point.uv) uv = Vec2(0.5f);
  Mesh broken = makeTorus();
  broken.uv[7].x = NAN;
  for (const Mesh& mesh : {mirrored, repeated, point, broken}) {
    const Surface surface = built(mesh);
    EXPECT_GT(surface.chartCount, 1u);
    for (const int count : coverage(surface, 256)) ASSERT_LE(count, 1);
  }
}

TEST(Atlas, IsTheSameOnEveryRun) {
  const Surface first = built(makeLump()), second = built(makeLump());
  ASSERT_EQ(first.vertices.size(), second.vertices.size());
  EXPECT_EQ(first.indices, second.indices);
  for (std::size_t i = 0; i < first.vertices.size(); ++i) ASSERT_EQ(first.vertices[i].atlas, second.vertices[i].atlas);
}

TEST(Atlas, TakesTriangleSoups) {
  Mesh soup;
  Random random(5);
  for (std::uint32_t i = 0; i < 9000; ++i) {
    soup.positions.push_back(Vec3(random.uniform(-0.5f, 0.5f), random.uniform(-0.5f, 0.5f), random.uniform(-0.5f, 0.5f)));
    soup.indices.push_back(i);
  }
  const Surface surface = built(soup);
  EXPECT_EQ(surface.chartCount, 3000u);
  for (const int count : coverage(surface, 1024)) ASSERT_LE(count, 1);
}

TEST(Atlas, TakesAFanOfManyTrianglesRoundOneVertex) {
  Mesh fan;
  fan.positions.push_back(Vec3(0, 0.2f, 0));
  constexpr std::uint32_t kCount = 20000;
  for (std::uint32_t i = 0; i < kCount; ++i) {
    const float angle = 2.0f * kPi * static_cast<float>(i) / kCount;
    fan.positions.push_back(Vec3(std::cos(angle), 0, -std::sin(angle)));
    fan.indices.insert(fan.indices.end(), {0u, i + 1, (i + 1) % kCount + 1});
  }
  EXPECT_EQ(ownSurface(built(fan), fan).surface.triangleCount(), kCount);
}

TEST(TriangleGrid, AgreesWithComparingAllPairs) {
  Random random(11);
  const auto randomTriangle = [&] {
    const Vec2 middle(random.uniform(), random.uniform());
    FlatTriangle out;
    for (Vec2& p : out) p = middle + Vec2(random.uniform(-0.1f, 0.1f), random.uniform(-0.1f, 0.1f));
    return out;
  };
  TriangleGrid grid(Vec2(-0.1f), Vec2(1.1f), 100, 1e-6f);
  std::vector<FlatTriangle> accepted;
  for (int i = 0; i < 2000; ++i) {
    const FlatTriangle triangle = randomTriangle();
    bool free = true;
    for (const FlatTriangle& other : accepted) free = free && !trianglesOverlap(other, triangle, 1e-6f);
    ASSERT_EQ(grid.tryAdd(triangle), free);
    if (free) accepted.push_back(triangle);
  }
  EXPECT_GT(accepted.size(), 50u);
}

TEST(TriangleGrid, LetsNeighboursTouch) {
  const FlatTriangle a{Vec2(0, 0), Vec2(1, 0), Vec2(0, 1)};
  EXPECT_FALSE(trianglesOverlap(a, {Vec2(1, 0), Vec2(1, 1), Vec2(0, 1)}, 0.0f));
  EXPECT_FALSE(trianglesOverlap(a, {Vec2(1, 0), Vec2(2, 0), Vec2(1, 1)}, 0.0f));
  EXPECT_TRUE(trianglesOverlap(a, {Vec2(0.2f, 0.2f), Vec2(0.3f, 0.2f), Vec2(0.2f, 0.3f)}, 0.0f));
  EXPECT_TRUE(trianglesOverlap(a, a, 0.0f));
}

}  // namespace
}  // namespace fur::geometry
