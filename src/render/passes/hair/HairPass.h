// Draws long hair; this class alone draws none, ever. Programs that grow hair have DrawnHair in its place (drawWith()).
#pragma once

#include <memory>
#include <span>

#include "render/Hair.h"
#include "render/passes/Drawing.h"

namespace fur::render {

// In the order of the setting `hairDetail`.
enum class HairDetail { Auto, Strips, Strands };
// And of `hairTransparency`.
enum class HairTransparency { Coverage, DepthFirst, Blended };

class HairScalp;

class HairPass {
 public:
  // What make() gives from then on.
  static void drawWith(std::unique_ptr<HairPass> (*maker)());
  static std::unique_ptr<HairPass> make();
  virtual ~HairPass() = default;

  // The last two return the bytes that were uploaded.
  virtual void setScalps(std::size_t) {}
  virtual std::size_t grow(std::size_t /*scalp*/, const HairGrowth&) { return 0; }
  virtual std::size_t move(std::size_t /*scalp*/, std::span<const hair::GuideNode>) { return 0; }

  virtual bool empty() const { return true; }
  // How much of it is drawn in that frame. First of all, as revision() depends on it.
  virtual void fit(const Frame&) {}
  // Another number after every change that its shadow shows: from a pixel on.
  unsigned long revision() const { return revision_; }
  // How far from the model's origin any comes; 0 without any.
  virtual float reach() const { return 0; }
  virtual std::size_t scalpCount() const { return 0; }
  virtual const HairScalp* scalp(std::size_t) const { return nullptr; }

  // Before anything draws hair; see HairScalp::update().
  virtual bool update(Programs&) { return true; }
  virtual bool draw(const Drawing&) { return true; }
  // Into the fur's shadow map or the ground's, whose target is bound: in the program of that variant, `copies` times.
  virtual bool drawShadow(Programs&, VariantBits /*variant*/, const gl::DrawState&, int /*copies*/ = 1) const { return true; }
  virtual std::size_t bytes() const { return 0; }

 protected:
  unsigned long revision_ = 0;
};

}  // namespace fur::render
