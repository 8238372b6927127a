// Drops in the air and wet ground, beside a bare sphere.
#include <algorithm>
#include <cmath>
#include <limits>

#include "geometry/Primitives.h"
#include "geometry/Surface.h"
#include "render/Renderer.h"
#include "tests/render/Picture.h"

namespace fur::render {
namespace {

using test::Picture;
using test::Stage;

constexpr int kSide = 240, kCells = wet::Water::kGroundCells;

struct Scene {
  Stage stage{kSide, kSide, 4};
  std::optional<Renderer> renderer;
  Frame frame;
  std::vector<std::uint8_t> puddles;

  Scene() {
    stage.attachTarget();
    gl::rememberPlatformFramebuffer();
    renderer.emplace(std::move(Renderer::create().value()));
    renderer->setSurface(geometry::buildSurface(geometry::makeSphere()).value());
    const wet::WetnessMask dry(16);
    renderer->updateMask(dry, {0, 0, 16, 16}, std::vector<std::uint16_t>(16 * 16, 0), std::vector<std::uint32_t>(16 * 16, 0));
    frame.camera = {Vec3(0, 0.6f, 6), Vec3(0), 0.6f};
    frame.width = frame.height = kSide;
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
    return Vec2(0.5f + 0.5f * c.x / c.w, 0.5f - 0.5f * c.y / c.w) * static_cast<float>(kSide);
  }
};

bool differs(const Picture& a, const Picture& b, int x, int y, int by = 3) {
  for (int k = 0; k < 3; ++k)
    if (std::abs(a.at(x, y)[k] - b.at(x, y)[k]) > by) return true;
  return false;
}
// The pixels that differ: low and high corner, and how many.
struct Patch {
  Vec2 low{kSide}, high{0};
  int count = 0;
};
Patch changed(const Picture& a, const Picture& b) {
  Patch patch;
  for (int y = 0; y < kSide; ++y)
    for (int x = 0; x < kSide; ++x)
      if (differs(a, b, x, y)) {
        patch.low = glm::min(patch.low, Vec2(x, y));
        patch.high = glm::max(patch.high, Vec2(x, y));
        ++patch.count;
      }
  return patch;
}

constexpr Vec3 kBeside(1.35f, 0.9f, 0);

TEST(Drops, AreDiscsOfTheirSizeAndChangeNothingElse) {
  Scene scene;
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
  Scene scene;
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
  Scene scene;
  const Picture none = scene.draw();
  const Patch still = changed(none, scene.draw({{kBeside, 0.08f}})), falls = changed(none, scene.draw({{kBeside, 0.08f, Vec3(0, -4, 0)}})),
              flies = changed(none, scene.draw({{kBeside, 0.08f, Vec3(4, 0, 0)}})), comes = changed(none, scene.draw({{kBeside, 0.08f, Vec3(0, 0.001f, 40)}}));
  EXPECT_GT(falls.high.y - falls.low.y, 1.6f * (still.high.y - still.low.y));
  EXPECT_LT(falls.high.x - falls.low.x, 0.95f * (still.high.x - still.low.x));
  EXPECT_GT(flies.high.x - flies.low.x, 1.6f * (still.high.x - still.low.x));
  EXPECT_GT(comes.count, 20) << "one that comes at the eye is still a drop";
}

TEST(Drops, AreHiddenBehindTheModelAndFaintBelowAPixel) {
  Scene scene;
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

TEST(WetGround, IsDarkerWhereItSaysSoWithASoftEdgeAndCostsNothingWhenDry) {
  Scene scene;
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
  scene.frame.puddles = scene.puddles;
  scene.frame.puddlesRevision = 1;
  const Picture p = scene.draw();
  const auto groundPixel = [&](const Vec2& at) { return scene.pixelOf({at.x, scene.frame.groundHeight, at.y}); };
  const auto change = [&](const Vec2& at) {
    const Vec2 pixel = groundPixel(at);
    return p.at(static_cast<int>(pixel.x), static_cast<int>(pixel.y))[0] - dry.at(static_cast<int>(pixel.x), static_cast<int>(pixel.y))[0];
  };
  const int middle = change(spot), edge = change(spot + Vec2(0.46f, 0)), outside = change(spot + Vec2(0.6f, 0));
  EXPECT_LT(middle, -25);
  EXPECT_LT(edge, -4);
  EXPECT_GT(edge, middle + 6);
  EXPECT_EQ(outside, 0);
  EXPECT_EQ(change(spot - Vec2(0, 0.7f)), 0);
  const Patch patch = changed(dry, p);
  EXPECT_GT(patch.low.x, groundPixel(spot - Vec2(0.6f, 0)).x);
  EXPECT_LT(patch.high.x, groundPixel(spot + Vec2(0.6f, 0)).x);
  scene.frame.puddles = {};
  EXPECT_EQ(changed(dry, scene.draw()).count, 0);
}

}  // namespace
}  // namespace fur::render
