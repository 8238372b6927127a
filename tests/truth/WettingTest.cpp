#include "truth/Wetting.h"

#include <cmath>
#include <limits>

#include "core/Random.h"
#include "geometry/Primitives.h"
#include "truth/OneStrand.h"
#include "wet/Clump.h"

namespace fur::truth {
namespace {

constexpr int kWetMask = 32;

// A square of skin that fills the atlas, with a tile over it.
geometry::Surface atlasSquare() {
  geometry::Surface surface = test::square(0.5f);
  for (auto& v : surface.vertices) {
    v.atlas = Vec2(v.position.x, v.position.z) + 0.5f;
    v.gradS = {1, 0, 0};
    v.gradT = {0, 0, 1};
  }
  return surface;
}

wet::MaskTexels maskOf(const Vec4& clump) {
  wet::MaskTexels mask{kWetMask, {0, 0, kWetMask, kWetMask}, std::vector<Vec4>(kWetMask * kWetMask, clump)};
  for (Vec4& texel : mask.texels) texel.x += 0.5f * static_cast<float>(FUR_CHART_STEP);
  return mask;
}

furgen::Coat lawn(float curl = 0) {
  furgen::FurParameters parameters;
  parameters.size = 128;
  parameters.density = 0.2f;
  parameters.curl = curl;
  return furgen::growCoat(parameters);
}

float lengthOf(const Tubes& tubes, const Tube& tube) {
  float sum = 0;
  for (std::uint32_t k = 1; k < tube.nodeCount; ++k)
    sum += glm::distance(tubes.nodes[tube.firstNode + k].position, tubes.nodes[tube.firstNode + k - 1].position);
  return sum;
}

// Model units; clumps of this radius do not close on fur so long.
constexpr float kWetLength = 0.2f;

TEST(Wetting, ADryMaskDrawsTheDryReferenceToTheByte) {
  geometry::Surface surface = atlasSquare();
  const furgen::Coat coat = lawn();
  const std::vector<Vec4> bends(4, Vec4(0.5f, 0, 0, 1));
  const auto frame = test::frameFrom({0.25f, 1, 2}, {0, 0, 0}, {0, 1, 0}, 80, 60);
  const auto fur = test::furOf(kWetLength, 1);
  Options options;
  options.samples = 4, options.shadowTexels = 256;
  const wet::MaskTexels dry = maskOf(Vec4(0));
  Scene scene{surface, coat, bends, frame, fur};
  const Picture without = render(scene, 80, 60, options);
  scene.mask = &dry;
  EXPECT_TRUE(without.pixels == render(scene, 80, 60, options).pixels);
  // The comparison can tell.
  const wet::MaskTexels wet = maskOf({0.5f, 0.5f, 0.3f, 0.6f});
  scene.mask = &wet;
  EXPECT_FALSE(without.pixels == render(scene, 80, 60, options).pixels);
}

TEST(Wetting, StrandsOfAClumpComeToItsCentreByEquationOne) {
  const geometry::Surface surface = atlasSquare();
  const auto bends = test::straight(surface);
  furgen::Coat coat = lawn();
  for (furgen::Node& node : coat.nodes) node.shift = Vec2(0);
  constexpr float kTiles = 4;
  const auto fur = test::furOf(kWetLength, kTiles);
  const FurMap map(surface, bends, kWetLength, kTiles);
  const float rho = 0.6f, radius = 0.12f;
  const Vec2 centre(0.04f, -0.03f);
  const wet::MaskTexels mask = maskOf({centre.x + 0.5f, centre.y + 0.5f, radius, rho});
  const Wetting wetting(map, mask, fur);
  const Tubes tubes = placeStrands(map, coat, 0, &wetting);
  const float upright = wet::standsTo(rho, 0), drawn = wet::clumpingWetness(rho, radius / kWetLength, wet::chanceOfClump(centre + 0.5f));
  int seen = 0;
  for (const Tube& tube : tubes.tubes) {
    const Vec3 root = tubes.nodes[tube.firstNode].position;
    const Vec2 q(root.x, root.z);
    if (glm::distance(q, centre) > radius) continue;
    ++seen;
    for (std::uint32_t k = 1; k < tube.nodeCount; ++k) {
      const Vec3 p = tubes.nodes[tube.firstNode + k].position;
      const float h = p.y / kWetLength / upright;
      if (h < 1 / fur.layers) continue;
      const float s = wet::clumpPull(h, fur.clumpShape, fur.layers, drawn);
      // Pieces of the curve are straight.
      ASSERT_LT(glm::distance(Vec2(p.x, p.z), wet::clumpForward(q, centre, s)), 0.01f * radius) << h;
    }
  }
  EXPECT_GT(seen, 20);
}

TEST(Wetting, TipsOfHalfWetShortFurComeTogetherInTufts) {
  const geometry::Surface surface = atlasSquare();
  const auto bends = test::straight(surface);
  furgen::Coat coat = lawn();
  for (furgen::Node& node : coat.nodes) node.shift = Vec2(0);
  constexpr float kTiles = 4, kRadius = 0.06f, kShort = kRadius / 0.6f;
  auto fur = test::furOf(kShort, kTiles);
  fur.clumpRadius = kRadius;
  const FurMap map(surface, bends, kShort, kTiles);
  // How far it is to the next strand from its tip, as a share of how far it is from its root, in the mean.
  const auto apart = [&](float rho, float radius) {
    const wet::MaskTexels mask = maskOf({0.5f, 0.5f, radius, rho});
    const Wetting wetting(map, mask, fur);
    const Tubes tubes = placeStrands(map, coat, 0, &wetting);
    const auto meanOfNearest = [&](bool tips) {
      std::vector<Vec2> points;
      for (const Tube& tube : tubes.tubes) {
        const Vec3 node = tubes.nodes[tube.firstNode + (tips ? tube.nodeCount - 1 : 0)].position;
        points.emplace_back(node.x, node.z);
      }
      float sum = 0;
      for (std::size_t i = 0; i < points.size(); ++i) {
        float nearest = 1;
        for (std::size_t k = 0; k < points.size(); ++k)
          if (k != i) nearest = std::min(nearest, glm::distance(points[i], points[k]));
        sum += nearest;
      }
      return sum / static_cast<float>(points.size());
    };
    return meanOfNearest(true) / meanOfNearest(false);
  };
  for (const float radius : {0.0f, 0.06f}) {  // of no clump, of one
    EXPECT_LT(apart(0.5f, radius), 0.75f) << radius;
    EXPECT_NEAR(apart(1, radius), 1, 0.01f) << radius << ": soaked fur lies in a sheet";
  }
}

TEST(Wetting, AStrandKeepsItsLengthHoweverWetAndHoweverItLiesButForTheRimsOfSoakedClumps) {
  const geometry::Surface surface = atlasSquare();
  const furgen::Coat coat = lawn(0.4f);
  const render::shared::FurBlock fur = test::furOf(kWetLength, 1);
  for (const float bend : {0.0f, 0.9f}) {
    const std::vector<Vec4> bends(4, Vec4(bend, 0, 0, 1));
    const FurMap map(surface, bends, kWetLength, 1);
    const Tubes dry = placeStrands(map, coat, 0);
    for (const float rho : {0.3f, 0.7f, 0.95f, 1.4f}) {
      const wet::MaskTexels mask = maskOf({0.52f, 0.47f, 0.1f, rho});
      const Wetting wetting(map, mask, fur);
      const Tubes wet = placeStrands(map, coat, 0, &wetting);
      ASSERT_EQ(dry.tubes.size(), wet.tubes.size());
      for (std::size_t t = 0; t < dry.tubes.size(); ++t) {
        const float before = lengthOf(dry, dry.tubes[t]), after = lengthOf(wet, wet.tubes[t]);
        const Wetness& water = wet.tubes[t].water;
        // Chords of a curve that bends where it leaves the skin.
        ASSERT_LT(after, 1.02f * before) << rho;
        ASSERT_GT(after, 0.98f * before / wet::rimTaper(water.soaked, water.sheet, 1)) << rho;
      }
    }
  }
}

TEST(Wetting, FurThatLeansLiesDownTheWayItLeansAndWhatStandsDoesNot) {
  const geometry::Surface surface = atlasSquare();
  furgen::Coat coat = lawn();
  for (furgen::Node& node : coat.nodes) node.shift = Vec2(0);
  // No clump: beside the charts, where the mask tells the water alone.
  const wet::MaskTexels mask = maskOf({0, 0, FUR_LYING_STEP * std::round(0.7f * FUR_LYING_STEPS), -1.7f});
  const render::shared::FurBlock fur = test::furOf(kWetLength, 1);
  for (const float bend : {0.0f, 0.6f}) {
    const std::vector<Vec4> bends(4, Vec4(0, 0, bend, 1));
    const FurMap map(surface, bends, kWetLength, 1);
    const Wetting wetting(map, mask, fur);
    const Tubes dry = placeStrands(map, coat, 0), wet = placeStrands(map, coat, 0, &wetting);
    for (std::size_t t = 0; t < dry.tubes.size(); ++t) {
      const auto way = [&](const Tubes& of) {
        const Tube& tube = of.tubes[t];
        return of.nodes[tube.firstNode + tube.nodeCount - 1].position - of.nodes[tube.firstNode].position;
      };
      const Vec3 a = way(dry), b = way(wet);
      ASSERT_NEAR(b.x, 0, 1e-4f);
      if (bend == 0) ASSERT_LT(glm::distance(a, b), 0.01f * glm::length(a));
      else ASSERT_TRUE(b.z > 1.3f * a.z && b.y < 0.9f * a.y);
    }
  }
}

TEST(Wetting, SkinAndStrandsAreDarkerByEquationFive) {
  geometry::Surface surface = atlasSquare();
  const furgen::Coat coat = test::coatOf({0, 0}, {});
  const auto bends = test::straight(surface);
  const auto frame = test::frameFrom({0, 2, 0.01f}, {0, 0, 0}, {0, 0, -1}, 16, 16);
  const auto fur = test::furOf(kWetLength, 1);
  Options options;
  options.samples = 2, options.shadowTexels = 64;
  const wet::MaskTexels mask = maskOf({0.5f, 0.5f, 0.2f, 1});
  Scene scene{surface, coat, bends, frame, fur};
  const float dry = render(scene, 16, 16, options).pixels[8 * 16 + 8].g;
  scene.mask = &mask;
  EXPECT_LT(render(scene, 16, 16, options).pixels[8 * 16 + 8].g, 0.95f * dry);
}

TEST(Wetting, NothingIsNanOnHostileMasks) {
  geometry::Mesh mesh = geometry::makeTorus(24, 12);
  const geometry::Surface surface = geometry::buildSurface(mesh).value();
  const std::vector<Vec4> bends(surface.vertices.size(), Vec4(0.1f, 0.2f, 0, 1));
  const furgen::Coat coat = lawn(0.3f);
  const FurMap map(surface, bends, 0.12f, 2);
  auto fur = test::furOf(0.12f, 2);
  fur.clumpRadius = 0.05f;
  const float hostile[] = {0, -0.0f, 1, -1, 0.5f, 1e-30f, 1e30f, -1e30f, 3e38f, std::numeric_limits<float>::quiet_NaN(), std::numeric_limits<float>::infinity(),
                           -std::numeric_limits<float>::infinity(), 1e-3f, 254};
  Random random(5);
  wet::MaskTexels mask = maskOf(Vec4(0));
  const auto any = [&] { return hostile[random.next() % std::size(hostile)]; };
  for (Vec4& texel : mask.texels) texel = random.next() % 2 ? Vec4(any(), any(), any(), any()) : Vec4(2.5f, any(), any(), 0.7f);
  const Wetting wetting(map, mask, fur);
  const Tubes tubes = placeStrands(map, coat, 1e-4f, &wetting);
  EXPECT_GT(tubes.tubes.size(), 100u);
  for (const TubeNode& node : tubes.nodes) {
    const Vec3& p = node.position;
    ASSERT_TRUE(std::isfinite(p.x + p.y + p.z + node.radius + node.height)) << "a place";
  }
  const auto frame = test::frameFrom({0.25f, 1, 3}, {0, 0, 0}, {0, 1, 0}, 60, 40);
  Options options;
  options.samples = 2, options.shadowTexels = 128;
  Scene scene{surface, coat, bends, frame, fur};
  scene.mask = &mask;
  for (const Vec3& pixel : render(scene, 60, 40, options).pixels) ASSERT_TRUE(std::isfinite(pixel.x + pixel.y + pixel.z)) << "a pixel";
}

}  // namespace
}  // namespace fur::truth
