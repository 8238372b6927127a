#include "render/passes/hair/DrawnHair.h"

#include <algorithm>
#include <cmath>

namespace fur::render {

namespace {

// Pixels that a wisp is wide where the first one is drawn strand by strand, and where all are.
constexpr float kFirstStrands = 10, kAllStrands = 24;
// Where wisps are thinner than so many pixels there are fewer, but for so small a share of them.
constexpr float kThinWisp = 6, kLeastWisps = 1.0f / 16;
// Pixels along a wisp for each of its segments that is drawn.
constexpr float kSegmentPixels = 6;
// Its shadow is where hair was until it has gone so far.
constexpr float kStalePixels = 1;
// A shadow map's texels are coarse.
constexpr int kShadowStep = 2;

float distanceTo(const Vec4& ball, const Frame& frame) {
  return std::max(glm::length(Vec3(ball) - eyeInModel(frame)) - ball.w, 0.05f);
}

HairTransparency transparencyOf(const Frame& frame) { return static_cast<HairTransparency>(frame.settings.hairTransparency); }

// That a model unit covers at the nearest of it.
float pixelsAt(const HairScalp& scalp, const Frame& frame) { return pixelsPerUnit(frame) / distanceTo(scalp.bounds(), frame); }

// By its size on screen and the share of it that the frame asks for.
HairLevel levelOf(const HairScalp& scalp, const Frame& frame) {
  const float pixels = pixelsAt(scalp, frame);
  const float share = frame.hairShare, wide = share * scalp.width() * pixels;
  const auto drawnAs = static_cast<HairDetail>(frame.settings.hairDetail);
  const auto wisps = static_cast<float>(scalp.wisps());
  HairLevel level;
  if (drawnAs != HairDetail::Auto) level.strandWisps = drawnAs == HairDetail::Strands ? scalp.wisps() : 0;
  else level.strandWisps = static_cast<int>(std::lround(saturate((wide - kFirstStrands) / (kAllStrands - kFirstStrands)) * wisps));
  // Where strands are thinner than a pixel there are fewer, as much wider (Cook et al. 2007, stochastic simplification).
  const float strands = share * std::min(scalp.block().strandWidth * pixels, 1.0f) * static_cast<float>(scalp.strands());
  level.strands = std::clamp(static_cast<int>(std::ceil(strands)), 1, scalp.strands());
  // So it is with wisps.
  level.wispShare = drawnAs == HairDetail::Strands ? 1 : glm::clamp(wide / kThinWisp, kLeastWisps, 1.0f);
  const float along = share * scalp.length() * pixels / FUR_WISP_SEGMENTS / kSegmentPixels;
  level.step = along > 1 ? 1 : along > 0.5f ? 2 : along > 0.25f ? 4 : 8;
  return level;
}

}  // namespace

void DrawnHair::setScalps(std::size_t count) {
  scalps_.resize(count);
  ++revision_;
}

std::size_t DrawnHair::grow(std::size_t scalp, const HairGrowth& growth) {
  ++revision_;
  return scalps_[scalp].grow(growth);
}

std::size_t DrawnHair::move(std::size_t scalp, std::span<const hair::GuideNode> nodes) { return scalps_[scalp].move(nodes); }

bool DrawnHair::empty() const {
  return std::all_of(scalps_.begin(), scalps_.end(), [](const HairScalp& scalp) { return scalp.wisps() == 0; });
}

float DrawnHair::reach() const {
  float most = 0;
  for (const HairScalp& scalp : scalps_)
    if (scalp.wisps() > 0) most = std::max(most, scalp.reach());
  return most;
}

void DrawnHair::fit(const Frame& frame) {
  const auto octaves = [](float wispShare) { return std::floor(2 * std::log2(wispShare)); };
  for (HairScalp& scalp : scalps_) {
    if (scalp.wisps() == 0) continue;
    const HairLevel level = levelOf(scalp, frame);
    if (octaves(level.wispShare) != octaves(scalp.level().wispShare)) ++revision_;
    scalp.setLevel(level);
    if (scalp.wayFromShadow() * pixelsAt(scalp, frame) < kStalePixels) continue;
    scalp.castShadow();
    ++revision_;
  }
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
    if (!drawWisps(drawing, scalp, Shader::BlendedHair, 1) || !drawWisps(drawing, scalp, Shader::BlendedHair, 2)) return false;
  }
  return true;
}

bool DrawnHair::drawSkin(const Drawing& drawing, const HairScalp& scalp) const {
  // A coat has skin of its own.
  if (!scalp.hasSkin() || drawing.look.furry()) return true;
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
  const HairLevel& level = scalp.level();
  const bool depthOnly = shader == Shader::HairDepth;
  const VariantBits look = depthOnly ? +kPlain : drawing.look.hair();
  const bool depthDrawn = transparencyOf(drawing.frame) == HairTransparency::DepthFirst && !depthOnly;
  shared::HairBlock block = scalp.block();
  block.hairOcclusion = drawing.frame.settings.hairOcclusion;
  block.hairBlend = blend;
  const int segments = FUR_WISP_SEGMENTS / level.step;
  const gl::DrawState state{.depthWrite = !depthDrawn && blend < 2, .cullBack = false, .blend = blend == 2 ? gl::Blend::Over : gl::Blend::None,
                            .alphaToCoverage = blend == 0, .red = !depthOnly, .green = !depthOnly, .blue = !depthOnly, .alpha = false};
  // Where wisps are in order all of them are strips.
  const int strandWisps = blend == 0 ? level.strandWisps : 0;
  if (strandWisps > 0) {
    if (!drawing.programs.use(shader, look)) return false;
    scalp.bind(block);
    gl::apply(state);
    gl::drawInstancesWithoutVertices(gl::Shape::Strip, (2 * segments + 4) * strandWisps * level.strands, 1);
  }
  if (strandWisps >= scalp.wispsDrawn()) return true;
  if (!drawing.programs.use(shader, look | kStrips)) return false;
  block.firstWisp = static_cast<float>(strandWisps);
  scalp.bind(block);
  gl::apply(state);
  gl::drawInstancesWithoutVertices(gl::Shape::Triangles, 6 * segments * (scalp.wispsDrawn() - strandWisps), 1);
  return true;
}

bool DrawnHair::drawShadow(Programs& programs, VariantBits variant, const gl::DrawState& state, int copies) const {
  for (const HairScalp& scalp : scalps_) {
    if (scalp.wisps() == 0) continue;
    if (!programs.use(Shader::HairShadow, variant)) return false;
    shared::HairBlock block = scalp.block();
    const int step = std::max(scalp.level().step, kShadowStep);
    block.pointStep = static_cast<float>(step);
    scalp.bind(block);
    gl::apply(state);
    gl::drawInstancesWithoutVertices(gl::Shape::Triangles, 6 * (FUR_WISP_SEGMENTS / step) * scalp.wispsDrawn(), copies);
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
