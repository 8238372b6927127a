// Draws beads of water on strands and whiskers that are a little wet: some strands, by chance and evenly over the coat, each with the
// number that says how much water it takes for a bead (wet::beadSize()). Shaders ask the mask: nothing is worked out again as water comes
// and goes. Without water nothing is uploaded, compiled or drawn.
#pragma once

#include <vector>

#include "geometry/Surface.h"
#include "render/Skin.h"
#include "render/passes/whisker/WhiskerPass.h"

namespace fur::render {

// Strands that may hold a bead: hairs of length 0, as long as the coat is where they root.
std::vector<groom::WhiskerHair> strandsForBeads(const geometry::Surface& surface);

class BeadPass {
 public:
  void set(const geometry::Surface& surface);
  void follow(const Skin& skin);
  // Over a picture that is whole.
  bool draw(const Drawing& drawing, const WhiskerPass& whiskers);
  std::size_t bytes() const { return vertices_.bytes(); }

 private:
  std::vector<groom::WhiskerHair> strands_;
  bool changed_ = false;  // since they were uploaded
  gl::Buffer vertices_;
  gl::VertexArray array_;
};

}  // namespace fur::render
