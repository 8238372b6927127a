// Where fur coordinates come from, and how evenly they lie.
#include <gtest/gtest.h>

#include "geometry/FurDensity.h"
#include "geometry/SurfaceChecks.h"

namespace fur::geometry {
namespace {

Surface cubeMapped(const Mesh& mesh) { return buildSurface(mesh, FurMapping::Cube).value(); }

TEST(FurDensity, IsOneOnAPlaneWithBothMappings) {
  for (const FurMapping mapping : {FurMapping::Charts, FurMapping::Cube}) {
    const FurDensity density = measureFurDensity(buildSurface(makePlane(), mapping).value());
    EXPECT_NEAR(density.low, 1.0f, 1e-4f);
    EXPECT_NEAR(density.high, 1.0f, 1e-4f);
    EXPECT_NEAR(density.worstStretch, 1.0f, 1e-3f);
  }
}

TEST(FurDensity, SeesAStretchAndASqueeze) {
  Surface surface = built(makePlane());
  for (SurfaceVertex& v : surface.vertices) v.fur = Vec2(2.0f * v.fur.x, 0.5f * v.fur.y);
  const FurDensity density = measureFurDensity(surface);
  EXPECT_NEAR(density.median, 1.0f, 1e-4f);
  EXPECT_NEAR(density.lowLength, 0.5f, 1e-3f);
  EXPECT_NEAR(density.highLength, 2.0f, 1e-3f);
  EXPECT_NEAR(density.worstStretch, 4.0f, 1e-2f);
}

TEST(FurCharts, AreEvenOnRoundShapes) {
  for (const Mesh& mesh : {withoutUv(makeSphere()), makeTorus(), makeLump()}) {
    const FurDensity density = measureFurDensity(built(mesh));
    // A sphere in a few charts cannot lie flat without stretching; a quarter less or more strands
    // to a length is where the eye begins to see it.
    EXPECT_GT(density.low, 0.75f);
    EXPECT_NEAR(density.median, 1.0f, 0.05f);
    EXPECT_LT(density.high, 1.25f);
    // What remains of slopes along the rims, that springs could not lift without folding.
    EXPECT_GT(density.lowLength, 0.6f);
    EXPECT_LT(density.highLength, 1.25f);
  }
}

TEST(CubeMapping, NeverPutsFurCloserThanTheFaceDoes) {
  // Along the face's normal lengths can only shrink, and on round shapes by no more than 1 / sqrt(3) at
  // the cube's corners, but where a slope is torn along.
  for (const Mesh& mesh : {makeSphere(), makeTorus(), makeLump()}) {
    const FurDensity density = measureFurDensity(cubeMapped(mesh));
    EXPECT_LT(density.highLength, 1.0001f);
    EXPECT_GT(density.low, 0.5f);
  }
}

TEST(CubeMapping, MapsASphereToTheFaceThatItLooksAt) {
  const Surface surface = cubeMapped(withoutUv(makeSphere()));
  for (std::size_t t = 0; t < surface.triangleCount(); ++t) {
    const auto v = cornersOf(surface, t);
    const Vec3 normal = glm::normalize(glm::cross(v[1]->position - v[0]->position, v[2]->position - v[0]->position));
    const Vec2 a = v[1]->fur - v[0]->fur, b = v[2]->fur - v[0]->fur;
    const Vec3 cross = glm::cross(v[1]->position - v[0]->position, v[2]->position - v[0]->position);
    // Area on the face over area on the sphere: the cosine to the face, 1 / sqrt(3) at the cube's corners;
    // triangles there are 3 degrees wide.
    const float cosine = (a.x * b.y - a.y * b.x) / glm::length(cross);
    EXPECT_GT(cosine, 0.5f);
    EXPECT_NEAR(cosine, std::max({std::abs(normal.x), std::abs(normal.y), std::abs(normal.z)}), 0.08f);
  }
}

TEST(CubeMapping, KeepsTheAtlasOfTheCharts) {
  const Surface cube = cubeMapped(makeLump()), charts = built(makeLump());
  EXPECT_EQ(cube.chartCount, charts.chartCount);
  for (std::size_t i = 0; i < cube.indices.size(); ++i)
    ASSERT_EQ(cube.vertices[cube.indices[i]].atlas, charts.vertices[charts.indices[i]].atlas);
}

Mesh withFurUv(Mesh mesh, float scale) {
  mesh.furUv.clear();
  for (const Vec3& p : mesh.positions) mesh.furUv.push_back(Vec2(p.x, -p.z) * scale);
  return mesh;
}

TEST(OwnFurUv, AreKeptButForTheirScale) {
  for (const float scale : {0.01f, 1.0f, 300.0f}) {
    const Surface surface = built(withFurUv(makePlane(), scale));
    const FurDensity density = measureFurDensity(surface);
    EXPECT_NEAR(density.median, 1.0f, 1e-4f) << scale;
    for (const SurfaceVertex& v : surface.vertices) {
      ASSERT_NEAR(v.fur.x, v.position.x, 1e-5f) << scale;
      ASSERT_NEAR(v.fur.y, -v.position.z, 1e-5f) << scale;
    }
  }
}

TEST(OwnFurUv, MakeChartsOfWhatIsConnectedInThem) {
  Mesh two = makePlane(16);
  two.furUv.assign(two.positions.size(), Vec2(0.0f));
  // Both halves carry the same coordinates, mirrored at x = 0, and turned round on one side: a border.
  Mesh left = two, right = two;
  left.indices.clear();
  right.indices.clear();
  for (std::size_t i = 0; i < two.indices.size(); i += 3) {
    float x = 0;
    for (std::size_t k = 0; k < 3; ++k) x += two.positions[two.indices[i + k]].x;
    auto& half = (x < 0 ? left : right).indices;
    half.insert(half.end(), two.indices.begin() + static_cast<std::ptrdiff_t>(i), two.indices.begin() + static_cast<std::ptrdiff_t>(i + 3));
  }
  Mesh mesh = left;
  const auto offset = static_cast<std::uint32_t>(mesh.positions.size());
  mesh.positions.insert(mesh.positions.end(), right.positions.begin(), right.positions.end());
  mesh.normals.insert(mesh.normals.end(), right.normals.begin(), right.normals.end());
  mesh.uv.clear();
  for (const std::uint32_t v : right.indices) mesh.indices.push_back(v + offset);
  mesh.furUv.clear();
  for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
    const Vec3& p = mesh.positions[i];
    mesh.furUv.push_back(i < offset ? Vec2(p.x, -p.z) : Vec2(p.z, p.x) + 5.0f);
  }
  const Surface surface = built(mesh);
  // Lapped: the first half's fur goes on over the second half's border, straight.
  std::size_t copies = 0;
  for (std::size_t i = surface.trueVertexCount; i < surface.vertices.size(); ++i, ++copies) {
    const SurfaceVertex& v = surface.vertices[i];
    EXPECT_NEAR(v.fur.x, v.position.x, 1e-5f);
    EXPECT_NEAR(v.fur.y, -v.position.z, 1e-5f);
  }
  EXPECT_GT(copies, 16u);
}

TEST(OwnFurUv, ThatAreNoCoordinatesGiveWayToCharts) {
  Mesh broken = withFurUv(makeTorus(), 1.0f), point = makeTorus(), tooFew = withFurUv(makeTorus(), 1.0f);
  broken.furUv[3].y = NAN;
  point.furUv.assign(point.positions.size(), Vec2(0.5f));
  tooFew.furUv.pop_back();
  const Surface charts = built(makeTorus());
  for (const Mesh& mesh : {broken, point, tooFew}) {
    const Surface surface = built(mesh);
    ASSERT_EQ(surface.indices, charts.indices);
    for (std::size_t i = 0; i < surface.vertices.size(); ++i) ASSERT_EQ(surface.vertices[i].fur, charts.vertices[i].fur);
  }
}

}  // namespace
}  // namespace fur::geometry
