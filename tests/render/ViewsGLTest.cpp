// What each view shows beside the picture: on the sphere, whose outline and layers are known.
#include <cmath>

#include "render/Blocks.h"
#include "settings/Presets.h"
#include "tests/render/Picture.h"

namespace fur::render {
namespace {

using test::Picture;
using test::Scene;

// The sphere in the middle, from the equator; a coat that is quick to grow.
struct Study : Scene {
  explicit Study(int samples = 4, int side = 200) : Scene(side, side, samples) {
    app.setCamera({0.0f, 0.0f, 4.0f});
    for (const auto& [name, value] : {std::pair("ground", "false"), std::pair("layers", "16"),
                                      std::pair("tileSize", "64"), std::pair("gravity", "0")})
      app.setField(name, value);
    app.settle();
  }
  Picture view(const char* name) { return with("view", name); }
};

// From the middle of the picture, as a share of the bare sphere's radius: its outline is seen under
// asin(1 / 4), and half of the picture is tan(0.3) high.
float radiusAt(const Picture& p, int x, int y) {
  const float outline = std::tan(std::asin(0.25f)) / std::tan(0.3f) * 0.5f * static_cast<float>(p.height);
  return std::hypot(static_cast<float>(x) + 0.5f - 0.5f * static_cast<float>(p.width),
                    static_cast<float>(y) + 0.5f - 0.5f * static_cast<float>(p.height)) / outline;
}
// Mean of a channel over a ring of the sphere.
float ringMean(const Picture& p, float from, float to, int channel) {
  double sum = 0, count = 0;
  for (int y = 0; y < p.height; ++y)
    for (int x = 0; x < p.width; ++x)
      if (const float r = radiusAt(p, x, y); r >= from && r < to) sum += p.at(x, y)[channel], ++count;
  return static_cast<float>(sum / count);
}
// How far out any pixel differs from the background, which is one colour along a row.
float reach(const Picture& p) {
  float most = 0;
  for (int y = 0; y < p.height; ++y)
    for (int x = 0; x < p.width; ++x)
      for (int k = 0; k < 3; ++k)
        if (std::abs(p.at(x, y)[k] - p.at(p.width - 1, y)[k]) > 12) most = std::max(most, radiusAt(p, x, y));
  return most;
}
bool isColoured(const std::uint8_t* pixel) {
  return std::max({pixel[0], pixel[1], pixel[2]}) - std::min({pixel[0], pixel[1], pixel[2]}) > 60;
}

TEST(Views, EachDrawsSomethingOfItsOwn) {
  Study scene;
  // Its parts' rims have fins; the sphere has none.
  ASSERT_TRUE(scene.app.loadModel(test::planeInParts(), "parts.glb"));
  scene.app.setCamera({0.4f, 0.7f, 3.0f});
  scene.app.setWetness(0.5f);
  std::vector<Picture> pictures;
  const settings::Field& views = *settings::findField("view");
  for (int i = 0; !settings::optionName(views, i).empty(); ++i) {
    const std::string name(settings::optionName(views, i));
    pictures.push_back(scene.view(name.c_str()));
    for (int k = 0; k < i; ++k)
      EXPECT_GT(pictures[k].differingShare(pictures.back(), 2), 0.005f)
          << name << " looks like " << settings::optionName(views, k);
  }
}

TEST(Views, TheLayoutHasAHueAChartAndDarkBorders) {
  Study scene;
  const Picture one = scene.view("layout");
  // A mean colour says nothing of hues; how many pixels are nearly black does.
  int dark = 0, coloured = 0;
  for (int y = 0; y < one.height; ++y)
    for (int x = 0; x < one.width; ++x) {
      if (radiusAt(one, x, y) > 0.9f) continue;
      const std::uint8_t* pixel = one.at(x, y);
      dark += std::max({pixel[0], pixel[1], pixel[2]}) < 26;
      coloured += isColoured(pixel);
    }
  EXPECT_GT(dark, 20);
  EXPECT_GT(coloured, 20 * dark) << "thin lines";
}

TEST(Views, LeaveThePictureAsItWas) {
  Study scene;
  const Picture before = scene.draw();
  const settings::Field& views = *settings::findField("view");
  for (int i = 0; !settings::optionName(views, i).empty(); ++i) {
    const std::string name(settings::optionName(views, i));
    scene.view(name.c_str());
    EXPECT_EQ(before.differingShare(scene.view("final"), 0), 0) << "after " << name;
  }
}

TEST(Views, AHighLayerHasFewerStrandsThanALowOneWithAndWithoutMultisampling) {
  for (const int samples : {4, 0}) {
    Study scene(samples);
    scene.app.setField("view", "layer");
    // Without strands what is below: the dim skin.
    scene.app.setField("density", "0");
    scene.app.settle();
    const Picture bald = scene.draw();
    scene.app.setField("density", "0.85");
    const auto covered = [&](const char* height) {
      const Picture layer = scene.with("viewLayer", height);
      int count = 0;
      for (int y = 0; y < layer.height; ++y)
        for (int x = 0; x < layer.width; ++x)
          count += radiusAt(layer, x, y) < 0.9f && std::abs(layer.at(x, y)[0] - bald.at(x, y)[0]) > 8;
      return count;
    };
    const int low = covered("0"), middle = covered("0.5"), high = covered("1");
    EXPECT_GT(low, middle) << samples;
    EXPECT_GT(middle, 2 * high) << samples;
    EXPECT_GT(high, 0) << samples;
  }
}

TEST(Views, ALayerStandsWhereItIsInTheCoat) {
  Study scene;
  scene.app.setField("view", "layer");
  const float low = reach(scene.with("viewLayer", "0.1")), half = reach(scene.with("viewLayer", "0.5"));
  // Fur of 0.12, seen over the outline of a sphere of 1.
  EXPECT_NEAR(low, 1.012f, 0.03f);
  EXPECT_NEAR(half, 1.06f, 0.03f);
  scene.app.groomAll(app::GroomEdit::Length, 0.5f);
  scene.app.settle();
  scene.app.tick(0);
  EXPECT_NEAR(reach(scene.draw()), 1.03f, 0.02f) << "of a coat of half the length";
  scene.app.groomAll(app::GroomEdit::Length, 0);
  scene.app.tick(0);
  EXPECT_NEAR(reach(scene.draw()), 1.0f, 0.015f) << "of none";
}

TEST(Views, ALayerIsCombedWithTheCoat) {
  Study scene;
  scene.app.setField("view", "exploded");
  const Picture exploded = scene.draw(), layer = scene.view("layer");
  scene.app.groomAll(app::GroomEdit::Comb, 1, Vec3(0, -1, 0));
  scene.app.settle();
  scene.app.tick(0);
  EXPECT_GT(scene.draw().differingShare(layer, 16), 0.05f);
  EXPECT_GT(scene.view("exploded").differingShare(exploded, 16), 0.05f);
}

TEST(Views, ALayerOfWetFurHasGapsBetweenLocksAndBendsAside) {
  Study scene;
  scene.app.setField("view", "layer");
  const Picture dry = scene.draw();
  scene.app.setField("wind", "1");
  scene.app.setField("gust", "0");
  for (int i = 0; i < 60; ++i) scene.app.tick(1.0f / 60);
  EXPECT_GT(scene.draw().differingShare(dry, 16), 0.05f);
  scene.app.setField("wind", "0");
  scene.app.setField("density", "0");
  scene.app.settle();
  const Picture bald = scene.draw();
  scene.app.setField("density", "0.85");
  scene.app.setWetness(0.8f);
  scene.app.settle();
  EXPECT_LT(scene.draw().differingShare(bald, 8), 0.7f * dry.differingShare(bald, 8));
}

TEST(Views, ExplodedShellsStandFurtherOutThanTheCoat) {
  Study scene;
  const float coat = reach(scene.view("final")), exploded = reach(scene.view("exploded"));
  EXPECT_GT(exploded, coat + 0.2f);
  // Peeled from the right: nothing stands over the skin there.
  const Picture picture = scene.draw();
  int right = 0;
  for (int y = 0; y < picture.height; ++y)
    for (int x = picture.width / 2; x < picture.width; ++x)
      if (radiusAt(picture, x, y) > 0.9f && static_cast<float>(x) > 0.92f * static_cast<float>(picture.width))
        right += isColoured(picture.at(x, y));
  EXPECT_EQ(right, 0);
  EXPECT_NEAR(reach(scene.with("density", "0")), 1.0f, 0.015f) << "a bald model is its skin";
}

TEST(Views, SilhouetteEdgesRunAllRoundTheOutlineAndNowhereElse) {
  Study scene;
  const Picture lines = scene.view("silhouette");
  std::array<bool, 36> seen{};
  for (int y = 0; y < lines.height; ++y)
    for (int x = 0; x < lines.width; ++x) {
      if (!isColoured(lines.at(x, y))) continue;
      // (n1.v)(n2.v) < 0.06 is 76 degrees and more off, and a line is 0.01 wide.
      EXPECT_NEAR(radiusAt(lines, x, y), 1.0f, 0.06f) << x << ", " << y;
      const float turn = std::atan2(static_cast<float>(y) - 99.5f, static_cast<float>(x) - 99.5f) / 6.2832f + 0.5f;
      seen[std::min<std::size_t>(static_cast<std::size_t>(turn * 36), 35)] = true;
    }
  EXPECT_EQ(std::count(seen.begin(), seen.end(), true), 36);
  scene.app.groomAll(app::GroomEdit::Length, 0);
  scene.app.tick(0);
  const Picture bald = scene.draw();
  for (int y = 0; y < bald.height; ++y)
    for (int x = 0; x < bald.width; ++x) ASSERT_FALSE(isColoured(bald.at(x, y))) << "where no fur is, no fin stands";
}

TEST(Views, OverdrawCountsTheSkinOfABaldModelOnce) {
  for (const int samples : {4, 0}) {
    Study scene(samples);
    scene.app.setField("density", "0");
    const Picture counts = scene.view("overdraw");
    const std::uint8_t* once = counts.at(100, 100);
    EXPECT_NEAR(once[0], 85, 1);  // a third, a ninth, a twenty-seventh of 255
    EXPECT_NEAR(once[1], 28, 1);
    EXPECT_NEAR(once[2], 9, 1);
    EXPECT_EQ(counts.at(2, 2)[0], 0) << "nothing is counted beside the model";
    int others = 0;
    for (int y = 0; y < counts.height; ++y)
      for (int x = 0; x < counts.width; ++x) others += radiusAt(counts, x, y) < 0.97f && counts.at(x, y)[0] != once[0];
    EXPECT_EQ(others, 0);
  }
}

TEST(Views, OverdrawCountsFinsOverShells) {
  Study scene;
  ASSERT_TRUE(scene.app.loadModel(test::planeInParts(), "parts.glb"));
  scene.app.setCamera({0.4f, 0.7f, 3.0f});
  const Picture with = scene.view("overdraw"), without = scene.with("fins", "false");
  EXPECT_GT(with.brightness(), 1.03f * without.brightness());
  EXPECT_EQ(with.at(100, 100)[0], without.at(100, 100)[0]) << "but not where none stands";
}

TEST(Views, FinsFadeWhereTheCoatIsAFewPixelsHighAndAreGoneWhereItIsLess) {
  Study scene;
  ASSERT_TRUE(scene.app.loadModel(test::planeInParts(), "parts.glb"));
  const auto shown = [&](float pixels) {
    // The plane's rim is 3 or more away; half of the picture's 200 pixels are tan(0.3) high there.
    scene.app.setCamera({0.4f, 0.7f, 3.0f});
    scene.app.setField("furLength", std::to_string(pixels * 3 * std::tan(0.3f) / 100));
    scene.app.settle();
    return scene.view("fins").differingShare(scene.with("fins", "false"), 8);
  };
  EXPECT_GT(shown(12), 0.002f);
  EXPECT_EQ(shown(0.6f * static_cast<float>(FUR_FIN_PIXELS)), 0);
}

TEST(Views, RaysThatGrazeTheCoatTakeMoreStepsAndBaldSkinTakesNone) {
  // So large that steps follow the texels: far off every ray takes the fewest.
  Study scene(4, 400);
  const Picture steps = scene.view("steps");
  EXPECT_GT(ringMean(steps, 0.9f, 1.0f, 1), 1.3f * ringMean(steps, 0, 0.5f, 1));
  EXPECT_EQ(scene.with("density", "0").brightness(), 0);
}

// What the march costs at most, over all coats: the heat of `steps` shows 135 before it saturates.
TEST(Views, NoPixelOfAnyCoatTakesMoreStepsThanOneFragmentMay) {
  Scene scene(120, 90, 0);
  for (const auto& [name, value] : {std::pair("view", "steps"), std::pair("ground", "false"), std::pair("dryRate", "0"),
                                    std::pair("backgroundTop", "#000000"), std::pair("backgroundBottom", "#000000")})
    scene.app.setField(name, value);
  for (const settings::Preset& preset : settings::presets()) {
    ASSERT_TRUE(scene.app.applyPreset(preset.name));
    for (const float wetness : {0.0f, 0.6f, 1.0f}) {
      scene.app.setWetness(wetness);
      scene.app.settle();
      for (const float distance : {1.05f, 1.6f, 4.0f, 12.0f}) {
        scene.app.setCamera({0.6f, 0.2f, distance});
        const Picture steps = scene.draw();
        int most = 0;
        for (std::size_t i = 2; i < steps.rgba.size(); i += 4) most = std::max<int>(most, steps.rgba[i]);
        // Under a whole sheet nothing is marched for, and from inside the coat its outside is not seen.
        if (wetness == 0 && distance > 1.5f) EXPECT_GT(most, 0) << preset.name;
        constexpr float kStep = 135.0f / 255.0f;  // a byte of heat, which is rounded
        EXPECT_LE((static_cast<float>(most) - 0.5f) * kStep, FUR_MOST_STEPS)
            << preset.name << ", wetness " << wetness << ", from " << distance;
      }
    }
  }
}

TEST(Views, AClumpHasOneColourAndItsNeighbourAnother) {
  Study scene;
  ASSERT_TRUE(scene.app.splashPixel({70, 100}, 0.1f, 0.6f));
  ASSERT_TRUE(scene.app.splashPixel({130, 100}, 0.1f, 0.6f));
  scene.app.settle();
  // The heart of the clump: its colour, brighter and darker with height.
  const auto hue = [](const Picture& p, int x, int y) {
    const std::uint8_t* c = p.at(x, y);
    const Vec3 colour(c[0], c[1], c[2]);
    return colour / std::max(glm::length(colour), 1.0f);
  };
  const Picture clumps = scene.view("clumps");
  const Vec3 left = hue(clumps, 70, 100), right = hue(clumps, 130, 100);
  EXPECT_GT(glm::length(left - right), 0.2f);
  for (int d = -2; d <= 2; ++d) {
    // A ray may meet strands of the clump at several heights: rounding is all that is left.
    EXPECT_LT(glm::length(hue(clumps, 70 + d, 100) - left), 0.03f);
    EXPECT_LT(glm::length(hue(clumps, 130, 100 + d) - right), 0.03f);
  }
  EXPECT_FALSE(isColoured(clumps.at(100, 60))) << "what is dry is grey";
  const Picture bald = scene.with("density", "0");
  EXPECT_LT(glm::length(hue(bald, 70, 100) - left), 0.03f) << "on bare skin the same";
}

TEST(Views, ShadowIsGreyBrighterTowardsTheLightAndKnowsNoColour) {
  Study scene;
  // A coarse coat, in which one sees deep enough for strands to stand above.
  for (const auto& [name, value] : {std::pair("lightYaw", "-1.57"), std::pair("lightPitch", "0.2"),
                                    std::pair("view", "shadow"), std::pair("thickness", "0.35"), std::pair("repeat", "4"), std::pair("undercoat", "0")})
    scene.app.setField(name, value);
  scene.app.settle();
  const Picture shadow = scene.draw();
  double left = 0, right = 0;
  for (int y = 60; y < 140; ++y)
    for (int x = 40; x < 160; ++x) {
      const std::uint8_t* c = shadow.at(x, y);
      ASSERT_TRUE(c[0] == c[1] && c[1] == c[2]) << x << ", " << y;
      (x < 100 ? left : right) += c[0];
    }
  EXPECT_GT(left, 2 * right);
  EXPECT_EQ(shadow.differingShare(scene.with("tipColor", "#ff0000"), 0), 0);
  EXPECT_EQ(shadow.differingShare(scene.with("lightIntensity", "2"), 0), 0);
  const double without = scene.with("strandShadow", "0").brightness();
  EXPECT_GT(without, scene.with("strandShadow", "1").brightness() + 2);
}

}  // namespace
}  // namespace fur::render
