// How much a picture flickers while the camera moves.
#include "tests/render/Picture.h"

namespace fur::render {
namespace {

constexpr int kShimmerWidth = 320, kShimmerHeight = 240;

// The share of pixels that change by more than 20 of 255 between two frames half a pixel apart, the mean of some pairs: of the
// pixels in which the model is.
class Shimmer : public test::Scene {
 public:
  Shimmer() : Scene(kShimmerWidth, kShimmerHeight) {
    for (const auto& [name, value] : {std::pair("ground", "false"), {"breath", "0"}, {"dryRate", "0"}, {"layers", "16"}, {"backgroundTop", "#0000ff"}, {"backgroundBottom", "#0000ff"}})
      EXPECT_TRUE(app.setField(name, value)) << name;
  }
  float at(float rho, float distance) {
    app.setWetness(rho);
    app.settle();
    float changed = 0;
    int model = 0;
    for (int i = 0; i < kPairs; ++i) {
      const float yaw = 0.35f + 0.7f * static_cast<float>(i);
      app.setCamera({yaw, 0.28f, distance});
      const test::Picture one = draw();
      app.setCamera({yaw + halfPixel(distance), 0.28f, distance});
      const test::Picture two = draw();
      changed += one.differingShare(two, 20) * kShimmerWidth * kShimmerHeight;
      for (int y = 0; y < kShimmerHeight; ++y)
        for (int x = 0; x < kShimmerWidth; ++x) model += one.at(x, y)[0] > 0 || one.at(x, y)[2] < 250;
    }
    return changed / static_cast<float>(model);
  }

 private:
  static constexpr int kPairs = 4;
  // The angle about the middle of a model of radius 1 by which what is nearest to the eye moves by half a pixel.
  static float halfPixel(float distance) { return 0.5f * (distance - 1) / (kShimmerHeight / (2 * std::tan(0.3f))); }
};

// From near and from the page's own distance. From further off locks shimmer more than dry fur does: tests/bench/shimmer.mjs tells by how much.
TEST(Shimmer, OfWetFurIsNoMoreThanOfDryFur) {
  Shimmer shimmer;
  const auto mean = [&](float rho) { return (shimmer.at(rho, 2.2f) + shimmer.at(rho, 2.75f)) / 2; };
  const float dry = mean(0);
  EXPECT_GT(dry, 0.02f) << "the camera moves";
  for (const float rho : {0.5f, 0.8f, 1.0f}) EXPECT_LE(mean(rho), dry) << "wetness " << rho;
}

}  // namespace
}  // namespace fur::render
