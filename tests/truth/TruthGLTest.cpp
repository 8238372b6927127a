// The reference and the real-time picture are of the same strands, the same camera and the same light.
#include "app/LongHair.h"
#include "render/Blocks.h"
#include "render/Hair.h"
#include "tests/render/Picture.h"
#include "truth/Flip.h"
#include "truth/Truth.h"

namespace fur::truth {
namespace {

[[maybe_unused]] const bool growsHair = (app::growLongHair(), true);

constexpr int kWidth = 240, kHeight = 200;

struct Desk {
  test::Stage stage{kWidth, kHeight, 4};
  app::App app;
  Desk() {
    stage.attach(app);
    app.setField("ground", "false");
    app.setField("layers", "64");
    app.setField("repeat", "2");  // a quarter of the strands, twice as thick
    // From near by and from the light's side, so that single strands can be told.
    app.setCamera({-0.75f, 0.4f, 1.5f, Vec3(0)});
    app.settle();
  }
  ~Desk() { app.detach(false); }

  Picture realTime() {
    const test::Picture drawn = stage.draw(app);
    Picture out{kWidth, kHeight, {}};
    for (std::size_t i = 0; i < drawn.rgba.size(); i += 4)
      out.pixels.push_back(Vec3(drawn.rgba[i], drawn.rgba[i + 1], drawn.rgba[i + 2]) / 255.0f);
    return out;
  }
  Picture reference(bool wet = false) {
    const furgen::Coat& coat = *app.grownCoat();
    const wet::MaskTexels mask = app.shownMask();
    const render::Frame frame = app.frame();
    Options options;
    options.samples = 4;
    options.shadowTexels = 1024;
    std::vector<LongHair> hair;
    if (app.haired()) {
      const render::HairGrowth growth = app.hairGrowth(0);
      hair.push_back({growth.wisps, growth.members, app.hairNodes(0), growth.nodes, growth.values, growth.ambient, frame.settings.hairOcclusion});
    }
    return render({app.surface(), coat, app.bends(), render::frameBlock(frame),
                   render::furBlock(frame, {.size = coat.parameters.size, .layers = 64}, {densestSection(coat)}, 1), dynamics::BendCurve::Arc, hair, wet ? &mask : nullptr},
                  kWidth, kHeight, options);
  }
};

Vec3 meanOf(const Picture& p) {
  Vec3 sum(0);
  for (const Vec3& pixel : p.pixels) sum += pixel;
  return sum / static_cast<float>(p.pixels.size());
}

TEST(Truth, ShowsTheSameStrandsAsTheRealTimePicture) {
  Desk desk;
  const Picture realTime = desk.realTime();
  const float same = flip(desk.reference(), realTime).mean;
  desk.app.setField("seed", "2");
  desk.app.settle();
  const float others = flip(desk.reference(), realTime).mean;
  EXPECT_LT(same, 0.8f * others) << same << " against " << others;
}

// As the march differs from it by the coat that stands there and by the clumps into which water draws it.
TEST(Truth, ShowsTheSameClumpsAsTheRealTimePicture) {
  Desk desk;
  desk.app.setField("dryRate", "0");
  desk.app.setWetness(0.6f);
  desk.app.settle();
  const Picture realTime = desk.realTime();
  const float wet = flip(desk.reference(true), realTime).mean, dry = flip(desk.reference(), realTime).mean;
  EXPECT_LT(wet, 0.85f * dry) << wet << " against " << dry;
}

TEST(Truth, IsAsBrightAsTheRealTimePicture) {
  Desk desk;
  // From all round the light's side: so near, few strands are seen at once, and which ones is chance.
  constexpr float kYaws[] = {-1.75f, -1.25f, -0.75f, -0.25f, 0.25f, 0.75f};
  Vec3 darker(0);
  for (const float yaw : kYaws) {
    desk.app.setCamera({yaw, 0.4f, 1.5f, Vec3(0)});
    desk.app.settle();
    darker += meanOf(desk.reference()) - meanOf(desk.realTime());
  }
  // A tenth of the range: the reference averages in linear light, the other in sRGB.
  EXPECT_LT(glm::length(darker) / static_cast<float>(std::size(kYaws)), 0.1f);
}

TEST(Truth, ShowsTheSameHairAsTheRealTimePictureNearAndFar) {
  Desk desk;
  desk.app.setField("furLength", "0");
  desk.app.editHair(app::HairEdit::AddScalp);
  desk.app.editHair(app::HairEdit::Cover, 1);
  EXPECT_TRUE(desk.app.setHairValue(0, "wisps", "120"));
  // The reference has strands alone.
  EXPECT_TRUE(desk.app.setHairValue(0, "skinCover", "0"));
  desk.app.editHair(app::HairEdit::Plant, 60);
  for (const auto& [detail, distance] : {std::pair("strands", 1.7f), {"strips", 4.0f}}) {
    desk.app.setField("hairDetail", detail);
    desk.app.setCamera({-0.75f, 0.4f, distance, Vec3(0)});
    desk.app.settle();
    const Picture realTime = desk.realTime();
    const float same = flip(desk.reference(), realTime).mean;
    EXPECT_TRUE(desk.app.setHairValue(0, "seed", "2"));
    desk.app.settle();
    const float others = flip(desk.reference(), realTime).mean;
    EXPECT_TRUE(desk.app.setHairValue(0, "seed", "1"));
    EXPECT_LT(same, 0.8f * others) << detail << ": " << same << " against " << others;
  }
}

}  // namespace
}  // namespace fur::truth
