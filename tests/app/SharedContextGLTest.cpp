// Apps that live side by side in one context and share what they have in common.
#include "tests/render/Picture.h"

namespace fur::app {
namespace {

constexpr int kFigureWidth = 160, kFigureHeight = 120;

struct Figure {
  explicit Figure(const char* model, const std::shared_ptr<ModelShelf>& models = nullptr) : app(models) {
    EXPECT_TRUE(app.loadPrimitive(model));
    for (const auto& [name, value] : {std::pair("layers", "8"), {"tileSize", "64"}, {"dryRate", "0"}, {"breath", "0"}}) app.setField(name, value);
    app.resize(kFigureWidth, kFigureHeight, 1);
  }
  ~Figure() { app.detach(false); }
  App app;
};

TEST(SharedContext, EachDrawsAsItWouldAlone) {
  test::Stage stage(kFigureWidth, kFigureHeight);
  const auto picture = [&](Figure& figure, const Context* context) {
    stage.attachTarget();
    EXPECT_TRUE(figure.app.attach(context));
    figure.app.settle();
    return stage.draw(figure.app);
  };
  const auto alone = [&](const char* model, float wetness) {
    Figure figure(model);
    figure.app.setWetness(wetness);
    return picture(figure, nullptr);
  };
  const test::Picture torus = alone("torus", 0), wet = alone("sphere", 0.5f);

  stage.attachTarget();
  const Context context;
  context.use();
  const auto models = makeModelShelf();
  Figure first("torus", models), second("sphere", models), third("torus", models);
  second.app.setWetness(0.5f);
  EXPECT_EQ(picture(first, &context).differingShare(torus, 0), 0);
  EXPECT_EQ(picture(second, &context).differingShare(wet, 0), 0);
  EXPECT_EQ(picture(third, &context).differingShare(torus, 0), 0);
  // The others notice nothing of one that changes, or goes.
  third.app.setField("density", "0.3");
  third.app.settle();
  EXPECT_GT(stage.draw(third.app).differingShare(torus, 8), 0.05f);
  EXPECT_EQ(stage.draw(first.app).differingShare(torus, 0), 0);
  third.app.detach(false);
  second.app.detach(false);
  EXPECT_EQ(stage.draw(first.app).differingShare(torus, 0), 0);
}

TEST(SharedContext, ACoatThatOneShowsIsThereForAllWhoAskForTheSame) {
  test::Stage stage(kFigureWidth, kFigureHeight);
  const Context context;
  context.use();
  Figure first("torus"), second("sphere");
  ASSERT_TRUE(first.app.attach(&context));
  first.app.settle();
  stage.draw(first.app);
  const std::size_t one = first.app.stats().gpuBytes;
  ASSERT_TRUE(second.app.attach(&context));
  EXPECT_LT(second.app.coatProgress(), 1);
  second.app.tick(0, 0);  // no time to grow one
  EXPECT_EQ(second.app.coatProgress(), 1);
  stage.draw(second.app);
  EXPECT_LT(first.app.stats().gpuBytes, one);
  // It stays while anyone shows it, who has all of it then.
  const std::size_t share = second.app.stats().gpuBytes;
  first.app.detach(false);
  EXPECT_GT(second.app.stats().gpuBytes, share);
  ASSERT_TRUE(first.app.attach(&context));
  first.app.tick(0, 0);
  EXPECT_EQ(first.app.coatProgress(), 1);
}

}  // namespace
}  // namespace fur::app
