// Pictures and turntables that the panel orders.
#include "app/editor/Studio.h"

#include <cmath>

#include "app/editor/EditorGroom.h"
#include "tests/render/Picture.h"

namespace fur::app {
namespace {

struct StudioDesk : test::Scene {
  Studio studio{app};
  StudioDesk() : Scene(240, 180) { app.setField("layers", "8"); }

  // All frames, one after the other.
  std::vector<test::Picture> take(const PictureOrder& order) {
    EXPECT_TRUE(studio.begin(order));
    std::vector<test::Picture> frames;
    while (studio.busy()) {
      auto band = studio.next();
      EXPECT_TRUE(static_cast<bool>(band));
      if (!band) break;
      if (band->top == 0) frames.push_back({order.width, order.height, {}});
      auto& rgba = frames.back().rgba;
      EXPECT_EQ(rgba.size(), std::size_t(4) * static_cast<std::size_t>(order.width * band->top)) << "one below the other";
      rgba.insert(rgba.end(), band->rgba.begin(), band->rgba.end());
      EXPECT_EQ(band->lastOfFrame, rgba.size() == std::size_t(4) * static_cast<std::size_t>(order.width * order.height));
    }
    return frames;
  }
};

TEST(Studio, APictureOfTheShownSizeIsWhatIsShown) {
  StudioDesk desk;
  desk.app.settle();
  const auto frames = desk.take({240, 180});
  ASSERT_EQ(frames.size(), 1u);
  EXPECT_EQ(frames[0].differingShare(desk.draw(), 0), 0);
}

TEST(Studio, LargePicturesComeInBands) {
  StudioDesk desk;
  desk.app.settle();
  desk.app.setField("ground", "false");
  ASSERT_TRUE(desk.studio.begin({512, 8192}));
  int bands = 0;
  for (float before = -1; desk.studio.busy(); ++bands) {
    EXPECT_GT(desk.studio.progress(), before);
    before = desk.studio.progress();
    ASSERT_TRUE(static_cast<bool>(desk.studio.next()));
  }
  EXPECT_GT(bands, 1);
}

TEST(Studio, RefusesASizeThatTheMachineDoesNotDraw) {
  StudioDesk desk;
  for (const auto& [width, height] : {std::pair(8193, 100), {100, 100000}, {15, 100}, {100, 0}}) {
    const Status status = desk.studio.begin({width, height});
    ASSERT_FALSE(status) << width << 'x' << height;
    EXPECT_EQ(status.error().id, ErrorId::TooLarge);
    EXPECT_NE(status.error().message.find(std::to_string(mostPictureSide())), std::string::npos) << status.error().message;
    EXPECT_FALSE(desk.studio.busy());
  }
}

TEST(Studio, ATurnGoesRoundInEvenStepsAndEndsWhereItBegan) {
  StudioDesk desk;
  desk.app.setField("furLength", "0.02");
  desk.app.setCamera({0.3f, 0.2f, 3, Vec3(0)});
  ASSERT_TRUE(desk.studio.begin({32, 32, false, 8, 4}));
  std::vector<float> yaws;
  while (desk.studio.busy()) {
    ASSERT_TRUE(static_cast<bool>(desk.studio.next()));
    yaws.push_back(desk.app.camera().yaw);
  }
  ASSERT_EQ(yaws.size(), 8u);
  for (std::size_t i = 0; i + 1 < 8; ++i) EXPECT_NEAR(yaws[i] - 0.3f, -2 * kPi * static_cast<float>(i) / 8, 1e-4f);
  EXPECT_EQ(yaws[7], 0.3f) << "when the last is drawn the view is back";
}

TEST(Studio, TimeGoesByBetweenFramesOfATurnAndNotForAPicture) {
  StudioDesk desk;
  desk.app.setField("dryRate", "1");
  desk.app.setWetness(1);
  desk.app.tick(0);
  const float before = desk.app.meanWetness();
  desk.take({32, 32});
  EXPECT_EQ(desk.app.meanWetness(), before);
  desk.take({32, 32, false, 4, 1});
  EXPECT_LT(desk.app.meanWetness(), before);
}

TEST(Studio, GivenUpTheSceneIsAsItWas) {
  StudioDesk desk;
  const CameraOrbit before = desk.app.camera();
  ASSERT_TRUE(desk.studio.begin({32, 32, false, 8, 4}));
  for (int i = 0; i < 3; ++i) ASSERT_TRUE(static_cast<bool>(desk.studio.next()));
  EXPECT_NE(desk.app.camera().yaw, before.yaw);
  desk.studio.end();
  EXPECT_FALSE(desk.studio.busy());
  EXPECT_EQ(desk.app.camera().yaw, before.yaw);
}

// What grooming tools show of the mask is for who grooms.
TEST(Studio, TheMaskIsInNoPicture) {
  GroomStage::setEditorBrushes(&kEditorGroom);
  StudioDesk desk;
  desk.app.settle();
  const test::Picture plain = desk.take({240, 180})[0];
  desk.app.groomAll(GroomEdit::InvertMask);
  desk.app.setTool(Tool::Comb);
  desk.app.settle();
  EXPECT_GT(desk.draw().differingShare(plain, 20), 0.1f) << "it shows while one grooms";
  EXPECT_EQ(desk.take({240, 180})[0].differingShare(plain, 0), 0);
  EXPECT_GT(desk.draw().differingShare(plain, 20), 0.1f) << "and does again";
  GroomStage::setEditorBrushes(nullptr);
}

}  // namespace
}  // namespace fur::app
