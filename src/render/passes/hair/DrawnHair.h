// Long hair (hair/Wisps.h): near as strands, each a ribbon of its true width, far as strips, a picture of the same strands
// on each wisp (Halen & Wester 2007). Between them wisp after wisp changes from one to the other, so that nothing pops. One draw a
// scalp and representation. Without hair nothing is kept, compiled or drawn.
#pragma once

#include <vector>

#include "render/passes/hair/HairPass.h"
#include "render/passes/hair/HairScalp.h"

namespace fur::render {

class DrawnHair final : public HairPass {
 public:
  void setScalps(std::size_t count) override;
  std::size_t grow(std::size_t scalp, const HairGrowth& growth) override;
  std::size_t move(std::size_t scalp, std::span<const hair::GuideNode> nodes) override;
  bool empty() const override;
  float reach() const override;
  std::size_t scalpCount() const override { return scalps_.size(); }
  const HairScalp* scalp(std::size_t i) const override { return &scalps_[i]; }
  void fit(const Frame& frame) override;
  bool update(Programs& programs) override;
  bool draw(const Drawing& drawing) override;
  bool drawShadow(Programs& programs, VariantBits variant, const gl::DrawState& state, int copies) const override;
  std::size_t bytes() const override;

 private:
  bool drawSkin(const Drawing& drawing, const HairScalp& scalp) const;
  bool drawWisps(const Drawing& drawing, const HairScalp& scalp, Shader shader, float blend) const;

  std::vector<HairScalp> scalps_;
};

std::unique_ptr<HairPass> makeDrawnHair();

}  // namespace fur::render
