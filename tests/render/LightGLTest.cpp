// Light in whole pictures: what shines, and what lies in shadow.
#include "tests/render/Picture.h"

namespace fur::render {
namespace {

// A torus, whose ring shades itself, without ground.
struct Scene {
  test::Stage stage{240, 180, 4};
  app::App app;

  Scene() {
    stage.attach(app);
    EXPECT_TRUE(app.loadPrimitive("torus"));
    for (const auto& [field, value] : {std::pair("ground", "false"), std::pair("furLength", "0.06"),
                                       std::pair("ambient", "0.1"), std::pair("layers", "16")})
      EXPECT_TRUE(app.setField(field, value));
    app.setCamera({0.4f, 0.3f, 3.2f});
    app.settle();
  }
  ~Scene() { app.detach(false); }
  test::Picture with(std::initializer_list<std::pair<const char*, const char*>> fields) {
    for (const auto& [field, value] : fields) EXPECT_TRUE(app.setField(field, value));
    app.settle();
    return stage.draw(app);
  }
};

TEST(Light, FurInShadowIsDarkerByEitherMap) {
  Scene scene;
  const auto none = scene.with({{"lightYaw", "1.6"}, {"lightPitch", "0.3"}, {"shadows", "none"}});
  const auto depth = scene.with({{"shadows", "depth"}}), layers = scene.with({{"shadows", "layers"}});
  // Of the whole picture, in most of which nothing lies in shadow.
  EXPECT_LT(depth.brightness(), none.brightness() - 0.4f);
  EXPECT_LT(layers.brightness(), none.brightness() - 0.4f);
  // Two ways to the same shadow.
  EXPECT_NEAR(depth.brightness(), layers.brightness(), 6);
}

TEST(Light, ShadowsDoNotSwimWhenNothingMoves) {
  Scene scene;
  for (const char* shadows : {"depth", "layers"}) {
    const auto first = scene.with({{"shadows", shadows}});
    EXPECT_EQ(first.differingShare(scene.stage.draw(scene.app), 0), 0) << shadows;
  }
}

TEST(Light, ASmallTurnOfTheLightChangesTheShadowLittle) {
  Scene scene;
  for (const char* shadows : {"depth", "layers"}) {
    const auto before = scene.with({{"shadows", shadows}, {"lightYaw", "1.6"}, {"lightPitch", "0.5"}});
    // A tenth of a degree moves no edge by half a pixel.
    EXPECT_LT(before.differingShare(scene.with({{"lightYaw", "1.602"}}), 12), 0.004f) << shadows;
  }
}

TEST(Light, FromBehindShinesThroughTheEdgeInBothModels) {
  Scene scene;
  for (const char* model : {"kajiya", "marschner"}) {
    scene.app.setField("strandModel", model);
    const auto glowing = scene.with({{"lightYaw", "-2.74"}, {"lightPitch", "0.35"}, {"specular", "1"}});
    const auto unlit = scene.with({{"lightIntensity", "0"}});
    scene.app.setField("lightIntensity", "1");
    EXPECT_GT(glowing.differingShare(unlit, 40), 0.01f) << model;
  }
}

TEST(Light, TheModelsOfAStrandDiffer) {
  Scene scene;
  const auto kajiya = scene.with({{"strandModel", "kajiya"}});
  EXPECT_GT(kajiya.differingShare(scene.with({{"strandModel", "marschner"}}), 8), 0.02f);
}

}  // namespace
}  // namespace fur::render
