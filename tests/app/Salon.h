// A sphere in a small picture on which long hair can be grown.
#pragma once

#include "app/LongHair.h"
#include "tests/render/Picture.h"

namespace fur::test {

inline const bool growsHair = (app::growLongHair(), scene::readAllFormats(), true);

struct Salon : Room {
  // Pixels of a side, and guides that are planted.
  Salon(int side, int guides) : Room(side, {{"layers", "8"}, {"tileSize", "64"}, {"breath", "0"}, {"furLength", "0.02"}}), guides_(static_cast<float>(guides)) {}
  void grow() {
    app.editHair(app::HairEdit::AddScalp);
    app.editHair(app::HairEdit::Cover, 1);
    EXPECT_TRUE(app.setHairValue(0, "guideLength", "0.5"));
    app.editHair(app::HairEdit::Plant, guides_);
    app.settle();
  }
  Picture picture() {
    app.tick(0);
    return stage.draw(app);
  }
  // With that setting from now on.
  Picture pictureWith(std::string_view field, std::string_view value) {
    app.setField(field, value);
    return picture();
  }

 private:
  float guides_;
};

}  // namespace fur::test
