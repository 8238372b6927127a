// Draws what views and tools show of long hair (hair/HairView.h): lines over the picture, wisps in colours of their own, maps on the
// skin. Only programs that grow hair have it (HairViews::showWith()); it compiles nothing before anything is shown.
#pragma once

#include <memory>

#include "hair/HairView.h"
#include "render/passes/Drawing.h"
#include "render/passes/hair/HairPass.h"

namespace fur::render {

class HairViews {
 public:
  // What make() gives from then on; before, nothing.
  static void showWith(std::unique_ptr<HairViews> (*maker)());
  static std::unique_ptr<HairViews> make();
  virtual ~HairViews() = default;

  // Until the next call; nullptr: nothing. It is looked at while frames are drawn.
  virtual void show(const hair::HairView* view) = 0;
  // Whether draw() draws instead of the final picture.
  virtual bool instead() const = 0;
  // The hair in the picture; or all that is seen instead of it but for the background.
  virtual bool draw(const Drawing& drawing, HairPass& hair) = 0;
  // Over the picture, after all else.
  virtual bool drawLines(const Drawing& drawing) = 0;
  virtual std::size_t bytes() const = 0;
};

// One that draws.
std::unique_ptr<HairViews> makeHairViews();

}  // namespace fur::render
