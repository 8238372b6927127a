// The technique `shells`.
#include "furgen/FinOpacity.h"
#include "tests/render/Picture.h"

namespace fur::render {
namespace {

using test::Picture;
using test::Room;

// Shells of a sphere, in front of one colour.
struct Shells : Room {
  explicit Shells(std::initializer_list<std::pair<const char*, const char*>> settings = {}, int side = 96)
      : Room(side, {{"technique", "shells"}, {"ground", "false"}, {"backgroundTop", "#0000ff"}, {"backgroundBottom", "#0000ff"}, {"layers", "16"}, {"gravity", "0"}}) {
    for (const auto& [name, value] : settings) app.setField(name, value);
    app.settle();
  }
  Picture with(const char* field, const char* value) {
    app.setField(field, value);
    return settled();
  }
};

// Pixels that show the background alone.
long empty(const Picture& picture) {
  long count = 0;
  for (std::size_t i = 0; i < picture.rgba.size(); i += 4) count += picture.rgba[i] < 3 && picture.rgba[i + 1] < 3 && picture.rgba[i + 2] > 252;
  return count;
}

TEST(Classic, ShowsTheCoatThatTheMarchShows) {
  // Blunt strands: between needles shells let one look deeper, and are darker.
  Shells shells({{"fins", "false"}, {"taper", "0.5"}, {"undercoat", "0"}});
  const Picture classic = shells.settled(), march = shells.with("technique", "march");
  EXPECT_NEAR(classic.brightness(), march.brightness(), 0.16f * march.brightness());
  EXPECT_GT(classic.differingShare(march, 8), 0.1f) << "but not by the same way";
  EXPECT_NEAR(static_cast<double>(empty(classic)), static_cast<double>(empty(march)), 0.1 * static_cast<double>(empty(march)));
}

TEST(Classic, MoreLayersAreMoreShells) {
  Shells shells({{"fins", "false"}, {"furLength", "0.25"}, {"density", "0.4"}, {"thickness", "0.6"}, {"taper", "0.5"}});
  // Between few shells one looks through to the background at the outline; the view of shells leaves the skin out.
  const long few = empty(shells.with("layers", "4")), many = empty(shells.with("layers", "32"));
  EXPECT_GT(few, many);
}

TEST(Classic, ABaldModelIsSkin) {
  Shells shells({{"density", "0"}});
  const Picture skin = shells.with("view", "skin");
  EXPECT_EQ(skin.differingShare(shells.with("view", "final"), 0), 0);
}

TEST(Classic, FinsStandBeyondTheSkinOnTheOutlineOrOnAllEdges) {
  Shells shells({{"view", "fins"}});
  const Picture outline = shells.settled(), all = shells.with("finEdges", "all");
  shells.app.setField("view", "final");
  const Picture without = shells.with("density", "0");
  EXPECT_LT(empty(outline), empty(without));
  EXPECT_GT(all.differingShare(outline, 12), 0.2f) << "fins on the side that faces the eye";
}

TEST(Classic, FinsFadeInFromTheThreshold) {
  EXPECT_EQ(furgen::finOpacity(furgen::kFinThreshold, 1), 0.0f);
  EXPECT_EQ(furgen::finOpacity(0, 1), 1.0f);
  EXPECT_EQ(furgen::finOpacity(-0.5f, -1), 1.0f);
  EXPECT_FLOAT_EQ(furgen::finOpacity(0, 0.2f), 0.6f) << "Eq. 3.2";
  float before = 1;
  for (float facing = 0; facing < 0.4f; facing += 0.01f) {
    const float now = furgen::finOpacity(facing, 0.9f);
    EXPECT_LE(now, before);
    EXPECT_LT(before - now, 0.06f) << "nothing pops at " << facing;
    before = now;
  }
}

TEST(Classic, WindBendsShellsAndFins) {
  for (const char* view : {"final", "fins"}) {
    Shells shells({{"view", view}, {"furLength", "0.25"}});
    const Picture rest = shells.settled();
    EXPECT_GT(shells.with("gravity", "1").differingShare(rest, 12), 0.05f) << view;
  }
}

TEST(Classic, WetFurIsDarkerAndWithGaps) {
  Shells shells;
  const Picture dry = shells.settled();
  shells.app.setWetness(0.8f);
  const Picture wet = shells.settled();
  EXPECT_LT(wet.brightness(), dry.brightness() - 5);
  EXPECT_GT(wet.differingShare(dry, 24), 0.2f);
}

TEST(Classic, EachEquationAsPrintedChangesItsOwnPictureAlone) {
  Shells shells;
  const Picture dry = shells.settled();
  EXPECT_GT(shells.with("printedLobe", "true").differingShare(dry, 4), 0.05f);
  shells.app.setField("printedLobe", "false");
  EXPECT_GT(shells.with("printedLight", "true").differingShare(dry, 4), 0.05f);
  shells.app.setField("printedLight", "false");
  for (const char* ofWater : {"printedClumps", "printedMask"}) {
    EXPECT_EQ(shells.with(ofWater, "true").differingShare(dry, 0), 0.0f) << ofWater << ": of dry fur";
    shells.app.setField(ofWater, "false");
  }
  shells.app.setField("dryRate", "0");
  shells.stroke(app::Tool::Droplet, {30, 48}, {60, 48});
  const Picture wet = shells.settled();
  for (const char* ofWater : {"printedClumps", "printedMask"}) {
    EXPECT_GT(shells.with(ofWater, "true").differingShare(wet, 12), 0.005f) << ofWater;
    EXPECT_EQ(shells.with(ofWater, "false").differingShare(wet, 0), 0.0f) << ofWater << ": and back";
  }
}

TEST(Classic, WetFurIsNoDarkerByTheLightAsPrintedWithoutDarkening) {
  Shells shells({{"printedLight", "true"}, {"wetDarkening", "0"}, {"specular", "0"}, {"strandShadow", "0"}, {"shadows", "none"}, {"view", "shells"}});
  const auto strands = [&] {
    const Picture picture = shells.settled();
    long brightest = 0;
    for (std::size_t i = 0; i < picture.rgba.size(); i += 4) brightest = std::max<long>(brightest, picture.rgba[i]);
    return static_cast<double>(brightest);
  };
  const double dry = strands();
  shells.app.setWetness(0.7f);
  EXPECT_NEAR(strands(), dry, 8) << "sigma_wet = 0";
  shells.app.setField("wetDarkening", "0.6");
  EXPECT_LT(strands(), dry - 20);
}

TEST(Classic, HidesNothingOfATransparentPictureButWhatItCovers) {
  Shells shells;
  shells.app.setSaved(true, true);
  const Picture picture = shells.settled();
  EXPECT_EQ(picture.at(1, 1)[3], 0);
  EXPECT_EQ(picture.at(48, 48)[3], 255);
  long partly = 0;
  for (std::size_t i = 3; i < picture.rgba.size(); i += 4) partly += picture.rgba[i] > 0 && picture.rgba[i] < 255;
  EXPECT_GT(partly, 20) << "strands at the outline";
}

}  // namespace
}  // namespace fur::render
