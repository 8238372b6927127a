// Whiskers in the picture: a black one against a white sky, on top of a sphere that is nearly bare.
#include <algorithm>
#include <numeric>

#include "groom/Whiskers.h"
#include "render/passes/whisker/WhiskerPass.h"
#include "tests/render/Picture.h"

namespace fur::render {
namespace {

using test::Picture;
using test::Stage;

constexpr int kWhiskerSide = 300;
constexpr float kNear = 6;

struct WhiskerScene {
  Stage stage{kWhiskerSide, kWhiskerSide, 4};
  app::App app;
  WhiskerScene() {
    stage.attach(app);
    for (const auto& [name, value] :
         {std::pair("layers", "8"), std::pair("tileSize", "64"), std::pair("furLength", "0.02"), std::pair("ground", "false"),
          std::pair("backgroundTop", "#ffffff"), std::pair("backgroundBottom", "#ffffff"), std::pair("whiskerColor", "#000000"),
          std::pair("whiskerStiffness", "1"), std::pair("specular", "0"), std::pair("gravity", "0"), std::pair("ambient", "0")})
      EXPECT_TRUE(app.setField(name, value));
    look(kNear);
  }
  ~WhiskerScene() { app.detach(false); }

  // A pixel covers 2 distance tan(0.3) / 300 model units there.
  static float pixel(float distance) { return 2 * distance * std::tan(0.3f) / kWhiskerSide; }
  // Straight ahead, so that the sphere's top is the outline; `aside` in pixels.
  void look(float distance, float aside = 0) { app.setCamera({0, 0, distance, Vec3(aside * pixel(distance), 0, 0)}); }
  // The row in which a ball of that radius ends.
  static float topOf(float radius, float distance) {
    return kWhiskerSide / 2.0f - std::tan(std::asin(radius / distance)) * distance / pixel(distance);
  }
  // On the outline, straight up.
  void plant() {
    const float top = topOf(0.986f, kNear);  // where the fur stands whose roots are at 0.97
    app.setTool(app::Tool::Whisker);
    app::PointerEvent event{app::PointerPhase::Down};
    event.position = Vec2(kWhiskerSide / 2.0f, top);
    event.buttons = 1;
    app.pointer(event);
    event.phase = app::PointerPhase::Move;
    event.position.y = -40;
    app.pointer(event);
    event.phase = app::PointerPhase::Up;
    app.pointer(event);
    ASSERT_EQ(app.whiskerCount(), 1u);
  }
  Picture draw() {
    app.settle();
    app.tick(0);
    return stage.draw(app);
  }
  // How many pixels of each row above the coat are dark: the width of the whisker, as far as it leans not.
  std::vector<float> widths(float distance) {
    const Picture p = draw();
    const int end = static_cast<int>(topOf(1.06f, distance));
    std::vector<float> out;
    for (int y = 0; y < end; ++y) {
      float dark = 0;
      for (int x = 0; x < kWhiskerSide; ++x) dark += static_cast<float>(std::max(254 - p.at(x, y)[1], 0)) / 254;
      out.push_back(dark);
    }
    return out;
  }
  float darkness(float distance) {
    const auto rows = widths(distance);
    return std::accumulate(rows.begin(), rows.end(), 0.0f);
  }
};

TEST(Whiskers, OneShowsBeyondTheCoatsOutlineAndUndoTakesItAway) {
  WhiskerScene scene;
  EXPECT_EQ(scene.darkness(kNear), 0);
  const Picture bare = scene.draw();
  scene.plant();
  EXPECT_GT(scene.darkness(kNear), 5);
  EXPECT_TRUE(scene.app.undo());
  EXPECT_EQ(scene.draw().differingShare(bare, 0), 0);
  EXPECT_TRUE(scene.app.redo());
  EXPECT_GT(scene.darkness(kNear), 5);
}

TEST(Whiskers, CostNothingWhereThereAreNone) {
  WhiskerScene scene;
  scene.draw();
  const auto before = scene.app.stats();
  scene.plant();
  scene.draw();
  EXPECT_EQ(scene.app.stats().gpuBytes, before.gpuBytes + sizeof(groom::WhiskerHair));
  EXPECT_TRUE(scene.app.undo());
  scene.draw();
  EXPECT_EQ(scene.app.stats().gpuBytes, before.gpuBytes);
  Programs programs;
  const Frame frame;
  const Look look(frame, true, false);
  const SurfaceBuffers none;
  const Materials materials;
  std::size_t uploadedBytes = 0;
  EXPECT_TRUE(WhiskerPass().draw({frame, look, none, materials, WetCells(), programs, uploadedBytes})) << "and nothing is compiled, with no context's help";
}

TEST(Whiskers, TaperAndAreAsWideAsTheDistanceHasThem) {
  WhiskerScene scene;
  scene.app.setField("whiskerWidth", "0.02");
  scene.app.setField("whiskerLength", "0.8");
  scene.plant();
  // The mean width of the rows between two balls, pixels.
  const auto width = [&](float distance, float from, float to) {
    scene.look(distance);
    const std::vector<float> rows = scene.widths(distance);
    const auto first = rows.begin() + static_cast<int>(WhiskerScene::topOf(to, distance)), last = rows.begin() + static_cast<int>(WhiskerScene::topOf(from, distance));
    return std::accumulate(first, last, 0.0f) / static_cast<float>(last - first);
  };
  const float foot = width(kNear, 1.08f, 1.33f), tip = width(kNear, 1.33f, 1.58f), far = width(2 * kNear, 1.08f, 1.33f);
  // A quarter along and a bit more than half along it is as much narrower than 0.02 units.
  EXPECT_NEAR(foot, 0.75f * 0.02f / WhiskerScene::pixel(kNear), 0.3f);
  EXPECT_NEAR(tip / foot, 0.55f, 0.2f);
  // Four samples a pixel, chance, and ten rows far off.
  EXPECT_NEAR(foot / far, 2, 0.4f);
}

TEST(Whiskers, ThinnerThanAPixelTheyFadeInsteadOfBreakingUp) {
  WhiskerScene scene;
  scene.app.setField("whiskerWidth", "0.02");
  scene.app.setField("whiskerLength", "1.2");
  scene.plant();
  scene.look(12);
  const float wide = scene.darkness(12);
  EXPECT_TRUE(scene.app.undo());
  // From a pixel and a tenth of its width to a third of a pixel.
  scene.app.setField("whiskerWidth", "0.006");
  scene.look(kNear);
  scene.plant();
  scene.look(12);
  EXPECT_NEAR(scene.darkness(12) / wide, 0.3f, 0.1f);
  // Wherever it falls among the pixels, about as much of it is seen.
  float least = 1e9f, most = 0;
  for (int i = 0; i < 12; ++i) {
    scene.look(12, static_cast<float>(i) / 6);
    const float dark = scene.darkness(12);
    least = std::min(least, dark);
    most = std::max(most, dark);
  }
  EXPECT_GT(least, 0.65f * most);
}

TEST(Whiskers, AreHiddenBehindTheBody) {
  WhiskerScene scene;
  const Picture bare = scene.draw();
  app::PointerEvent event{app::PointerPhase::Down};
  event.position = Vec2(kWhiskerSide / 2.0f);
  event.buttons = 1;
  scene.app.setCamera({kPi, 0, kNear, Vec3(0)});
  scene.app.setTool(app::Tool::Whisker);
  scene.app.pointer(event);
  event.phase = app::PointerPhase::Up;
  scene.app.pointer(event);
  EXPECT_EQ(scene.app.whiskerCount(), 1u);
  scene.look(kNear);
  EXPECT_EQ(scene.draw().differingShare(bare, 0), 0);
}

TEST(Whiskers, LeanWithTheWind) {
  WhiskerScene scene;
  scene.app.setField("whiskerStiffness", "0");
  scene.plant();
  scene.app.setField("gust", "0");
  scene.app.setField("windYaw", "1.5708");
  const auto centre = [&] {
    const Picture p = scene.draw();
    float sum = 0, weight = 0;
    for (int y = 0; y < static_cast<int>(WhiskerScene::topOf(1.06f, kNear)); ++y)
      for (int x = 0; x < kWhiskerSide; ++x) {
        const auto dark = static_cast<float>(std::max(254 - p.at(x, y)[1], 0));
        sum += static_cast<float>(x) * dark;
        weight += dark;
      }
    return sum / weight;
  };
  const float still = centre();
  scene.app.setField("wind", "1");
  // The tip goes by some nine pixels, the middle of what is seen by half of that.
  EXPECT_GT(centre(), still + 3);
}

}  // namespace
}  // namespace fur::render
