// Draws long hair (hair/Wisps.h): near as strands, each a ribbon of its true width, far as strips, a picture of the same strands
// on each wisp (Halen & Wester 2007). Between them wisp after wisp changes from one to the other, so that nothing pops. One draw a
// scalp and representation. Without hair nothing is kept, compiled or drawn.
#pragma once

#include <vector>

#include "render/passes/Drawing.h"
#include "render/passes/hair/HairScalp.h"

namespace fur::render {

// In the order of the setting `hairDetail`.
enum class HairDetail { Auto, Strips, Strands };
// And of `hairTransparency`.
enum class HairTransparency { Coverage, DepthFirst, Blended };

class HairPass {
 public:
  void setScalps(std::size_t count);
  std::size_t grow(std::size_t scalp, const HairGrowth& growth);
  std::size_t move(std::size_t scalp, std::span<const hair::GuideNode> nodes);

  bool empty() const;
  // Another number after every change.
  unsigned long revision() const { return revision_; }
  // How far from the model's origin any comes; 0 without any.
  float reach() const;

  const std::vector<HairScalp>& scalps() const { return scalps_; }

  // Before anything draws hair; see HairScalp::update().
  bool update(Programs& programs);
  bool draw(const Drawing& drawing);
  // Into the fur's shadow map or the ground's, whose target is bound: in the program of that variant, `copies` times.
  bool drawShadow(Programs& programs, unsigned variant, const gl::DrawState& state, int copies = 1) const;
  std::size_t bytes() const;

 private:
  bool drawSkin(const Drawing& drawing, const HairScalp& scalp) const;
  bool drawWisps(const Drawing& drawing, const HairScalp& scalp, Shader shader, float blend) const;

  std::vector<HairScalp> scalps_;
  unsigned long revision_ = 0;
};

}  // namespace fur::render
