#include "truth/Truth.h"

#include "core/Srgb.h"
#include "truth/DeepShadow.h"
#include "truth/OneStrand.h"
#include "truth/Shading.h"
#include "truth/Spans.h"

namespace fur::truth {
namespace {

constexpr int kTruthWidth = 120, kTruthHeight = 90;
const Vec3 kBackground(0, 0, 1);

struct World {
  geometry::Surface surface = test::square(0.5f);
  furgen::Coat coat = test::coatOf({64, 64}, {test::upright()});
  std::vector<Vec4> bends = test::straight(surface);
  render::shared::FrameBlock frame = test::frameFrom({0.25f, 0.3f, 2}, {0.25f, 0.3f, 0.25f}, {0, 1, 0}, kTruthWidth, kTruthHeight);
  render::shared::FurBlock fur = test::furOf(0.4f, 1);

  Scene scene() const { return {surface, coat, bends, frame, fur}; }
  Picture draw(Options options = {}) const {
    options.shadowTexels = 256;
    return render(scene(), kTruthWidth, kTruthHeight, options);
  }
};

bool isBackground(const Picture& p, int x, int y) {
  // Decoded and encoded again on the way.
  return glm::distance(p.pixels[static_cast<std::size_t>(y * p.width + x)], kBackground) < 1e-4f;
}

// How many pixels of a row something stands before, halves counted as such.
float widthOfRow(const Picture& p, int y) {
  float sum = 0;
  for (int x = 0; x < p.width; ++x) {
    const float blue = p.pixels[static_cast<std::size_t>(y * p.width + x)].b;
    sum += isBackground(p, x, y) ? 0 : saturate((1 - blue) / 0.6f);
  }
  return sum;
}

TEST(Truth, AStrandStandsWhereTheProjectionSays) {
  const World world;
  const Picture picture = world.draw();
  for (const float height : {0.1f, 0.25f, 0.39f}) {
    const Vec2 at = test::pixelOf(world.frame, {0.25f, height, 0.25f}, kTruthWidth, kTruthHeight);
    const int x = static_cast<int>(at.x), y = static_cast<int>(at.y);
    EXPECT_FALSE(isBackground(picture, x, y)) << height;
    EXPECT_TRUE(isBackground(picture, x - 6, y)) << height;
    EXPECT_TRUE(isBackground(picture, x + 6, y)) << height;
  }
  const Vec2 above = test::pixelOf(world.frame, {0.25f, 0.43f, 0.25f}, kTruthWidth, kTruthHeight);
  EXPECT_TRUE(isBackground(picture, static_cast<int>(above.x), static_cast<int>(above.y)));
}

TEST(Truth, AStrandThinsTowardsItsTip) {
  const World world;
  const Picture picture = world.draw();
  const auto rowAt = [&](float height) { return static_cast<int>(test::pixelOf(world.frame, {0.25f, height, 0.25f}, kTruthWidth, kTruthHeight).y); };
  const float low = widthOfRow(picture, rowAt(0.1f)), middle = widthOfRow(picture, rowAt(0.2f)), high = widthOfRow(picture, rowAt(0.3f));
  EXPECT_GT(low, middle * 1.1f);
  EXPECT_GT(middle, high * 1.1f);
  // 5 texels of radius at half the height, 1.75 from the eye: within a fifth, for the colour at the edges.
  EXPECT_NEAR(middle, 2 * 5 / 256.0f * world.frame.pixelsPerUnit / 1.75f, 0.2f * middle);
}

TEST(Truth, SkinHidesTheStrandsBehindIt) {
  World world;
  world.frame = test::frameFrom({0.1f, 3, 0.1f}, {0, 0, 0}, {0, 0, -1}, kTruthWidth, kTruthHeight);
  // A bare square above them.
  const geometry::Surface lid = test::square(0.5f, 0.6f);
  for (auto& v : lid.vertices) world.surface.vertices.push_back(v);
  world.surface.indices = {4, 5, 6, 4, 6, 7};
  world.bends = test::straight(world.surface);
  const Picture here = world.draw();
  world.coat.strands[0].root = {160, 128};
  EXPECT_TRUE(here.pixels == world.draw().pixels);
  world.surface.indices.clear();
  EXPECT_FALSE(here.pixels == world.draw().pixels);
}

TEST(Truth, SkinThatFacesAwayIsNotDrawn) {
  World world;
  world.coat.strands.clear();
  world.frame = test::frameFrom({0, -3, 0}, {0, 0, 0}, {0, 0, -1}, kTruthWidth, kTruthHeight);
  for (const Vec3& pixel : world.draw().pixels) EXPECT_LT(glm::distance(pixel, kBackground), 1e-4f);
}

TEST(Truth, MoreSamplesChangeNoMeanButSmoothTheEdges) {
  const World world;
  const auto mean = [](const Picture& p) {
    Vec3 sum(0);
    for (const Vec3& pixel : p.pixels) sum += decodeSrgb(pixel);
    return sum / static_cast<float>(p.pixels.size());
  };
  Options few, many;
  few.samples = 4, many.samples = 12;
  const Picture a = world.draw(few), b = world.draw(many);
  // Of 16 samples a pixel of the outline misses its share by an eighth at most, one way or the other.
  EXPECT_LT(glm::distance(mean(a), mean(b)), 2e-3f);
}

TEST(Truth, OnlyTracedLightLeavesTheShadowOfTheBodyBlack) {
  World world;
  // Lit through the skin, from below.
  world.frame.light = Vec4(glm::normalize(Vec3(0.1f, -0.9f, 0.1f)), 0);
  world.frame.sky = world.frame.floorLight = Vec4(0);
  const Vec2 at = test::pixelOf(world.frame, {0.25f, 0.2f, 0.25f}, kTruthWidth, kTruthHeight);
  const auto pixel = static_cast<std::size_t>(static_cast<int>(at.y) * kTruthWidth + static_cast<int>(at.x));
  Options traced;
  traced.light = Light::Traced;
  EXPECT_LT(glm::length(world.draw(traced).pixels[pixel]), 1e-3f);
  // Sheppard's body shades from 30 degrees behind on, but a point of light that is nearer than that comes through.
  world.frame.light = Vec4(glm::normalize(Vec3(0.95f, -0.3f, 0)), 0);
  EXPECT_GT(glm::length(world.draw().pixels[pixel]), 0.1f);
}

// Strands that lie across the light one above the other, at y = 0.1, 0.2 and so on.
Tubes rungs(int count) {
  Tubes tubes;
  for (int i = 0; i < count; ++i) {
    const float y = 0.1f * static_cast<float>(i + 1);
    tubes.tubes.push_back({static_cast<std::uint32_t>(tubes.nodes.size()), 3, 0.5f});
    for (const float x : {-0.4f, 0.0f, 0.4f}) tubes.nodes.push_back({{x, y, 0}, 0.02f, {0, 1, 0}, 0.5f});
  }
  return tubes;
}

TEST(DeepShadow, EveryStrandOnTheWayLetsItsShareThroughAndNoneCountsItself) {
  const Tubes tubes = rungs(4);
  const DeepShadow shadow(test::square(0.5f), tubes, {0, 1, 0}, 512);
  const auto share = [&](float y, float reach) { return shadow.shareThrough({0.1f, y, 0}, 0.02f, {1, 0, 0}, 0.5f, reach); };
  for (int i = 0; i < 4; ++i) EXPECT_FLOAT_EQ(share(0.1f * static_cast<float>(i + 1), 9), std::pow(0.5f, static_cast<float>(3 - i)));
  EXPECT_FLOAT_EQ(share(0.0f, 9), 0.0625f);
  EXPECT_FLOAT_EQ(share(0.1f, 0.15f), 0.5f);  // the nearest alone
  EXPECT_FLOAT_EQ(shadow.shareThrough({0.1f, 0, 0.2f}, 0.02f, {1, 0, 0}, 0.5f, 9), 1.0f);
}

TEST(DeepShadow, AStrandOfManyPiecesIsCrossedOnce) {
  Tubes tubes;
  tubes.tubes.push_back({0, 41, 0.5f});
  for (int k = 0; k <= 40; ++k) tubes.nodes.push_back({{-0.4f + 0.02f * static_cast<float>(k), 0.3f, 0}, 0.02f, {0, 1, 0}, 0.5f});
  const DeepShadow shadow(test::square(0.5f), tubes, {0, 1, 0}, 512);
  for (int k = 0; k < 20; ++k)
    EXPECT_FLOAT_EQ(shadow.shareThrough({-0.3f + 0.03f * static_cast<float>(k), 0, 0}, 0.02f, {1, 0, 0}, 0.5f, 9), 0.5f);
}

TEST(DeepShadow, SkinShadesWhatLiesBehindItAlone) {
  const DeepShadow shadow(test::square(0.3f), {}, {0, 1, 0}, 256);
  EXPECT_EQ(shadow.sharePastSkin({0.1f, -0.2f, 0}, 0.01f), 0);
  EXPECT_EQ(shadow.sharePastSkin({0.1f, 0, 0}, 0.01f), 1);
  EXPECT_EQ(shadow.sharePastSkin({0.1f, 0.2f, 0}, 0.01f), 1);
}

TEST(Spans, ASweptDiscFindsTheSamplesWithinItsRadiusAndNoOthers) {
  const Disc a{{10.3f, 12.1f}, 4, 0}, b{{27.8f, 20.6f}, 2, 0};
  std::vector<int> found(40 * 40, 0);
  sweep(a, b, {0, 0, 40, 40}, [&](int x, int y, float) { ++found[static_cast<std::size_t>(y * 40 + x)]; });
  for (int y = 0; y < 40; ++y)
    for (int x = 0; x < 40; ++x) {
      const Vec2 p = Vec2(x, y) + 0.5f, way = b.centre - a.centre;
      const float t = saturate(glm::dot(p - a.centre, way) / glm::dot(way, way));
      const float margin = glm::distance(p, a.centre + way * t) - glm::mix(a.radius, b.radius, t);
      if (std::abs(margin) > 1e-4f) EXPECT_EQ(found[static_cast<std::size_t>(y * 40 + x)], margin < 0) << x << ", " << y;
    }
}

TEST(DensestSection, IsTheShareOfTheTileThatRootsCoverWhereStrandsThinUpwards) {
  // At the middle of the lowest of 32 sections the radius is 8 - 6 / 64.
  const furgen::Coat coat = test::coatOf({64, 64}, {test::upright(), test::upright()});
  const float radius = 8 - 6.0f / 64;
  EXPECT_NEAR(densestSection(coat), 2 * kPi * radius * radius / (256.0f * 256.0f), 1e-6f);
}

}  // namespace
}  // namespace fur::truth
