// What views and tools show of long hair.
#include "tests/app/Salon.h"

namespace fur::app {
namespace {

struct ViewSalon : test::Salon {
  ViewSalon() : test::Salon(120, 30) {}
  test::Picture view(const char* name) {
    app.setField("hairView", name);
    return picture();
  }
};

TEST(HairViews, EachShowsSomethingElseAndTheFinalPictureComesBackAsItWas) {
  ViewSalon salon;
  salon.grow();
  salon.app.editHair(HairEdit::AddSphere, 1.2f);
  salon.settled();
  std::vector<test::Picture> pictures{salon.view("final")};
  for (const char* name : {"guides", "wisps", "influence", "springs", "scalp", "shapes"}) {
    const test::Picture shown = salon.view(name);
    for (const test::Picture& other : pictures) EXPECT_GT(shown.differingShare(other, 16), 0.01f) << name;
    pictures.push_back(shown);
  }
  EXPECT_EQ(salon.view("final").differingShare(pictures[0], 0), 0);
}

TEST(HairViews, ShowNothingWithoutHairAndUploadNothingForAPictureWithoutThem) {
  ViewSalon salon;
  const test::Picture bare = salon.picture();
  EXPECT_EQ(salon.view("guides").differingShare(bare, 0), 0);
  salon.app.setField("hairView", "final");
  salon.grow();
  salon.picture();
  const std::size_t usual = (salon.picture(), salon.app.stats().uploadedBytes);
  salon.view("guides");
  salon.view("final");
  EXPECT_EQ((salon.picture(), salon.app.stats().uploadedBytes), usual);
}

TEST(HairViews, GuidesComeOverTheHairWhileAToolWorksOnThemButNotIntoPicturesForFiles) {
  ViewSalon salon;
  salon.grow();
  const test::Picture plain = salon.picture();
  salon.app.setTool(Tool::HairComb);
  const test::Picture shown = salon.picture();
  EXPECT_GT(shown.differingShare(plain, 16), 0.01f);
  salon.app.setSaved(true);
  EXPECT_EQ(salon.picture().differingShare(plain, 0), 0);
  salon.app.setSaved(false);
  EXPECT_EQ(salon.picture().differingShare(shown, 0), 0);
  // Nodes within the brush stand out.
  salon.app.setField("brushRadius", "0.5");
  salon.app.hover(Vec2(60, 45));
  EXPECT_GT(salon.picture().differingShare(shown, 16), 0.001f);
  salon.app.hover(std::nullopt);
  EXPECT_EQ(salon.picture().differingShare(shown, 0), 0);
}

TEST(HairViews, TheMapLiesOverTheCoatWhileItIsPainted) {
  ViewSalon salon;
  const test::Picture bare = salon.picture();
  salon.app.editHair(HairEdit::AddScalp);
  salon.app.editHair(HairEdit::Cover, 0.5f);
  salon.app.setTool(Tool::Scalp);
  const test::Picture half = salon.picture();
  EXPECT_GT(half.differingShare(bare, 16), 0.1f);
  salon.app.editHair(HairEdit::Cover, 1);
  EXPECT_GT(salon.picture().differingShare(half, 16), 0.1f);
  salon.app.setTool(Tool::None);
  EXPECT_EQ(salon.picture().differingShare(bare, 0), 0);
}

}  // namespace
}  // namespace fur::app
