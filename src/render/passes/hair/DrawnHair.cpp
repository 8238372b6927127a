#include "render/passes/hair/DrawnHair.h"

#include <algorithm>
#include <cmath>

namespace fur::render {

namespace {

// Pixels that a wisp is wide where the first one is drawn strand by strand, and where all are.
constexpr float kFirstStrands = 10, kAllStrands = 24;
// Pixels along a wisp for each of its segments that is drawn.
constexpr float kSegmentPixels = 6;

float distanceTo(const Vec4& ball, const Frame& frame) {
  return std::max(glm::length(Vec3(ball) - eyeInModel(frame)) - ball.w, 0.05f);
}

// How much of a scalp's hair is drawn, by its size on screen and the share of it that the frame asks for.
class Detail {
 public:
  Detail(const HairScalp& scalp, const Frame& frame)
      : scalp_(scalp), pixels_(pixelsPerUnit(frame) / distanceTo(scalp.bounds(), frame)), share_(frame.hairShare),
        drawnAs_(static_cast<HairDetail>(frame.settings.hairDetail)) {}

  // Wisps that are drawn strand by strand.
  int strandWisps() const {
    if (drawnAs_ != HairDetail::Auto) return drawnAs_ == HairDetail::Strands ? scalp_.wisps() : 0;
    const float near = saturate((share_ * scalp_.width() * pixels_ - kFirstStrands) / (kAllStrands - kFirstStrands));
    return static_cast<int>(std::lround(near * static_cast<float>(scalp_.wisps())));
  }
  // Points of a wisp from one that is drawn to the next: 1, 2 or 4.
  float pointStep() const {
    const float along = share_ * scalp_.length() * pixels_ / FUR_WISP_SEGMENTS;
    return along > kSegmentPixels ? 1 : along > 0.5f * kSegmentPixels ? 2 : 4;
  }
  // Of a wisp: where strands are thinner than a pixel there are fewer, as much wider (Cook et al. 2007, stochastic simplification).
  int strands() const {
    const float share = share_ * std::min(scalp_.block().strandWidth * pixels_, 1.0f);
    return std::clamp(static_cast<int>(std::ceil(share * static_cast<float>(scalp_.strands()))), 1, scalp_.strands());
  }

 private:
  const HairScalp& scalp_;
  float pixels_;  // that a model unit covers at the nearest of it
  float share_;
  HairDetail drawnAs_;
};

HairTransparency transparencyOf(const Frame& frame) { return static_cast<HairTransparency>(frame.settings.hairTransparency); }

int segmentsOf(float step) { return static_cast<int>(FUR_WISP_SEGMENTS / step); }

}  // namespace

void DrawnHair::setScalps(std::size_t count) {
  scalps_.resize(count);
  ++revision_;
}

std::size_t DrawnHair::grow(std::size_t scalp, const HairGrowth& growth) {
  ++revision_;
  return scalps_[scalp].grow(growth);
}

std::size_t DrawnHair::move(std::size_t scalp, std::span<const hair::GuideNode> nodes) {
  ++revision_;
  return scalps_[scalp].move(nodes);
}

bool DrawnHair::empty() const {
  return std::all_of(scalps_.begin(), scalps_.end(), [](const HairScalp& scalp) { return scalp.wisps() == 0; });
}

float DrawnHair::reach() const {
  float most = 0;
  for (const HairScalp& scalp : scalps_)
    if (scalp.wisps() > 0) most = std::max(most, scalp.reach());
  return most;
}

bool DrawnHair::update(Programs& programs) {
  return std::all_of(scalps_.begin(), scalps_.end(), [&](HairScalp& scalp) { return scalp.update(programs); });
}

bool DrawnHair::draw(const Drawing& drawing) {
  const HairTransparency transparency = transparencyOf(drawing.frame);
  if (transparency == HairTransparency::DepthFirst)
    for (const HairScalp& scalp : scalps_)
      if (!drawWisps(drawing, scalp, Shader::HairDepth, 0)) return false;
  for (HairScalp& scalp : scalps_) {
    if (scalp.wisps() == 0) continue;
    if (!drawSkin(drawing, scalp)) return false;
    if (transparency != HairTransparency::Blended) {
      if (!drawWisps(drawing, scalp, Shader::Hair, 0)) return false;
      continue;
    }
    scalp.sortFrom(eyeInModel(drawing.frame));
    if (!drawWisps(drawing, scalp, Shader::Hair, 1) || !drawWisps(drawing, scalp, Shader::Hair, 2)) return false;
  }
  return true;
}

bool DrawnHair::drawSkin(const Drawing& drawing, const HairScalp& scalp) const {
  if (!scalp.hasSkin()) return true;
  if (!drawing.programs.use(Shader::HairSkin, drawing.look.hair() & ~kWet)) return false;
  shared::HairBlock block = scalp.block();
  block.hairOcclusion = drawing.frame.settings.hairOcclusion;
  scalp.bind(block);
  gl::apply({.cullBack = !drawing.surface.twoSided(), .alphaToCoverage = true, .nearer = true, .alpha = false});
  drawing.surface.draw(1);
  return true;
}

// Strands, then strips; `blend`: hairBlend in shared/Hair.h.
bool DrawnHair::drawWisps(const Drawing& drawing, const HairScalp& scalp, Shader shader, float blend) const {
  if (scalp.wisps() == 0) return true;
  const Detail detail(scalp, drawing.frame);
  const unsigned look = shader == Shader::Hair ? drawing.look.hair() : +kPlain;
  const bool depthOnly = shader == Shader::HairDepth;
  const bool depthDrawn = transparencyOf(drawing.frame) == HairTransparency::DepthFirst && !depthOnly;
  shared::HairBlock block = scalp.block();
  block.pointStep = detail.pointStep();
  block.hairOcclusion = drawing.frame.settings.hairOcclusion;
  block.strandsDrawn = static_cast<float>(detail.strands());
  block.widening = static_cast<float>(scalp.strands()) / static_cast<float>(detail.strands());
  block.hairBlend = blend;
  const int segments = segmentsOf(block.pointStep);
  const gl::DrawState state{.depthWrite = !depthDrawn && blend < 2, .cullBack = false, .blend = blend == 2 ? gl::Blend::Over : gl::Blend::None,
                            .alphaToCoverage = blend == 0, .red = !depthOnly, .green = !depthOnly, .blue = !depthOnly, .alpha = false};
  // Where wisps are in order all of them are strips.
  const int strandWisps = blend == 0 ? detail.strandWisps() : 0;
  if (strandWisps > 0) {
    if (!drawing.programs.use(shader, look)) return false;
    scalp.bind(block);
    gl::apply(state);
    gl::drawInstancesWithoutVertices(gl::Shape::Strip, (2 * segments + 4) * strandWisps * detail.strands(), 1);
  }
  if (strandWisps == scalp.wisps()) return true;
  if (!drawing.programs.use(shader, look | kStrips)) return false;
  block.firstWisp = static_cast<float>(strandWisps);
  scalp.bind(block);
  gl::apply(state);
  gl::drawInstancesWithoutVertices(gl::Shape::Triangles, 6 * segments * (scalp.wisps() - strandWisps), 1);
  return true;
}

bool DrawnHair::drawShadow(Programs& programs, unsigned variant, const gl::DrawState& state, int copies) const {
  // A map's texels are coarse.
  constexpr float kStep = 2;
  for (const HairScalp& scalp : scalps_) {
    if (scalp.wisps() == 0) continue;
    if (!programs.use(Shader::HairShadow, variant)) return false;
    shared::HairBlock block = scalp.block();
    block.pointStep = kStep;
    scalp.bind(block);
    gl::apply(state);
    gl::drawInstancesWithoutVertices(gl::Shape::Triangles, 6 * segmentsOf(kStep) * scalp.wisps(), copies);
  }
  return true;
}

std::size_t DrawnHair::bytes() const {
  std::size_t sum = 0;
  for (const HairScalp& scalp : scalps_) sum += scalp.bytes();
  return sum;
}

std::unique_ptr<HairPass> makeDrawnHair() { return std::make_unique<DrawnHair>(); }

}  // namespace fur::render
