// Pictures that are saved: transparent ones, and parts of large ones, beside what is shown.
#include "scene/Png.h"

#include "tests/render/Picture.h"

namespace fur::app {
namespace {

constexpr int kWidth = 240, kHeight = 180;

struct Photo : test::Scene {
  Photo() : Scene(kWidth, kHeight) {
    app.setField("layers", "8");
    app.setField("furLength", "0.25");
    app.settle();
  }
  test::Picture transparent() {
    app.setSaved(true, true);
    test::Picture picture = draw();
    app.setSaved(false);
    return picture;
  }
};

// Straight colours laid over one colour.
test::Picture over(test::Picture picture, const int (&rgb)[3]) {
  scene::makeStraight(picture.rgba);
  for (std::size_t i = 0; i < picture.rgba.size(); i += 4)
    for (std::size_t k = 0; k < 3; ++k) {
      const int alpha = picture.rgba[i + 3];
      picture.rgba[i + k] = static_cast<std::uint8_t>((picture.rgba[i + k] * alpha + rgb[k] * (255 - alpha) + 127) / 255);
    }
  return picture;
}

TEST(AppPicture, ATransparentOneIsClearBesideTheModelAndHalfClearAtItsStrands) {
  Photo photo;
  const test::Picture picture = photo.transparent();
  for (const auto& [x, y] : {std::pair(0, 0), {kWidth - 1, 0}, {0, kHeight - 1}, {kWidth - 1, kHeight - 1}}) {
    for (int k = 0; k < 4; ++k) EXPECT_EQ(picture.at(x, y)[k], 0) << x << ' ' << y;
  }
  EXPECT_EQ(picture.at(kWidth / 2, kHeight / 2)[3], 255);
  int between = 0;
  for (std::size_t i = 3; i < picture.rgba.size(); i += 4) between += picture.rgba[i] > 0 && picture.rgba[i] < 255;
  EXPECT_GT(between, kHeight) << "the outline is made of strands";
}

TEST(AppPicture, LaidOverTheBackgroundATransparentOneIsTheOpaqueOne) {
  Photo photo;
  photo.app.setField("ground", "false");
  for (const auto& [text, rgb] : {std::pair("#e8f0ff", std::array{232, 240, 255}), {"#301008", std::array{48, 16, 8}}}) {
    photo.app.setField("backgroundTop", text);
    photo.app.setField("backgroundBottom", text);
    const int color[] = {rgb[0], rgb[1], rgb[2]};
    // Noise of half a step in the background, and rounding: of straight colours by their alpha, then of the sum.
    EXPECT_EQ(over(photo.transparent(), color).differingShare(photo.draw(), 3), 0) << text;
  }
}

TEST(AppPicture, TheSameHoldsWetWithDropsThatFallAndForViews) {
  Photo photo;
  photo.app.setField("ground", "false");
  photo.app.setField("backgroundTop", "#808080");
  photo.app.setField("backgroundBottom", "#808080");
  const int grey[] = {128, 128, 128};
  photo.app.setWetness(1.5f);
  for (int i = 0; i < 60; ++i) photo.app.tick(1 / 60.0f);
  ASSERT_FALSE(photo.app.drops().empty());
  EXPECT_LT(over(photo.transparent(), grey).differingShare(photo.draw(), 4), 0.001f);
  for (const char* view : {"skin", "layer", "tangents", "silhouette"}) {
    photo.app.setField("view", view);
    EXPECT_EQ(over(photo.transparent(), grey).differingShare(photo.draw(), 3), 0) << view;
    EXPECT_EQ(photo.transparent().at(0, 0)[3], 0) << view;
  }
}

TEST(AppPicture, PartsMakeUpTheWhole) {
  Photo photo;
  const test::Picture whole = photo.draw();
  constexpr int kRows = 36;  // a factor of the height
  test::Stage band(kWidth, kRows, 4);
  test::Picture together{kWidth, kHeight, {}};
  for (int top = 0; top < kHeight; top += kRows) {
    band.attachTarget();
    const gl::PlatformStandIn standIn;
    ASSERT_TRUE(photo.app.drawPart({kWidth, kHeight, kHeight - top - kRows, kRows, false}));
    const test::Picture part = band.read();
    together.rgba.insert(together.rgba.end(), part.rgba.begin(), part.rgba.end());
  }
  // But for a pixel here and there on which a triangle's edge is rounded to the other side.
  EXPECT_LT(together.differingShare(whole, 0), 0.002f);
}

TEST(AppPicture, WhatIsShownStaysAsItWas) {
  Photo photo;
  photo.app.setCovered({0.4f, 0}, true);
  const test::Picture before = photo.draw();
  ASSERT_FALSE(photo.app.tick(0));
  {
    test::Stage other(64, 256, 4);
    other.attachTarget();
    const gl::PlatformStandIn standIn;
    ASSERT_TRUE(photo.app.drawPart({64, 256, 0, 256, true}));
  }
  EXPECT_FALSE(photo.app.tick(0)) << "there is nothing to draw anew";
  EXPECT_EQ(photo.draw().differingShare(before, 0), 0);
}

TEST(AppPicture, WhileTheSceneStandsNoTimeGoesBy) {
  Photo photo;
  photo.app.setField("wind", "1");
  photo.app.setStanding(true);
  const test::Picture before = photo.draw();
  for (int i = 0; i < 30; ++i) photo.app.tick(1 / 60.0f);
  EXPECT_EQ(photo.draw().differingShare(before, 0), 0);
  photo.app.setStanding(false);
  for (int i = 0; i < 30; ++i) photo.app.tick(1 / 60.0f);
  EXPECT_GT(photo.draw().differingShare(before, 8), 0.01f);
}

}  // namespace
}  // namespace fur::app
