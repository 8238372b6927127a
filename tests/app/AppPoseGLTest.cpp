// A model that moves by itself, with fur on it.
#include "render/Frame.h"
#include "scene/Tentacle.h"
#include "tests/render/Picture.h"

namespace fur::app {
namespace {

struct Pool {
  test::Stage stage{160, 160};
  App app;
  explicit Pool(const char* furLength = "0.12", const scene::Tentacle& tentacle = {}) {
    stage.attach(app);
    for (const auto& [name, value] : {std::pair("layers", "8"), std::pair("tileSize", "64"), std::pair("breath", "0"), std::pair("furLength", furLength)})
      app.setField(name, value);
    EXPECT_TRUE(app.loadModel(tentacle.build(), "tentacle.glb"));
    app.settle();
    app.tick(0);
  }
  ~Pool() { app.detach(false); }
  void run(float seconds) {
    for (int i = 0; i < static_cast<int>(seconds * 60 + 0.5f); ++i) app.tick(1 / 60.0f);
  }
  std::vector<Vec4> bends() const { return {app.bends().begin(), app.bends().end()}; }
};

TEST(AppPose, ItPlaysHoldsAndStopsAsTheSettingsSay) {
  Pool pool("0");
  EXPECT_EQ(pool.app.animations(), "wave\nswell\n");
  pool.app.setCamera({0.35f, 0.28f, 5});  // chosen: no other animation changes it
  const auto first = pool.stage.draw(pool.app);
  EXPECT_TRUE(pool.app.active());
  pool.run(0.5f);
  const auto waved = pool.stage.draw(pool.app);
  EXPECT_GT(waved.differingShare(first, 16), 0.03f);
  pool.app.setField("animationSpeed", "0");
  pool.run(3);
  EXPECT_FALSE(pool.app.active());
  EXPECT_EQ(pool.stage.draw(pool.app).differingShare(waved, 0), 0);
  pool.app.setField("animation", "0");
  pool.run(3);
  EXPECT_FALSE(pool.app.active());
  EXPECT_LT(pool.stage.draw(pool.app).differingShare(first, 2), 0.002f);
}

TEST(AppPose, OnlyWhatMovesIsUploaded) {
  Pool pool;
  pool.run(0.2f);
  pool.stage.draw(pool.app);
  pool.run(1 / 60.0f);
  pool.stage.draw(pool.app);
  // Of a vertex place, normal and two gradients (15 numbers) and its bend; of an edge with a fin 28; and the two blocks.
  const App::Stats stats = pool.app.stats();
  const auto vertices = static_cast<std::size_t>(stats.vertices), edges = static_cast<std::size_t>(stats.finEdges);
  EXPECT_GE(stats.uploadedBytes, vertices * 4 * (15 + 4));
  EXPECT_LE(stats.uploadedBytes, vertices * 4 * (15 + 4) + edges * 4 * 28 + 2048);
}

TEST(AppPose, TheFurSwingsWithTheSkin) {
  Pool pool;
  const auto before = pool.bends();
  pool.run(0.6f);
  float most = 0;
  for (std::size_t i = 0; i < before.size(); ++i) most = std::max(most, glm::length(pool.bends()[i] - before[i]));
  EXPECT_GT(most, 0.1f);
}

TEST(AppPose, TheSameTwoSecondsLaterItIsTheSame) {
  Pool pool("0");
  pool.run(0.5f);
  const auto once = pool.stage.draw(pool.app);
  pool.run(2);
  // 120 steps of a sixtieth are two seconds to rounding.
  EXPECT_LT(pool.stage.draw(pool.app).differingShare(once, 8), 0.01f);
}

TEST(AppPose, LessMotionHoldsIt) {
  Pool pool;
  pool.app.setReducedMotion(true);
  pool.run(3);
  EXPECT_FALSE(pool.app.active());
}

TEST(AppPose, ItStaysInThePictureAndAboveTheGroundWhateverItPlays) {
  // It swings by its root, all round; and as it is.
  scene::Tentacle swung;
  swung.animations = R"({"samplers":[{"input":6,"output":7}],"channels":[)"
                     R"({"sampler":0,"target":{"path":"rotation","node":1}},{"sampler":0,"target":{"path":"rotation","node":2}},)"
                     R"({"sampler":0,"target":{"path":"rotation","node":3}},{"sampler":0,"target":{"path":"rotation","node":4}}]})";
  Pool pool("0.12", swung);
  for (const auto& [name, value] : {std::pair("ground", "0"), std::pair("view", "skin"), std::pair("skinColor", "#ff0000")})
    pool.app.setField(name, value);
  const float playing = pool.app.frame().groundHeight;
  const CameraOrbit fitted = pool.app.camera();
  int shown = 0;
  for (int k = 0; k < 20; ++k) {
    pool.run(0.1f);
    const auto picture = pool.stage.draw(pool.app);
    const auto isRed = [&](int x, int y) { return picture.at(x, y)[0] > picture.at(x, y)[2] + 40; };
    for (int i = 0; i < 160; ++i) {
      ASSERT_FALSE(isRed(i, 8) || isRed(i, 151) || isRed(8, i) || isRed(151, i)) << k << ' ' << i;
      shown += isRed(i, 80);
    }
  }
  EXPECT_GT(shown, 20);
  // Home comes back to it; without the animation the view is that of the model as it stands.
  pool.app.setCamera({0, 0, 3});
  pool.app.resetCamera();
  EXPECT_EQ(pool.app.camera().distance, fitted.distance);
  pool.app.setField("animation", "0");
  pool.run(3);
  EXPECT_LT(pool.app.camera().distance, 0.95f * fitted.distance);
  EXPECT_GT(pool.app.frame().groundHeight, playing + 0.03f);
  // A view that a person has chosen stays.
  pool.app.setCamera({0, 0, 3});
  pool.app.setField("animation", "1");
  pool.run(1);
  EXPECT_EQ(pool.app.camera().distance, 3);
}

TEST(AppPose, APixelIsOnTheModelWhereItIsShown) {
  Pool pool("0");
  pool.run(0.5f);
  pool.app.setField("animationSpeed", "0");
  pool.app.setField("ground", "0");
  pool.app.setField("view", "skin");
  pool.app.setField("skinColor", "#ff0000");
  pool.run(0.1f);
  const auto shown = pool.stage.draw(pool.app);
  int wrong = 0, on = 0;
  for (int y = 4; y < 160; y += 8)
    for (int x = 4; x < 160; x += 8) {
      const auto* texel = shown.at(x, y);
      const bool red = texel[0] > texel[2] + 40, hit = pool.app.pick(Vec2(x + 0.5f, y + 0.5f)).has_value();
      on += hit;
      wrong += red != hit;
    }
  EXPECT_GT(on, 5);
  EXPECT_LE(wrong, 1);  // on the outline
}

}  // namespace
}  // namespace fur::app
