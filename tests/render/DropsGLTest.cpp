// Drops in the air and wet ground, beside a bare sphere.
#include <algorithm>
#include <cmath>
#include <limits>

#include "core/Random.h"
#include "geometry/Primitives.h"
#include "geometry/Surface.h"
#include "render/Renderer.h"
#include "tests/render/Picture.h"
#include "wet/MaskEncoding.h"

namespace fur::render {
namespace {

using test::Picture;
using test::Stage;

constexpr int kDropSide = 240, kCells = wet::kGroundCells;

struct DropScene {
  Stage stage{kDropSide, kDropSide, 4};
  std::optional<Renderer> renderer;
  Frame frame;
  std::vector<std::uint8_t> puddles;

  DropScene() {
    stage.attachTarget();
    gl::rememberPlatformFramebuffer();
    renderer.emplace(std::move(Renderer::create().value()));
    renderer->setSurface(geometry::buildSurface(geometry::makeSphere()).value());
    const std::vector<std::uint16_t> charts(16 * 16, 0);
    renderer->updateMask(wet::encodeMask(wet::WetnessMask(16), {0, 0, 16, 16}, charts, nullptr));
    frame.camera = {Vec3(0, 0.6f, 6), Vec3(0), 0.6f};
    frame.width = frame.height = kDropSide;
    frame.settings.backgroundTop = 0x2040a0;
    frame.settings.backgroundBottom = 0xe0d0b0;
  }
  Picture draw(std::vector<wet::Drop> drops = {}) {
    stage.attachTarget();
    frame.drops = drops;
    const Status status = renderer->draw(frame);
    EXPECT_TRUE(status) << (status ? "" : status.error().message);
    return stage.read();
  }
  Vec2 pixelOf(const Vec3& at) const {
    const Vec4 c = clipFromWorld(frame) * Vec4(at, 1);
    return Vec2(0.5f + 0.5f * c.x / c.w, 0.5f - 0.5f * c.y / c.w) * static_cast<float>(kDropSide);
  }
};

bool differs(const Picture& a, const Picture& b, int x, int y, int by = 3) {
  for (int k = 0; k < 3; ++k)
    if (std::abs(a.at(x, y)[k] - b.at(x, y)[k]) > by) return true;
  return false;
}
// The pixels that differ: low and high corner, and how many.
struct Patch {
  Vec2 low{kDropSide}, high{0};
  int count = 0;
};
Patch changed(const Picture& a, const Picture& b) {
  Patch patch;
  for (int y = 0; y < kDropSide; ++y)
    for (int x = 0; x < kDropSide; ++x)
      if (differs(a, b, x, y)) {
        patch.low = glm::min(patch.low, Vec2(x, y));
        patch.high = glm::max(patch.high, Vec2(x, y));
        ++patch.count;
      }
  return patch;
}

constexpr Vec3 kBeside(1.35f, 0.9f, 0);

TEST(Drops, AreDiscsOfTheirSizeAndChangeNothingElse) {
  DropScene scene;
  const Picture none = scene.draw();
  const Patch patch = changed(none, scene.draw({{kBeside, 0.1f}}));
  const float pixels = 2 * 0.1f * pixelsPerUnit(scene.frame) / glm::length(scene.frame.camera.eye - kBeside);
  // A pixel on either side, half covered.
  EXPECT_NEAR(patch.high.x - patch.low.x, pixels, 2.5f);
  EXPECT_NEAR(patch.high.y - patch.low.y, pixels, 2.5f);
  EXPECT_LT(glm::length(0.5f * (patch.low + patch.high) - scene.pixelOf(kBeside)), 2);
  EXPECT_EQ(changed(none, scene.draw()).count, 0) << "the list is not remembered";
}

TEST(Drops, ShowTheSurroundingsUpsideDownAndAGlint) {
  DropScene scene;
  scene.frame.settings.lightYaw = -0.6f;
  const Vec2 middle = scene.pixelOf(kBeside);
  const Picture none = scene.draw(), p = scene.draw({{kBeside, 0.15f, Vec3(0, -1, 0)}});
  const auto blue = [&](const Picture& of, float up) {
    const std::uint8_t* c = of.at(static_cast<int>(middle.x), static_cast<int>(middle.y - up));
    return c[2] - c[0];
  };
  EXPECT_GT(blue(none, 8), blue(none, -8)) << "the sky is blue above";
  EXPECT_LT(blue(p, 6), blue(p, -6)) << "and in a drop below";
  int brightest = 0;
  for (int y = -15; y <= 15; ++y)
    for (int x = -15; x <= 15; ++x)
      brightest = std::max<int>(brightest, p.at(static_cast<int>(middle.x) + x, static_cast<int>(middle.y) + y)[2]);
  EXPECT_GT(brightest, 240);
}

TEST(Drops, AreLongerTheWayTheyFly) {
  DropScene scene;
  const Picture none = scene.draw();
  const Patch still = changed(none, scene.draw({{kBeside, 0.08f}})), falls = changed(none, scene.draw({{kBeside, 0.08f, Vec3(0, -40, 0)}})),
              flies = changed(none, scene.draw({{kBeside, 0.08f, Vec3(40, 0, 0)}})), comes = changed(none, scene.draw({{kBeside, 0.08f, Vec3(0, 0.001f, 40)}}));
  EXPECT_GT(falls.high.y - falls.low.y, 1.6f * (still.high.y - still.low.y));
  EXPECT_LT(falls.high.x - falls.low.x, 0.95f * (still.high.x - still.low.x));
  EXPECT_GT(flies.high.x - flies.low.x, 1.6f * (still.high.x - still.low.x));
  EXPECT_GT(comes.count, 20) << "one that comes at the eye is still a drop";
}

TEST(Drops, AreHiddenBehindTheModelAndFaintBelowAPixel) {
  DropScene scene;
  const Picture none = scene.draw();
  EXPECT_EQ(changed(none, scene.draw({{Vec3(0, 0, -2), 0.1f}})).count, 0);
  EXPECT_GT(changed(none, scene.draw({{Vec3(0, 0, 1.2f), 0.1f}})).count, 20);
  // A thousand of a tenth of a pixel cover a hundredth of a pixel each.
  std::vector<wet::Drop> dust;
  for (int i = 0; i < 1000; ++i) dust.push_back({Vec3(-1.7f + 0.0034f * static_cast<float>(i), 1.5f, 0), 0.0005f});
  EXPECT_LT(changed(none, scene.draw(dust)).count, 60);
  // And those that no eye can place: at the eye, of no size, not finite.
  const float nan = std::numeric_limits<float>::quiet_NaN();
  scene.draw({{scene.frame.camera.eye, 0.1f}, {kBeside, 0}, {Vec3(nan), nan, Vec3(nan)}});
}

// Rain fades with distance as it should instead of vanishing or flickering: as many pixels' worth of change as it covers.
TEST(Drops, ChangeThePictureByTheirAreaHoweverFewPixelsThatIs) {
  DropScene scene;
  scene.frame.settings.backgroundTop = 0xffffff;
  scene.frame.settings.backgroundBottom = 0;
  scene.frame.settings.lightIntensity = 0;
  Random random(3);
  std::vector<wet::Drop> rain;
  for (int i = 0; i < 300; ++i)
    rain.push_back({Vec3(random.uniform(-0.5f, 0.5f), 4 + random.uniform(-0.3f, 0.3f), random.uniform(-0.2f, 0.2f)), 0.0115f, Vec3(0, -6, 0)});
  const auto changeAt = [&](float distance) {
    scene.frame.camera.eye = Vec3(0, 4 - 0.2f * distance, distance);
    scene.frame.camera.target = scene.frame.camera.eye - Vec3(0, 0, distance);
    const Picture none = scene.draw(), some = scene.draw(rain);
    double sum = 0;
    for (std::size_t i = 0; i < none.rgba.size(); i += 4) sum += none.rgba[i] - some.rgba[i];
    return sum * distance * distance;
  };
  const double near = changeAt(2.5f);
  EXPECT_GT(near, 1000);
  // Ends are rounder near by.
  EXPECT_NEAR(changeAt(5) / near, 1, 0.25);
  EXPECT_NEAR(changeAt(10) / near, 1, 0.25);
}

TEST(Drops, OfAJetAreOnePieceWithAnEvenOutlineUntilItFallsApart) {
  DropScene scene;
  scene.frame.settings.backgroundBottom = 0;
  scene.frame.settings.backgroundTop = 0xffffff;
  scene.frame.settings.lightIntensity = 0;
  const Picture bare = scene.draw();
  // The least and the most change across the jet, over its columns.
  const auto range = [&](float jet) {
    std::vector<wet::Drop> drops;
    for (int i = 0; i < 12; ++i) {
      wet::Drop drop{Vec3(0.9f - 0.16f * static_cast<float>(i), 1.4f, 0), 0.04f, Vec3(9.6f, 0, 0)};
      drop.jet = jet;
      drops.push_back(drop);
    }
    const Picture p = scene.draw(drops);
    std::pair<int, int> range(1 << 20, 0);
    for (int x = static_cast<int>(scene.pixelOf(drops[9].position).x); x < static_cast<int>(scene.pixelOf(drops[2].position).x); ++x) {
      int sum = 0;
      for (int y = 0; y < kDropSide / 2; ++y) sum += std::abs(bare.at(x, y)[0] - p.at(x, y)[0]);
      range = {std::min(range.first, sum), std::max(range.second, sum)};
    }
    return range;
  };
  const auto whole = range(2), apart = range(1);
  EXPECT_GT(whole.first, 20);
  EXPECT_LT(whole.second, 1.3f * static_cast<float>(whole.first));
  EXPECT_LT(apart.first, 0.3f * static_cast<float>(apart.second));
}

TEST(Drops, ThatHaveLandedLieOnTheGroundAsRingsThatWidenAndFade) {
  DropScene scene;
  scene.frame.camera = {Vec3(0, 3, 6), Vec3(0, -0.5f, 0), 0.6f};
  const Picture none = scene.draw();
  const auto ring = [&](float splash) {
    wet::Drop drop{Vec3(1.5f, scene.frame.groundHeight, 0.5f), 0.13f};
    drop.splash = splash;
    return changed(none, scene.draw({drop}));
  };
  const Patch early = ring(0.25f), late = ring(0.6f);
  EXPECT_GT(early.count, 4);
  EXPECT_GT(late.high.x - late.low.x, 1.2f * (early.high.x - early.low.x));
  EXPECT_LT(late.high.y - late.low.y, 0.7f * (late.high.x - late.low.x)) << "it lies";
  EXPECT_EQ(ring(1).count, 0);
}

TEST(WetGround, ShowsNoCells) {
  DropScene scene;
  // Close above, where a cell is twenty pixels wide.
  scene.frame.camera = {Vec3(2, 0, 0.5f), Vec3(2, -1, 0.499f), 0.6f};
  scene.frame.settings.backgroundBottom = scene.frame.settings.backgroundTop = 0xc0c0c0;
  scene.frame.settings.lightIntensity = 0;
  Random random(5);
  scene.puddles.assign(kCells * kCells, 0);
  for (std::uint8_t& cell : scene.puddles) cell = static_cast<std::uint8_t>(random.uniform(0, 90));
  scene.frame.puddles = {scene.puddles, 1};
  const Picture p = scene.draw();
  // Between dry and wet it goes up and down without a kink, across cells and along them. Means of six pixels, free of the dither.
  const auto mean = [&](int x, int y, int dx, int dy) {
    float sum = 0;
    for (int i = -1; i <= 1; ++i)
      for (int j = 0; j < 2; ++j) sum += p.at(x + i * dy + j * dx, y + i * dx + j * dy)[0];
    return sum / 6;
  };
  float least = 255, most = 0, bend = 0;
  for (int y = 20; y < kDropSide - 20; ++y)
    for (int x = 20; x < kDropSide - 20; ++x) {
      const float here = mean(x, y, 1, 0);
      least = std::min(least, here), most = std::max(most, here);
      bend = std::max(bend, std::abs(mean(x - 2, y, 1, 0) - 2 * here + mean(x + 2, y, 1, 0)));
      bend = std::max(bend, std::abs(mean(x, y - 2, 0, 1) - 2 * mean(x, y, 0, 1) + mean(x, y + 2, 0, 1)));
    }
  EXPECT_GT(most - least, 12);
  EXPECT_LT(bend, 3);
}

TEST(WetGround, MirrorsTheModelTowardsTheEye) {
  DropScene scene;
  scene.frame.camera = {Vec3(0, 1.5f, 8), Vec3(0, -0.7f, 0), 0.6f};
  scene.frame.settings.backgroundBottom = scene.frame.settings.backgroundTop = 0xc0c0c0;
  scene.frame.settings.lightYaw = 3.14f;
  scene.frame.settings.lightIntensity = 0;
  scene.puddles.assign(kCells * kCells, 255);
  scene.frame.puddles = {scene.puddles, 1};
  Picture p = scene.draw();
  const auto at = [&](const Vec2& ground) {
    const Vec2 pixel = scene.pixelOf({ground.x, scene.frame.groundHeight, ground.y});
    return int{p.at(static_cast<int>(pixel.x), static_cast<int>(pixel.y))[0]};
  };
  EXPECT_LT(at({0, 2}), at({1.6f, 2}) - 8);
  // It moves with the eye.
  scene.frame.camera.eye = Vec3(5.6f, 1.5f, 5.6f);
  p = scene.draw();
  EXPECT_LT(at({1.4f, 1.4f}), at({0, 2}) - 8);
}

TEST(DryGround, IsDarkestWhereTheModelStandsOnIt) {
  DropScene scene;
  // From the front, so that the shadow falls behind it.
  scene.frame.settings.lightYaw = 0;
  scene.frame.settings.lightPitch = 0.3f;
  scene.frame.settings.backgroundTop = scene.frame.settings.backgroundBottom;
  scene.frame.coatLength = scene.frame.settings.furLength = 0.02f;
  // How light the ground is in front of where a sphere comes down on it, and further in front.
  const auto lightAt = [&](float groundHeight, float z) {
    scene.frame.groundHeight = groundHeight;
    const Vec2 pixel = scene.pixelOf({0, groundHeight, z});
    return int{scene.draw().at(static_cast<int>(pixel.x), static_cast<int>(pixel.y))[0]};
  };
  EXPECT_LT(lightAt(-1.02f, 0.3f), lightAt(-1.25f, 0.3f) - 8);
  EXPECT_NEAR(lightAt(-1.02f, 1.0f), lightAt(-1.25f, 1.0f), 4);
}

TEST(WetGround, IsDarkerWhereItSaysSoWithASoftEdgeAndCostsNothingWhenDry) {
  DropScene scene;
  scene.frame.camera = {Vec3(0, 3, 6), Vec3(0, -0.5f, 0), 0.6f};
  scene.frame.settings.backgroundBottom = 0xc0c0c0;
  scene.renderer->takeUploadedBytes();
  const Picture dry = scene.draw();
  const std::size_t bytes = scene.renderer->takeUploadedBytes();
  scene.draw();
  EXPECT_LE(scene.renderer->takeUploadedBytes(), bytes);
  // A round one to the right of the model.
  const Vec2 spot(1.6f, 0.4f);
  scene.puddles.assign(kCells * kCells, 0);
  for (int j = 0; j < kCells; ++j)
    for (int i = 0; i < kCells; ++i) {
      const Vec2 at = (Vec2(i, j) + 0.5f) * (2 * kGroundHalfSide / kCells) - kGroundHalfSide;
      if (glm::length(at - spot) < 0.4f) scene.puddles[static_cast<std::size_t>(j * kCells + i)] = 255;
    }
  scene.frame.puddles = {scene.puddles, 1};
  const Picture p = scene.draw();
  const auto groundPixel = [&](const Vec2& at) { return scene.pixelOf({at.x, scene.frame.groundHeight, at.y}); };
  const auto change = [&](const Vec2& at) {
    const Vec2 pixel = groundPixel(at);
    return p.at(static_cast<int>(pixel.x), static_cast<int>(pixel.y))[0] - dry.at(static_cast<int>(pixel.x), static_cast<int>(pixel.y))[0];
  };
  const int middle = change(spot), outside = change(spot + Vec2(0.65f, 0));
  EXPECT_LT(middle, -25);
  EXPECT_EQ(outside, 0);
  // Its rim is uneven, but within 0.12 of where it says, and soft.
  int steps = 0;
  for (float reach = 0.2f; reach < 0.65f; reach += 0.01f) steps += change(spot + Vec2(reach, 0)) > middle + 6 && change(spot + Vec2(reach, 0)) < -4;
  EXPECT_GE(steps, 2);
  EXPECT_LT(change(spot + Vec2(0.25f, 0)), -20);
  EXPECT_EQ(change(spot - Vec2(0, 0.7f)), 0);
  const Patch patch = changed(dry, p);
  EXPECT_GT(patch.low.x, groundPixel(spot - Vec2(0.65f, 0)).x);
  EXPECT_LT(patch.high.x, groundPixel(spot + Vec2(0.65f, 0)).x);
  scene.frame.puddles = {};
  EXPECT_EQ(changed(dry, scene.draw()).count, 0);
}

}  // namespace
}  // namespace fur::render
