#include "tests/render/Picture.h"

namespace fur::render {
namespace {

using test::Picture;
using test::Scene;

TEST(Renderer, DrawsTheSamePictureTwice) {
  Scene scene;
  const Picture first = scene.draw();
  EXPECT_EQ(first.differingShare(scene.draw(), 0), 0);
}

TEST(Renderer, FurReachesBeyondTheSkin) {
  Scene scene;
  scene.app.setField("ground", "false");
  const Picture skin = scene.with("view", "skin");
  const Picture final = scene.with("view", "final");
  // The top of the fitted sphere and the row half a fur length above it.
  int skinTop = 0, furTop = 0;
  const auto differs = [&](const Picture& p, int y) {
    const std::uint8_t* edge = p.at(2, y);
    const std::uint8_t* middle = p.at(p.width / 2, y);
    return std::abs(edge[0] - middle[0]) + std::abs(edge[1] - middle[1]) + std::abs(edge[2] - middle[2]) > 24;
  };
  while (skinTop < skin.height && !differs(skin, skinTop)) ++skinTop;
  while (furTop < final.height && !differs(final, furTop)) ++furTop;
  EXPECT_LT(furTop, skinTop - 2);
}

TEST(Renderer, NoFurAtLengthOrDensityZero) {
  for (const char* bald : {"furLength", "density"}) {
    Scene scene;
    scene.app.setField("ground", "false");
    scene.app.setField(bald, "0");
    const Picture skin = scene.with("view", "skin");
    EXPECT_EQ(skin.differingShare(scene.with("view", "final"), 0), 0) << bald;
  }
}

TEST(Renderer, WetFurIsDarkerAndWithGaps) {
  Scene scene;
  scene.app.setField("ground", "false");
  const Picture dry = scene.draw();
  scene.app.setWetness(0.8f);
  const Picture wet = scene.draw();
  EXPECT_LT(wet.brightness(), dry.brightness() - 5);
  EXPECT_GT(wet.differingShare(dry, 24), 0.25f);
}

TEST(Renderer, DryAgainLooksAsBefore) {
  Scene scene;
  const Picture dry = scene.draw();
  scene.app.setWetness(0.8f);
  scene.draw();
  scene.app.setWetness(0);
  scene.app.settle();
  EXPECT_EQ(dry.differingShare(scene.draw(), 0), 0);
}

TEST(Renderer, TheLayerCountDoesNotChangeTheLook) {
  Scene scene;
  const Picture coarse = scene.with("layers", "16");
  const Picture fine = scene.with("layers", "64");
  // The strands move by a fraction of a layer, so pixels differ; the mean must not.
  EXPECT_NEAR(coarse.brightness(), fine.brightness(), 3);
}

TEST(Renderer, WindMovesShellsAndFins) {
  Scene scene;
  // Their rims have fins all round; on the bunny the shells show most of the outline.
  ASSERT_TRUE(scene.app.loadModel(test::planeInParts(), "parts.glb"));
  const Picture shells = scene.with("view", "shells");
  const Picture fins = scene.with("view", "fins");
  scene.app.setField("gust", "0");
  scene.app.setField("wind", "1");
  EXPECT_GT(fins.differingShare(scene.with("view", "fins"), 16), 0.01f);
  EXPECT_GT(shells.differingShare(scene.with("view", "shells"), 8), 0.02f);
}

TEST(Renderer, UploadsOnlyTheChangedRectangleOfTheMask) {
  Scene scene;
  // All is wet already: which patches are is brought to the GPU as well when that changes.
  scene.app.setField("stayWet", "true");
  scene.app.setWetness(0.3f);
  scene.app.settle();
  scene.draw();
  scene.draw();
  const std::size_t still = scene.app.stats().uploadedBytes;
  scene.app.splashAt(0.52f, 0.58f, 0.02f, 0.5f);  // well inside a chart
  scene.draw();
  const std::size_t painting = scene.app.stats().uploadedBytes - still;
  // A droplet of 0.02 of 256 texels spans 12 texels at most, and 18 more about it may look drier or wetter; 16 bytes each.
  EXPECT_GT(painting, 0u);
  EXPECT_LE(painting, 48u * 48u * 16u);
  EXPECT_LT(still, 4096u) << "a still frame uploads its uniforms only";
}

TEST(Renderer, ALostContextComesBackAsItWas) {
  Scene scene;
  scene.app.setWetness(0.6f);
  scene.app.settle();
  const Picture before = scene.draw();
  // Not deleted, as after a real loss: names of the old context must not be touched.
  scene.app.detach(true);
  scene.stage.attach(scene.app);
  EXPECT_EQ(before.differingShare(scene.draw(), 0), 0);
}

TEST(Renderer, APictureOfTheModelTintsTheFur) {
  Scene scene;
  const Picture white = scene.draw();
  std::vector<std::uint8_t> green = {20, 220, 40, 255};
  scene.app.provideImage(1, 1, green);
  const Picture tinted = scene.draw();
  const std::uint8_t* before = white.at(120, 90);
  const std::uint8_t* after = tinted.at(120, 90);
  EXPECT_LT(after[0], before[0] / 2);
  EXPECT_GT(after[1], after[0]);
}

TEST(Renderer, AStrandHasTheColourOfItsRootUpToItsTip) {
  // A plane, half red and half green, under fur that the comb lays over the border.
  Scene scene;
  const std::string_view square =
      "v -1 0 -1\nv 1 0 -1\nv 1 0 1\nv -1 0 1\nvt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\nvn 0 1 0\nf 1/1/1 4/4/1 3/3/1 2/2/1\n";
  const auto* bytes = reinterpret_cast<const std::uint8_t*>(square.data());
  ASSERT_TRUE(scene.app.loadModel({bytes, bytes + square.size()}, "square.obj"));
  scene.app.setField("furLength", "0.3");
  scene.app.setCamera({0, 1.5f, 3, Vec3(0)});
  const std::vector<std::uint8_t> halves = {255, 0, 0, 255, 0, 255, 0, 255};
  scene.app.provideImage(2, 1, halves);
  const auto redShare = [&] {
    scene.app.settle();
    const Picture picture = scene.draw();
    int red = 0, green = 0;
    for (int y = 60; y < 120; ++y)
      for (int x = 60; x < 180; ++x) (picture.at(x, y)[0] > picture.at(x, y)[1] ? red : green) += 1;
    return static_cast<float>(red) / static_cast<float>(red + green);
  };
  const float upright = redShare();
  EXPECT_NEAR(upright, 0.5f, 0.06f);
  scene.app.groomAll(app::GroomEdit::Comb, 1, Vec3(1, 0, 0));
  const float right = redShare();
  scene.app.groomAll(app::GroomEdit::Comb, 1, Vec3(-1, 0, 0));
  scene.app.groomAll(app::GroomEdit::Comb, 1, Vec3(-1, 0, 0));
  const float left = redShare();
  // Which side is red depends on the plane's uv: the border moves with the strands that lie over it.
  EXPECT_GT(std::abs(right - left), 0.05f) << left << " " << upright << " " << right;
}

}  // namespace
}  // namespace fur::render
