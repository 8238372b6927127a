#include "render/passes/hair/HairPass.h"

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

// How many wisps are drawn strand by strand.
int strandWisps(const HairScalp& scalp, const Frame& frame, float pixelsPerModelUnit) {
  switch (static_cast<HairDetail>(frame.settings.hairDetail)) {
    case HairDetail::Strips: return 0;
    case HairDetail::Strands: return scalp.wisps();
    case HairDetail::Auto: break;
  }
  const float near = saturate((scalp.width() * pixelsPerModelUnit - kFirstStrands) / (kAllStrands - kFirstStrands));
  return static_cast<int>(std::lround(near * static_cast<float>(scalp.wisps())));
}

// Points of a wisp from one that is drawn to the next: 1, 2 or 4.
float pointStep(const HairScalp& scalp, float pixelsPerModelUnit) {
  const float pixels = scalp.length() * pixelsPerModelUnit / FUR_WISP_SEGMENTS;
  return pixels > kSegmentPixels ? 1 : pixels > 0.5f * kSegmentPixels ? 2 : 4;
}

// Of a wisp: where strands are thinner than a pixel there are fewer, as much wider (Cook et al. 2007, stochastic simplification).
int drawnStrands(const HairScalp& scalp, float pixelsPerModelUnit) {
  constexpr float kPixels = 1;
  const float share = std::min(scalp.block().strandWidth * pixelsPerModelUnit / kPixels, 1.0f);
  return std::clamp(static_cast<int>(std::ceil(share * static_cast<float>(scalp.strands()))), 1, scalp.strands());
}

int segmentsOf(float step) { return static_cast<int>(FUR_WISP_SEGMENTS / step); }

}  // namespace

void HairPass::setScalps(std::size_t count) {
  scalps_.resize(count);
  ++revision_;
}

std::size_t HairPass::grow(std::size_t scalp, const HairGrowth& growth) {
  ++revision_;
  return scalps_[scalp].grow(growth);
}

std::size_t HairPass::move(std::size_t scalp, std::span<const hair::GuideNode> nodes) {
  ++revision_;
  return scalps_[scalp].move(nodes);
}

bool HairPass::empty() const {
  return std::all_of(scalps_.begin(), scalps_.end(), [](const HairScalp& scalp) { return scalp.wisps() == 0; });
}

float HairPass::reach() const {
  float most = 0;
  for (const HairScalp& scalp : scalps_)
    if (scalp.wisps() > 0) most = std::max(most, scalp.reach());
  return most;
}

bool HairPass::update(Programs& programs) {
  return std::all_of(scalps_.begin(), scalps_.end(), [&](HairScalp& scalp) { return scalp.update(programs); });
}

bool HairPass::draw(const Drawing& drawing) const {
  for (const HairScalp& scalp : scalps_) {
    if (scalp.wisps() == 0) continue;
    const float pixels = pixelsPerUnit(drawing.frame) / distanceTo(scalp.bounds(), drawing.frame);
    const int strands = strandWisps(scalp, drawing.frame, pixels);
    const float step = pointStep(scalp, pixels);
    if (!drawStrands(drawing, scalp, strands, step, pixels) || !drawStrips(drawing, scalp, strands, step)) return false;
  }
  return true;
}

bool HairPass::drawStrands(const Drawing& drawing, const HairScalp& scalp, int wisps, float step, float pixels) const {
  if (wisps == 0) return true;
  if (!drawing.programs.use(Shader::Hair, drawing.look.hair())) return false;
  shared::HairBlock block = scalp.block();
  const int strands = drawnStrands(scalp, pixels);
  block.strandsDrawn = static_cast<float>(strands);
  block.widening = static_cast<float>(scalp.strands()) / static_cast<float>(strands);
  block.pointStep = step;
  block.hairOcclusion = drawing.frame.settings.hairOcclusion;
  scalp.bind(block);
  gl::apply({.cullBack = false, .alphaToCoverage = true, .alpha = false});
  gl::drawInstancesWithoutVertices(gl::Shape::Strip, (2 * segmentsOf(step) + 4) * wisps * strands, 1);
  return true;
}

bool HairPass::drawStrips(const Drawing& drawing, const HairScalp& scalp, int first, float step) const {
  if (first == scalp.wisps()) return true;
  if (!drawing.programs.use(Shader::Hair, drawing.look.hair() | kStrips)) return false;
  shared::HairBlock block = scalp.block();
  block.firstWisp = static_cast<float>(first);
  block.pointStep = step;
  block.hairOcclusion = drawing.frame.settings.hairOcclusion;
  scalp.bind(block);
  gl::apply({.cullBack = false, .alphaToCoverage = true, .alpha = false});
  gl::drawInstancesWithoutVertices(gl::Shape::Triangles, 6 * segmentsOf(step) * (scalp.wisps() - first), 1);
  return true;
}

bool HairPass::drawShadow(Programs& programs, unsigned variant, const gl::DrawState& state, int copies) const {
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

std::size_t HairPass::bytes() const {
  std::size_t sum = 0;
  for (const HairScalp& scalp : scalps_) sum += scalp.bytes();
  return sum;
}

}  // namespace fur::render
