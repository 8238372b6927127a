// A picture that stays gets better: samples of it are gathered while nothing changes.
#include <cmath>

#include "app/view/QualityGovernor.h"
#include "core/Srgb.h"
#include "tests/render/Picture.h"

namespace fur::app {
namespace {

constexpr int kSide = 96;
constexpr std::size_t kPixels = std::size_t{kSide} * kSide;

struct GatheringScene {
  test::Stage stage{kSide, kSide, 4};
  App app;
  GatheringScene() {
    stage.attach(app);
    app.setField("layers", "8");
    app.setField("breath", "0");
    app.settle();
    app.tick(0);
  }
  ~GatheringScene() { app.detach(false); }

  // A machine on which pictures that move are coarse: their frames are given to take so many milliseconds.
  void beSlow(float frame) {
    app.setQuality(0, true);
    for (int i = 0; i < 60; ++i) app.frameShown(frame);
  }
  test::Picture of(int samples) {
    stage.attachTarget();
    EXPECT_TRUE(app.draw(Picture::Best, samples));
    return stage.read();
  }
  // Until there is nothing better; how many pictures were shown, and how many steps showed none.
  std::pair<int, int> improve(int most = 100'000) {
    stage.attachTarget();
    std::pair<int, int> steps(0, 0);
    while (app.improvable() && steps.first + steps.second < most) {
      const auto shown = app.improve();
      EXPECT_TRUE(shown);
      ++(shown.value() ? steps.first : steps.second);
    }
    return steps;
  }
};

// Of light, as the eye takes the mean of grain.
double light(const test::Picture& picture) {
  double sum = 0;
  for (std::size_t i = 0; i < picture.rgba.size(); ++i)
    if (i % 4 < 3) sum += decodeSrgb(Vec3(picture.rgba[i] / 255.0f)).x;
  return sum / static_cast<double>(3 * kPixels);
}

double distance(const test::Picture& a, const test::Picture& b) {
  double sum = 0;
  for (std::size_t i = 0; i < a.rgba.size(); ++i) sum += std::abs(a.rgba[i] - b.rgba[i]);
  return sum / static_cast<double>(a.rgba.size());
}

TEST(Refine, APictureThatStaysGetsBetterAndThenNothingIsDrawn) {
  GatheringScene studio;
  const test::Picture once = studio.of(1);
  const long drawn = studio.app.stats().framesDrawn;
  const auto [shown, hidden] = studio.improve();
  EXPECT_EQ(shown, mostSamples() - 1);  // the first of them is the one that is there
  EXPECT_EQ(hidden, 1);
  EXPECT_EQ(studio.app.stats().framesDrawn, drawn + shown);
  EXPECT_FALSE(studio.app.improvable());
  const auto more = studio.app.improve();
  ASSERT_TRUE(more);
  EXPECT_FALSE(more.value());
  EXPECT_FALSE(studio.app.active());
  EXPECT_GT(distance(studio.stage.read(), once), 0.5);
}

// On a sphere, no part of which is seen past another: there samples have a further shell (App::State::chooseShellCount()).
TEST(Refine, TheFirstSampleIsThePictureThatIsDrawnOnce) {
  GatheringScene studio;
  const test::Picture once = studio.of(1);
  studio.stage.attachTarget();
  const auto first = studio.app.improve();
  ASSERT_TRUE(first);
  EXPECT_FALSE(first.value());
  ASSERT_TRUE(studio.app.showAgain().value());
  EXPECT_EQ(studio.stage.read().differingShare(once, 0), 0);
}

TEST(Refine, SoManySamplesAreTheSamePictureInOneGoOrBandByBand) {
  GatheringScene studio;
  const test::Picture once = studio.of(16);
  studio.beSlow(400);
  EXPECT_TRUE(studio.app.draw(Picture::Moving));
  ASSERT_GT(studio.app.stats().level, 0);
  const auto [shown, hidden] = studio.improve();
  EXPECT_GE(shown, 16);
  EXPECT_GT(hidden, 3 * 16);  // bands
  EXPECT_EQ(studio.app.stats().level, 0);
  EXPECT_EQ(studio.stage.read().differingShare(once, 0), 0);
}

TEST(Refine, ABandDrawsItsOwnRowsAlone) {
  GatheringScene studio;
  studio.beSlow(900);
  EXPECT_TRUE(studio.app.draw(Picture::Moving));
  while (studio.app.stats().level > 0 && studio.app.improve().value()) {}
  studio.stage.attachTarget();
  gl::clear(Vec4(1, 0, 1, 1));
  ASSERT_TRUE(studio.app.improve());
  const test::Picture picture = studio.stage.read();
  for (int y = 0; y < kSide / 2; ++y)
    for (int x = 0; x < kSide; x += 7) ASSERT_TRUE(picture.at(x, y)[0] == 255 && picture.at(x, y)[1] == 0) << x << ", " << y;
}

TEST(Refine, MoreSamplesAreNearerToAllOfThem) {
  GatheringScene studio;
  const test::Picture all = studio.of(64);
  const double one = distance(studio.of(1), all), four = distance(studio.of(4), all), many = distance(studio.of(16), all);
  EXPECT_LT(four, 0.7 * one);
  EXPECT_LT(many, 0.6 * four);
}

// What an eye that does not see the grain sees hardly changes, so nothing flashes: a thirtieth, as samples find strands half a step earlier.
TEST(Refine, TheLightOfThePictureStays) {
  GatheringScene studio;
  for (const char* wetness : {"0", "0.5", "1"}) {
    studio.app.setWetness(std::strtof(wetness, nullptr));
    studio.app.settle();
    const double once = light(studio.of(1));
    EXPECT_NEAR(light(studio.of(16)), once, once / 30) << wetness;
  }
}

// Rays along a level coat go through more of it than there may be steps.
TEST(Refine, NoRayEndsBeforeItsStrands) {
  GatheringScene studio;
  ASSERT_TRUE(studio.app.setField("repeat", "4"));
  ASSERT_TRUE(studio.app.loadPrimitive("plane"));
  studio.app.setCamera({0.4f, 0.15f, 1.3f});
  studio.app.settle();
  const double once = light(studio.of(1));
  EXPECT_NEAR(light(studio.of(16)), once, once / 20);
}

// A bare sphere before a plain wall: as many rows as before go from one to the other within two pixels.
TEST(Refine, WhatIsSharpStaysSharp) {
  GatheringScene studio;
  for (const auto& [name, value] : {std::pair("furLength", "0"), std::pair("ground", "false"), std::pair("backgroundTop", "#00ff00"), std::pair("backgroundBottom", "#00ff00")})
    ASSERT_TRUE(studio.app.setField(name, value));
  studio.app.settle();
  const auto blurred = [&](const test::Picture& picture) {
    int count = 0;
    for (int y = kSide / 2 - 10; y < kSide / 2 + 10; ++y)
      for (int x = 0; x < kSide / 2; ++x) {
        const int green = picture.at(x, y)[1];
        count += green < 250 && picture.at(x, y)[1] - picture.at(x, y)[0] > 40;
      }
    return count;
  };
  EXPECT_LE(blurred(studio.of(64)), 2 * 20);
  EXPECT_GE(blurred(studio.of(64)), 10);
}

TEST(Refine, AChangeStartsAfresh) {
  GatheringScene studio;
  studio.of(1);
  studio.improve(20);
  studio.app.setField("tipColor", "#3030ff");
  ASSERT_TRUE(studio.app.tick(0));
  EXPECT_FALSE(studio.app.showAgain().value());
  const test::Picture changed = studio.of(1);
  studio.improve();
  const test::Picture gathered = studio.stage.read();
  EXPECT_EQ(gathered.differingShare(studio.of(64), 0), 0);
  // Nothing of what was there before.
  EXPECT_LT(distance(gathered, changed), 8);
}

// Frames of some seconds after the next one: those drawn because something has moved, and improvements that are shown and that are not yet.
struct SlowFrames {
  int moved = 0, shown = 0, hidden = 0;
};
SlowFrames framesOf(GatheringScene& studio, int seconds) {
  SlowFrames frames;
  // What had run down the fur until then is a burst of changes: a second later it is forgotten.
  for (int i = -60; i < 60 * seconds; ++i) {
    const bool draws = studio.app.tick(1 / 60.0f);
    if (draws) studio.of(1);
    frames.moved += draws && i >= 0;
    if (!studio.app.improvable()) continue;
    studio.stage.attachTarget();
    (studio.app.improve().value() ? frames.shown : frames.hidden) += i >= 0;
  }
  return frames;
}

// Else it would be grainy for a moment once a second.
TEST(Refine, FurThatDriesKeepsItsPictureUntilTheNextIsGathered) {
  GatheringScene studio;
  studio.app.setWetness(0.4f);
  for (int i = 0; i < 600; ++i) studio.app.tick(1 / 60.0f);
  studio.of(1);
  EXPECT_EQ(studio.improve().first, 15);
  const auto [moved, shown, hidden] = framesOf(studio, 5);
  EXPECT_EQ(moved, 0);
  EXPECT_GE(shown, 2);
  EXPECT_GE(hidden, 14 * shown);
  // What somebody does is seen at once.
  ASSERT_TRUE(studio.app.splashPixel({kSide / 2, kSide / 2}, 0.1f, 0.5f));
  EXPECT_TRUE(studio.app.tick(1 / 60.0f));
}

// It creeps for minutes: that was a picture without end, drawn anew as fast as the machine could.
TEST(Refine, WaterThatCreepsInTheFurKeepsItsPictureUntilTheNextIsGathered) {
  GatheringScene studio;
  studio.app.setWetness(0.3f);
  ASSERT_TRUE(studio.app.splashPixel({kSide / 2, kSide / 2}, 0.2f, 0.6f));
  for (int i = 0; i < 900; ++i) studio.app.tick(1 / 60.0f);
  studio.of(1);
  studio.improve();
  const float before = studio.app.meanWetness();
  // Changes too small to be seen are shown every eight seconds.
  const SlowFrames frames = framesOf(studio, 16);
  EXPECT_NE(studio.app.meanWetness(), before);
  EXPECT_EQ(frames.moved, 0);
  EXPECT_GE(frames.shown, 2);
}

// Sixtieths of a second in which water runs down soaked fur, each drawn as it is on a page.
void run(GatheringScene& studio, int frames) {
  for (int i = 0; i < frames; ++i)
    if (studio.app.tick(1 / 60.0f)) {
      studio.stage.attachTarget();
      EXPECT_TRUE(studio.app.draw(Picture::Moving));
    }
}

// Water runs down soaked fur, and drops off it, for a minute and more: all that time one saw the grain of single pictures.
TEST(Refine, WhileNothingButWaterMovesThePictureIsAMeanThatFollowsIt) {
  GatheringScene studio;
  ASSERT_TRUE(studio.app.setField("wind", "0"));
  studio.app.setWetness(1);
  for (int i = 0; i < 1200; ++i) studio.app.tick(1 / 60.0f);  // what hangs down wet has come to rest
  run(studio, 40);
  const test::Picture followed = studio.stage.read(), best = studio.of(64), once = studio.of(1);
  EXPECT_LT(distance(followed, best), 0.6 * distance(once, best));
  // What is done to it is there in the next picture as if it had been drawn once.
  run(studio, 10);
  studio.app.setField("rimLight", "1");
  run(studio, 1);
  EXPECT_EQ(studio.stage.read().differingShare(studio.of(1), 0), 0);
}

// There all of soaked fur was coarse for that minute.
TEST(Refine, WhileNothingButWaterMovesASlowMachineShowsTheBestPictureAsItComesBandByBand) {
  GatheringScene studio;
  ASSERT_TRUE(studio.app.setField("wind", "0"));
  studio.beSlow(900);
  studio.app.setWetness(1);
  for (int i = 0; i < 1200; ++i) studio.app.tick(1 / 60.0f);
  run(studio, 4);
  const int coarse = studio.app.stats().level;
  const test::Picture first = studio.stage.read();
  ASSERT_GT(coarse, 1);  // in fewer pixels
  run(studio, 3);  // so few bands are not the whole
  EXPECT_EQ(studio.app.stats().level, coarse);
  EXPECT_LT(studio.stage.read().differingShare(first, 30), 0.02) << "no part of it is shown before";
  int frames = 0;
  for (; studio.app.stats().level > 0 && frames < 100; ++frames) run(studio, 1);
  EXPECT_GT(frames, 3);
  EXPECT_LT(frames, 100);
  run(studio, 8 * frames);
  const test::Picture followed = studio.stage.read(), best = studio.of(64), once = studio.of(1);
  // Less than where no water has run on between bands.
  EXPECT_LT(distance(followed, best), 0.85 * distance(once, best));
  EXPECT_LT(distance(followed, best), 0.85 * distance(first, best));
}

// In a mean of eight a drop that falls would be eight drops that hardly show.
// `others`: pixels at most, as a share of those of drops, that differ where no drop is: a mean in bands is older, of strands that drops have moved.
void expectDropsOverMean(GatheringScene& studio, double others) {
  ASSERT_TRUE(studio.app.drawPart({kSide, kSide, 0, kSide, true, 16}));
  const test::Picture model = studio.stage.read(), before = studio.of(1);
  studio.app.sprinkle(60);
  run(studio, 24);
  const test::Picture followed = studio.stage.read(), once = studio.of(1);
  int drops = 0, alike = 0, trails = 0;
  for (std::size_t i = 0; i < 4 * kPixels; i += 4) {
    if (model.rgba[i + 3] > 0) continue;
    const auto apart = [&](const test::Picture& a, const test::Picture& b) { return std::abs(a.rgba[i] - b.rgba[i]) > 6; };
    if (apart(once, before)) ++drops, alike += !apart(followed, once);
    else trails += apart(followed, once);
  }
  EXPECT_GT(drops, 20) << "there are some";
  EXPECT_EQ(alike, drops);
  EXPECT_LE(trails, others * drops);
}

TEST(Refine, DropsFlyOverAMeanAsOverASinglePicture) {
  GatheringScene studio;
  expectDropsOverMean(studio, 0);
}

TEST(Refine, DropsFlyOverAMeanThatComesBandByBand) {
  GatheringScene studio;
  studio.beSlow(300);  // no more bands than come while drops fall
  expectDropsOverMean(studio, 0.1);
}

TEST(Refine, APanelThatMovesAloneFindsThePictureAsItWas) {
  GatheringScene studio;
  studio.of(1);
  EXPECT_FALSE(studio.app.showAgain().value());  // it is to be drawn
  studio.improve(10);
  const test::Picture before = studio.stage.read();
  gl::clear(Vec4(1, 0, 1, 1));
  ASSERT_TRUE(studio.app.showAgain().value());
  EXPECT_EQ(studio.stage.read().differingShare(before, 0), 0);
  EXPECT_TRUE(studio.app.improvable());
}

TEST(Refine, ThePictureThatIsShownIsNoWorseAfterOneForAFile) {
  GatheringScene studio;
  studio.of(1);
  studio.improve(10);
  ASSERT_TRUE(studio.app.drawPart({kSide, kSide, 0, kSide, false, 4}));
  EXPECT_FALSE(studio.app.showAgain().value());
  int hidden = 0;
  while (!studio.app.improve().value()) ++hidden;
  EXPECT_EQ(hidden, 10);
}

TEST(Refine, NobodyGathersWithoutTheSettingOrWhileItIsNotWanted) {
  GatheringScene studio;
  studio.of(1);
  EXPECT_TRUE(studio.app.improvable());
  EXPECT_EQ(studio.app.savedSamples(), 16);
  studio.app.setRefining(false);
  EXPECT_FALSE(studio.app.improvable());
  EXPECT_EQ(studio.app.savedSamples(), 1);
  studio.app.setRefining(true);
  ASSERT_TRUE(studio.app.setField("refine", "false"));
  studio.of(1);
  EXPECT_FALSE(studio.app.improvable());
  EXPECT_EQ(studio.app.savedSamples(), 1);
}

TEST(Refine, ItTakesTwentyBytesAPixelAndEightOnceThePictureIsAsGoodAsItGets) {
  GatheringScene studio;
  studio.of(1);
  const std::size_t before = studio.app.stats().gpuBytes;
  studio.improve(8);
  EXPECT_EQ(studio.app.stats().gpuBytes, before + 20 * kPixels);
  studio.improve();
  EXPECT_EQ(studio.app.stats().gpuBytes, before + 8 * kPixels);
}

TEST(Refine, APictureThatIsChangedAfterItCameToRestAndChangedBackIsTheSame) {
  GatheringScene studio;
  studio.app.setField("lightYaw", "-0.75");
  const auto gathered = [&](int most) {
    studio.of(1);
    studio.improve(most);
    return studio.stage.read();
  };
  const test::Picture whole = gathered(100'000);
  studio.app.setField("lightYaw", "1");
  EXPECT_GT(distance(gathered(8), whole), 1);
  studio.app.setField("lightYaw", "-0.75");
  EXPECT_EQ(gathered(100'000).differingShare(whole, 0), 0);
}

TEST(Refine, PartsOfAPictureAreThoseOfTheWhole) {
  GatheringScene studio;
  studio.app.setSaved(true);
  const test::Picture whole = studio.of(8);
  studio.app.setSaved(false);
  constexpr int kRows = kSide / 4;
  test::Stage part(kSide, kRows, 4);
  int differing = 0;
  for (int bottom = 0; bottom < kSide; bottom += kRows) {
    part.attachTarget();
    const gl::PlatformStandIn standIn;
    ASSERT_TRUE(studio.app.drawPart({kSide, kSide, bottom, kRows, false, 8}));
    const test::Picture rows = part.read();
    for (int y = 0; y < kRows; ++y)
      for (int x = 0; x < kSide; ++x)
        differing += std::abs(rows.at(x, y)[0] - whole.at(x, kSide - bottom - kRows + y)[0]) > 2;
  }
  EXPECT_LT(differing, kSide * kSide / 100);  // corners of triangles are rounded elsewhere
}

// Strands at the outline are half there, in their own colours: no dark and no bright rim.
TEST(Refine, TransparentPicturesHaveColoursByTheirAlpha) {
  GatheringScene studio;
  studio.app.setSaved(true, true);
  const test::Picture picture = studio.of(16);
  int between = 0, brighter = 0;
  for (int y = 0; y < kSide; ++y)
    for (int x = 0; x < kSide; ++x) {
      const std::uint8_t* rgba = picture.at(x, y);
      between += rgba[3] > 20 && rgba[3] < 235;
      for (int k = 0; k < 3; ++k) brighter += rgba[k] > rgba[3] + 1;
    }
  EXPECT_GT(between, 200);
  EXPECT_EQ(brighter, 0);
  EXPECT_EQ(picture.at(1, 1)[3], 0);
}

}  // namespace
}  // namespace fur::app
