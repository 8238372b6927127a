// Light in whole pictures: what shines, and what lies in shadow.
#include "tests/render/Picture.h"

namespace fur::render {
namespace {

// A torus, whose ring shades itself, without ground.
struct LightScene {
  test::Stage stage{240, 180, 4};
  app::App app;

  LightScene() {
    stage.attach(app);
    EXPECT_TRUE(app.loadPrimitive("torus"));
    for (const auto& [field, value] : {std::pair("ground", "false"), std::pair("furLength", "0.06"),
                                       std::pair("ambient", "0.1"), std::pair("layers", "16")})
      EXPECT_TRUE(app.setField(field, value));
    app.setCamera({0.4f, 0.3f, 3.2f});
    app.settle();
  }
  ~LightScene() { app.detach(false); }
  test::Picture with(std::initializer_list<std::pair<const char*, const char*>> fields) {
    for (const auto& [field, value] : fields) EXPECT_TRUE(app.setField(field, value));
    app.settle();
    return stage.draw(app);
  }
};

TEST(Light, FurInShadowIsDarkerByEitherMap) {
  LightScene scene;
  const auto none = scene.with({{"lightYaw", "1.6"}, {"lightPitch", "0.3"}, {"shadows", "none"}});
  const auto depth = scene.with({{"shadows", "depth"}}), layers = scene.with({{"shadows", "layers"}});
  // Of the whole picture, in most of which nothing lies in shadow.
  EXPECT_LT(depth.brightness(), none.brightness() - 0.4f);
  EXPECT_LT(layers.brightness(), none.brightness() - 0.4f);
  // Two ways to the same shadow.
  EXPECT_NEAR(depth.brightness(), layers.brightness(), 6);
}

TEST(Light, ShadowsDoNotSwimWhenNothingMoves) {
  LightScene scene;
  for (const char* shadows : {"depth", "layers"}) {
    const auto first = scene.with({{"shadows", shadows}});
    EXPECT_EQ(first.differingShare(scene.stage.draw(scene.app), 0), 0) << shadows;
  }
}

TEST(Light, ASmallTurnOfTheLightChangesTheShadowLittle) {
  LightScene scene;
  for (const char* shadows : {"depth", "layers"}) {
    const auto before = scene.with({{"shadows", shadows}, {"lightYaw", "1.6"}, {"lightPitch", "0.5"}});
    // A tenth of a degree moves no edge by half a pixel.
    EXPECT_LT(before.differingShare(scene.with({{"lightYaw", "1.602"}}), 12), 0.004f) << shadows;
  }
}

TEST(Light, FromBehindShinesThroughTheEdgeInBothModels) {
  LightScene scene;
  for (const char* model : {"kajiya", "marschner"}) {
    scene.app.setField("strandModel", model);
    const auto glowing = scene.with({{"lightYaw", "-2.74"}, {"lightPitch", "0.35"}, {"specular", "1"}});
    const auto unlit = scene.with({{"lightIntensity", "0"}});
    scene.app.setField("lightIntensity", "1");
    EXPECT_GT(glowing.differingShare(unlit, 40), 0.01f) << model;
  }
}

// A furry sphere before black: mean brightness within `radius` of its middle, and in a band round its outline.
struct LitBall {
  static constexpr int kSide = 160;
  test::Room room{kSide, {{"ground", "false"}, {"furLength", "0.08"}, {"layers", "16"}, {"backgroundTop", "#000000"}, {"backgroundBottom", "#000000"}}};

  LitBall() { room.app.setCamera({0, 0, 4.2f}); }
  test::Picture with(std::initializer_list<std::pair<const char*, const char*>> fields) {
    for (const auto& [field, value] : fields) EXPECT_TRUE(room.app.setField(field, value)) << field;
    return room.settled();
  }
  // Of the pixels so far from the middle, by channel.
  static Vec3 mean(const test::Picture& picture, float from, float to) {
    Vec3 sum(0);
    int count = 0;
    for (int y = 0; y < kSide; ++y)
      for (int x = 0; x < kSide; ++x) {
        const float off = glm::length(Vec2(x, y) - 0.5f * (kSide - 1));
        if (off < from || off >= to) continue;
        const std::uint8_t* pixel = picture.at(x, y);
        sum += Vec3(pixel[0], pixel[1], pixel[2]);
        ++count;
      }
    return sum / static_cast<float>(count);
  }
  static float brightness(const Vec3& color) { return (color.x + color.y + color.z) / 3; }
};
// Pixels from the middle of the picture to the outline of the coat.
constexpr float kFront = 25, kEdgeFrom = 58, kEdgeTo = 68;

TEST(Light, TheRimLightBrightensTheOutlineAndNotTheFront) {
  LitBall ball;
  for (const char* model : {"kajiya", "marschner"})
    for (const char* wet : {"dry", "soaked"}) {
      ball.room.app.setWetness(*wet == 's' ? 1.0f : 0.0f);
      const auto before = ball.with({{"strandModel", model}, {"rimLight", "0"}}), after = ball.with({{"rimLight", "2"}});
      const auto gain = [&](float from, float to) {
        return LitBall::brightness(LitBall::mean(after, from, to)) - LitBall::brightness(LitBall::mean(before, from, to));
      };
      EXPECT_GT(gain(kEdgeFrom, kEdgeTo), 12) << model << ", " << wet;
      EXPECT_LT(gain(0, kFront), 2) << model << ", " << wet;
      // Nothing shines where there is no fur.
      EXPECT_NEAR(gain(76, 80), 0, 0.1f) << model << ", " << wet;
    }
}

TEST(Light, TheRimLightIsBehindTheModelWhereverTheEyeIs) {
  LitBall ball;
  for (const float yaw : {0.0f, 2.0f, 4.0f}) {
    ball.room.app.setCamera({yaw, 0.4f, 4.2f});
    const auto before = ball.with({{"rimLight", "0"}}), after = ball.with({{"rimLight", "2"}});
    EXPECT_GT(LitBall::brightness(LitBall::mean(after, kEdgeFrom, kEdgeTo)), LitBall::brightness(LitBall::mean(before, kEdgeFrom, kEdgeTo)) + 12) << yaw;
  }
}

TEST(Light, EachLightHasItsColour) {
  LitBall ball;
  const auto redness = [](const Vec3& color) { return color.x / std::max(color.x + color.y + color.z, 1e-3f); };
  const auto white = ball.with({{"rootColor", "#808080"}, {"tipColor", "#b0b0b0"}});
  for (const auto& [field, ambient, key] : {std::tuple("keyColor", "0", "1"), std::tuple("skyColor", "2", "0"), std::tuple("groundColor", "2", "0")}) {
    const auto red = ball.with({{field, "#ff4020"}, {"ambient", ambient}, {"lightIntensity", key}});
    EXPECT_GT(redness(LitBall::mean(red, 0, kEdgeTo)), redness(LitBall::mean(white, 0, kEdgeTo)) + 0.03f) << field;
    ball.room.app.setField(field, "#ffffff");
  }
  ball.with({{"ambient", "0.3"}, {"lightIntensity", "1"}});
  const auto rim = ball.with({{"rimLight", "2"}, {"rimColor", "#ff4020"}});
  EXPECT_GT(redness(LitBall::mean(rim, kEdgeFrom, kEdgeTo)), redness(LitBall::mean(white, kEdgeFrom, kEdgeTo)) + 0.03f);
}

TEST(Light, TheFillLightComesFromTheEyeAndReachesTheDarkSide) {
  LitBall ball;
  const auto before = ball.with({{"lightYaw", "3.1"}, {"lightPitch", "0.1"}, {"ambient", "0.05"}}), after = ball.with({{"fillLight", "1"}});
  const float front = LitBall::brightness(LitBall::mean(after, 0, kFront)) - LitBall::brightness(LitBall::mean(before, 0, kFront));
  EXPECT_GT(front, 20);
}

TEST(Light, ThatFollowsTheCameraLightsWhatIsSeenAlike) {
  LitBall ball;
  const auto sides = [&](float yaw) {
    ball.room.app.setCamera({yaw, 0, 4.2f});
    const auto picture = ball.room.settled();
    double left = 0, right = 0;
    for (int y = 0; y < LitBall::kSide; ++y)
      for (int x = 0; x < LitBall::kSide; ++x) (x < LitBall::kSide / 2 ? left : right) += picture.at(x, y)[1];
    return left / right;
  };
  for (const auto& [field, value] : {std::pair("lightYaw", "-1.2"), std::pair("lightPitch", "0.3")}) ball.room.app.setField(field, value);
  const double still = sides(0);
  EXPECT_GT(still, 1.3);
  EXPECT_LT(sides(2.4f), 0.8) << "the light stays where it is";
  ball.room.app.setField("lightFollowsCamera", "true");
  EXPECT_NEAR(sides(0) / still, 1, 0.03);
  EXPECT_NEAR(sides(2.4f) / still, 1, 0.15) << "but for the coat, which is another there";
}

TEST(Light, TheModelsOfAStrandDiffer) {
  LightScene scene;
  const auto kajiya = scene.with({{"strandModel", "kajiya"}});
  EXPECT_GT(kajiya.differingShare(scene.with({{"strandModel", "marschner"}}), 8), 0.02f);
}

}  // namespace
}  // namespace fur::render
