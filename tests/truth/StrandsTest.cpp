#include "truth/Strands.h"

#include <map>

#include "geometry/Primitives.h"
#include "truth/OneStrand.h"

namespace fur::truth {
namespace {

// Lengths here are about 1 and fur coordinates are kept in single precision.
constexpr float kRounding = 1e-5f;

TEST(Strands, OneStandsAtItsRootAndIsAsHighAndAsThickAsTheCoatSays) {
  const geometry::Surface surface = test::square(0.5f);
  const auto bends = test::straight(surface);
  // One tile a unit, and the root at a quarter and at three eighths of it.
  const Tubes tubes = placeStrands(FurMap(surface, bends, 0.2f, 1), test::coatOf({64, 96}, {test::upright()}), 0);
  ASSERT_EQ(tubes.tubes.size(), 1u);
  ASSERT_EQ(tubes.nodes.size(), 3u);
  for (int k = 0; k < 3; ++k) {
    const TubeNode& node = tubes.nodes[static_cast<std::size_t>(k)];
    EXPECT_LT(glm::distance(node.position, Vec3(0.25f, 0.1f * static_cast<float>(k), 0.375f)), kRounding);
    EXPECT_NEAR(node.radius, (8 - 3 * static_cast<float>(k)) / 256, kRounding);
    EXPECT_EQ(node.normal, Vec3(0, 1, 0));
  }
}

TEST(Strands, ANodesShiftMovesItByAsManyTexelsAlongTheSurface) {
  const geometry::Surface surface = test::square(0.5f);
  const auto bends = test::straight(surface);
  const Tubes tubes = placeStrands(FurMap(surface, bends, 0.2f, 1),
                                   test::coatOf({64, 64}, {{{Vec2(0), 0, 4}, {Vec2(-96, 32), 1, 2}}}), 0);
  ASSERT_EQ(tubes.nodes.size(), 2u);
  EXPECT_LT(glm::distance(tubes.nodes[1].position, Vec3(0.25f - 0.375f, 0.2f, 0.25f + 0.125f)), kRounding);
}

TEST(Strands, ABendTurnsTheTipAndKeepsTheLength) {
  const geometry::Surface surface = test::square(0.5f);
  const std::vector<Vec4> bends(4, Vec4(1, 0, 0, 0));
  std::vector<furgen::Node> fine;
  for (int k = 0; k <= 32; ++k) fine.push_back({Vec2(0), static_cast<float>(k) / 32, 2});
  const Tubes tubes = placeStrands(FurMap(surface, bends, 0.2f, 1), test::coatOf({64, 64}, {fine}), 0);
  ASSERT_EQ(tubes.nodes.size(), 33u);
  float length = 0;
  for (std::size_t k = 1; k < 33; ++k) length += glm::distance(tubes.nodes[k].position, tubes.nodes[k - 1].position);
  EXPECT_NEAR(length, 0.2f, 0.2f * 1e-3f);  // 32 chords of an arc of one radian
  EXPECT_GT(tubes.nodes.back().position.x, 0.25f + 0.08f);
}

TEST(Strands, StandOnceOnEveryTileAlsoWhereTrianglesMeet) {
  // The root lies on the corners of tiles, four of which are on the inside and two of these on the diagonal.
  geometry::Surface surface = test::square(1.5f);
  const auto bends = test::straight(surface);
  const FurMap map(surface, bends, 0.1f, 1);
  const furgen::Coat coat = test::coatOf({128, 128}, {test::upright()});
  std::map<std::pair<double, double>, int> found;
  std::vector<Root> roots;
  for (std::uint32_t t = 0; t < map.triangleCount(); ++t) RootFinder(map, coat).find(t, roots);
  for (const Root& root : roots) ++found[{root.tile.x, root.tile.y}];
  EXPECT_EQ(found.size(), 9u);
  for (const auto& [tile, times] : found) EXPECT_EQ(times, 1) << tile.first << ", " << tile.second;
}

TEST(Strands, StandWhereAChartShowsTheirNumber) {
  geometry::Surface surface = test::square(0.5f);
  const auto bends = test::straight(surface);
  furgen::Coat coat = test::coatOf({64, 64}, {test::upright(), test::upright()});
  coat.strands[0].variance = 0.4f;  // number 0.2
  coat.strands[1].variance = 0.9f;  // number 0.8
  for (auto& v : surface.vertices) v.strands = {-1, 0.5f};
  const Tubes low = placeStrands(FurMap(surface, bends, 0.1f, 1), coat, 0);
  ASSERT_EQ(low.tubes.size(), 1u);
  EXPECT_EQ(low.tubes[0].variance, 0.4f);
  for (auto& v : surface.vertices) v.strands = {0.5f, 2};
  const Tubes high = placeStrands(FurMap(surface, bends, 0.1f, 1), coat, 0);
  ASSERT_EQ(high.tubes.size(), 1u);
  EXPECT_EQ(high.tubes[0].variance, 0.9f);
}

// What stands on the triangles that lie at one place, charts that overlap there taken together.
struct Place {
  double roots = 0, expected = 0, share = 0;
  int charts = 0;
};
// The share of its strands that a chart shows on a triangle: those whose number lies between the corners' bounds.
double shareShown(const geometry::Surface& surface, std::uint32_t t) {
  constexpr int kSteps = 8;
  double sum = 0, count = 0;
  for (int i = 0; i < kSteps; ++i)
    for (int k = 0; i + k < kSteps; ++k, ++count) {
      const Vec3 weights = (Vec3(i, k, kSteps - 1 - i - k) + 1.0f / 3) / static_cast<float>(kSteps);
      Vec2 bounds(0);
      for (int c = 0; c < 3; ++c) bounds += weights[c] * surface.vertices[surface.furIndices[3 * t + static_cast<std::uint32_t>(c)]].strands;
      bounds = glm::clamp(bounds, 0.0f, 1.0f);
      sum += bounds.y - bounds.x;
    }
  return sum / count;
}

TEST(Strands, StandAsCloseAsInTheTileAlsoWhereChartsOverlap) {
  geometry::Mesh mesh = geometry::makeSphere();
  mesh.uv.clear();
  const geometry::Surface surface = geometry::buildSurface(mesh).value();
  const auto bends = test::straight(surface);
  const FurMap map(surface, bends, 0.1f, 4);
  const furgen::Coat coat = furgen::growCoat({});
  const RootFinder finder(map, coat);
  std::map<std::array<float, 3>, Place> places;
  for (std::uint32_t t = 0; t < map.triangleCount(); ++t) {
    std::vector<Root> roots;
    finder.find(t, roots);
    const auto c = map.corners(t);
    const glm::dvec2 a = c[1] - c[0], b = c[2] - c[0];
    Vec3 middle(0);
    for (std::uint32_t k = 0; k < 3; ++k) middle += surface.vertices[surface.furIndices[3 * t + k]].position;
    middle = glm::round(middle * 1e4f);
    Place& place = places[{middle.x, middle.y, middle.z}];
    const double share = shareShown(surface, t);
    place.roots += static_cast<double>(roots.size());
    place.expected += share * 0.5 * std::abs(a.x * b.y - a.y * b.x) * static_cast<double>(coat.strands.size());
    place.share += share;
    ++place.charts;
  }
  Place single, several;
  for (const auto& [where, place] : places) {
    Place& sum = place.charts > 1 ? several : single;
    sum.roots += place.roots;
    sum.expected += place.expected;
    sum.share += place.share, ++sum.charts;
  }
  // A hundred thousand strands, spread more evenly than by chance, and a border of some thousand.
  EXPECT_NEAR(single.roots / single.expected, 1, 0.005);
  // Of those that overlap each shows its share, chosen by chance: four standard deviations.
  ASSERT_GT(several.expected, 5000);
  EXPECT_NEAR(several.roots / several.expected, 1, 4 / std::sqrt(several.expected));
  // Each drawn twice would be 2, a cut border 0.5.
  EXPECT_NEAR(several.share / several.charts, 1, 0.01);
}

TEST(Strands, NoneIsTornApartWhereItCrossesTrianglesOrLeavesItsChart) {
  geometry::Mesh mesh = geometry::makeTorus(36, 16);
  mesh.uv.clear();
  const geometry::Surface surface = geometry::buildSurface(mesh).value();
  const auto bends = test::straight(surface);
  furgen::FurParameters coiled;
  coiled.thickness = 0.6f, coiled.coil = 0.55f, coiled.clump = 1;
  const Tubes tubes = placeStrands(FurMap(surface, bends, 0.12f, 2), furgen::growCoat(coiled), 0);
  ASSERT_GT(tubes.tubes.size(), 1000u);
  // As high as the coat, a little aside, and aside by half as much again where the body bulges.
  for (const Tube& tube : tubes.tubes)
    for (std::uint32_t k = 1; k < tube.nodeCount; ++k)
      ASSERT_LT(glm::distance(tubes.nodes[tube.firstNode + k].position, tubes.nodes[tube.firstNode].position), 1.5f * 0.12f);
}

TEST(Strands, LeavingNodesOutMovesNoneFartherThanAsked) {
  const geometry::Surface surface = test::square(0.5f);
  const auto bends = test::straight(surface);
  furgen::FurParameters parameters;
  parameters.coil = 0.5f;
  const furgen::Coat coat = furgen::growCoat(parameters);
  const FurMap map(surface, bends, 0.2f, 1);
  constexpr float kTolerance = 1e-3f;
  const Tubes all = placeStrands(map, coat, 0), some = placeStrands(map, coat, kTolerance);
  ASSERT_EQ(all.tubes.size(), some.tubes.size());
  EXPECT_LT(some.nodes.size(), all.nodes.size() * 3 / 4);
  for (std::size_t t = 0; t < all.tubes.size(); t += 10)
    for (std::uint32_t k = 0; k < all.tubes[t].nodeCount; ++k) {
      const Vec3 p = all.nodes[all.tubes[t].firstNode + k].position;
      float nearest = 1;
      for (std::uint32_t i = 1; i < some.tubes[t].nodeCount; ++i) {
        const Vec3 a = some.nodes[some.tubes[t].firstNode + i - 1].position, way = some.nodes[some.tubes[t].firstNode + i].position - a;
        nearest = std::min(nearest, glm::distance(p, a + way * saturate(glm::dot(p - a, way) / glm::dot(way, way))));
      }
      ASSERT_LT(nearest, kTolerance + kRounding);
    }
}

TEST(FurMap, BendsAsSheppardHasItWhereThatIsAskedFor) {
  const geometry::Surface surface = test::square(0.5f);
  const std::vector<Vec4> bends(4, Vec4(0.5f * dynamics::kMaxBend, 0, 0, 1));
  const auto raised = [&](dynamics::BendCurve curve) {
    const FurMap map(surface, bends, 0.1f, 1, curve);
    return (map.point({}, 1) - map.point({}, 0)) / 0.1f;
  };
  const Vec2 arc = dynamics::arcBend(0.5f * dynamics::kMaxBend, 1), polynomial = dynamics::windBend(0.5f, 1);
  EXPECT_LT(glm::distance(raised(dynamics::BendCurve::Arc), Vec3(arc.y, arc.x, 0)), kRounding);
  EXPECT_LT(glm::distance(raised(dynamics::BendCurve::Polynomial), Vec3(polynomial.y, polynomial.x, 0)), kRounding);
}

TEST(FurMap, FindsASpotAcrossTrianglesAndGoesOnStraightBeyondTheChart) {
  geometry::Mesh plane = geometry::makePlane(8);
  plane.uv.clear();
  geometry::Surface surface = geometry::buildSurface(plane).value();
  // Upright up to the rim.
  for (auto& v : surface.vertices) v.normal = Vec3(0, 1, 0), v.curvature = Vec3(0);
  const auto bends = test::straight(surface);
  const FurMap map(surface, bends, 0.1f, 2);
  const auto first = map.corners(0);
  // Tile coordinates run evenly over a plane: steps of the same size lead equally far, whatever lies between.
  const glm::dvec2 step(0.11, 0.07);
  const Vec3 start = map.point(map.find(0, first[0]), 0), once = map.point(map.find(0, first[0] + step), 0);
  for (int k = -20; k <= 20; ++k) {
    const Vec3 there = map.point(map.find(0, first[0] + step * static_cast<double>(k)), 0.5f);
    EXPECT_LT(glm::distance(there, start + (once - start) * static_cast<float>(k) + Vec3(0, 0.05f, 0)), 1e-3f) << k;
  }
}

TEST(FurMap, ScaleIsTheLengthOfATileAndGrowsWithTheHeightOverABulge) {
  const geometry::Surface flat = test::square(0.5f);
  const auto bends = test::straight(flat);
  EXPECT_NEAR(FurMap(flat, bends, 0.3f, 4).scale({}, 0), 0.25f, kRounding);
  EXPECT_NEAR(FurMap(flat, bends, 0.3f, 4).scale({}, 1), 0.25f, kRounding);
  geometry::Surface sphere = flat;
  for (auto& v : sphere.vertices) v.normal = glm::normalize(v.position + Vec3(0, 1, 0));
  EXPECT_GT(FurMap(sphere, bends, 0.3f, 4).scale({}, 1), 0.26f);
}

}  // namespace
}  // namespace fur::truth
