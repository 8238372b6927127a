#include "render/passes/hair/HairScalp.h"

#include <algorithm>
#include <cmath>

#include "core/Sort.h"
#include "core/Srgb.h"

namespace fur::render {

namespace {

static_assert(FUR_WISP_SEGMENTS == hair::kStripSegments && FUR_WISP_KINDS == hair::kWispKinds);
static_assert(hair::kStripReach == static_cast<float>(FUR_STRIP_REACH) && hair::kWetGathers == static_cast<float>(FUR_WET_GATHERS) &&
              hair::kWetDraws == static_cast<float>(FUR_WET_DRAWS));
static_assert(sizeof(hair::MemberStrand) == 2 * sizeof(Vec4));

// FUR_WISP_TEXELS vectors a wisp.
std::vector<Vec4> texelsOf(std::span<const hair::Wisp> wisps) {
  std::vector<Vec4> texels;
  texels.reserve(wisps.size() * FUR_WISP_TEXELS);
  for (const hair::Wisp& w : wisps) {
    texels.emplace_back(w.offset, w.width);
    texels.emplace_back(w.weights, w.length);
    texels.emplace_back(w.magnet, w.rotation);
    texels.emplace_back(static_cast<float>(w.guides[0]), static_cast<float>(w.guides[1]), static_cast<float>(w.guides[2]), w.random);
    texels.emplace_back(w.normal, static_cast<float>(w.splits));
  }
  return texels;
}

gl::Texture stripTexture(const hair::StripPicture& picture) {
  using Picture = hair::StripPicture;
  gl::Texture texture({gl::TexelFormat::RGBA8, Picture::kWidth, Picture::kHeight, FUR_WISP_KINDS, gl::Filter::Trilinear, false, Picture::kLevels}, {});
  for (std::size_t kind = 0; kind < FUR_WISP_KINDS; ++kind)
    for (std::size_t level = 0; level < Picture::kLevels; ++level)
      texture.updateLevel(static_cast<int>(level), static_cast<int>(kind), gl::bytesOf(picture.levels[kind][level]));
  return texture;
}

// A texel a vertex; empty where the skin is not shaded as hair.
gl::Texture baseTangentTexture(const HairGrowth& growth) {
  if (growth.values.skinCover <= 0 || growth.baseTangents.empty()) return {};
  std::vector<std::array<std::uint8_t, 4>> texels(growth.baseTangents.begin(), growth.baseTangents.end());
  const std::size_t rows = (texels.size() + FUR_BASE_TANGENTS_ROW - 1) / FUR_BASE_TANGENTS_ROW;
  texels.resize(rows * FUR_BASE_TANGENTS_ROW);
  return gl::Texture({gl::TexelFormat::RGBA8, FUR_BASE_TANGENTS_ROW, static_cast<int>(rows), 0, gl::Filter::Nearest}, gl::bytesOf(texels));
}

// wispShare() in hair_strip.glsl thins the last tenth: by so much more are drawn than are to be seen.
constexpr float kFadingWisps = 1.12f;
constexpr float kNeverCast = 1e6f;

}  // namespace

void HairScalp::fillBlock(const hair::HairValues& values, int nodes) {
  block_.hairRootColor = Vec4(linearColor(values.rootColor), 1);
  block_.hairTipColor = Vec4(linearColor(values.tipColor), 1);
  block_.guideNodes = static_cast<float>(nodes);
  block_.cubicGuides = values.curve == 0;
  block_.curl = values.curl;
  block_.curls = values.curls;
  block_.tipWidth = values.tipWidth;
  block_.hairDepth = values.depth;
  block_.strandWidth = values.strandWidth;
  block_.hairVariance = values.variance;
  block_.hairShininess = values.shininess;
  block_.hairGloss = values.gloss;
  block_.skinCover = values.skinCover;
  // A wisp's depth in front of a strand takes about two thirds of its light.
  block_.hairOpacity = 0.12f;
  block_.hairShadowBias = 0.5f * values.mostWidth * values.depth;
  block_.hairExtinction = 1.442695f / std::max(2 * values.mostWidth, 0.02f);
}

std::size_t HairScalp::grow(const HairGrowth& growth) {
  wispCount_ = static_cast<int>(growth.wisps.size());
  strandCount_ = static_cast<int>(growth.members.size()) / FUR_WISP_KINDS;
  guideCount_ = growth.guides;
  nodesEach_ = growth.nodes;
  fillBlock(growth.values, growth.nodes);
  if (wispCount_ == 0) return 0;
  setLevel({.strands = strandCount_});
  blockBuffer_ = gl::Buffer(gl::BufferKind::Uniform, gl::bytesOf(block_), true);
  const std::vector<Vec4> wisps = texelsOf(growth.wisps);
  wisps_ = gl::Texture({gl::TexelFormat::RGBA32F, FUR_WISP_TEXELS, wispCount_, 0, gl::Filter::Nearest}, gl::bytesOf(wisps));
  members_ = gl::Texture({gl::TexelFormat::RGBA32F, 2 * strandCount_, FUR_WISP_KINDS, 0, gl::Filter::Nearest}, std::as_bytes(growth.members));
  strips_ = stripTexture(growth.strips);
  ambient_ = gl::Texture({gl::TexelFormat::R8, FUR_WISP_SEGMENTS + 1, wispCount_, 0, gl::Filter::Nearest}, std::as_bytes(growth.ambient));
  baseTangents_ = baseTangentTexture(growth);
  order_ = {};
  cast_.clear();
  grown_.assign(growth.wisps.begin(), growth.wisps.end());
  nodes_ = gl::Texture({gl::TexelFormat::RGBA32UI, nodesEach_, guideCount_, 0, gl::Filter::Nearest}, {});
  points_ = gl::Texture({gl::TexelFormat::RGBA32UI, FUR_WISP_SEGMENTS + 1, wispCount_, 0, gl::Filter::Nearest}, {});
  pointsTarget_ = gl::Target::toTexture(points_);
  width_ = margin_ = 0;
  for (const hair::Wisp& w : growth.wisps) {
    width_ = std::max(width_, w.width);
    margin_ = std::max(margin_, glm::length(w.offset) + w.width * (0.5f * hair::kStripReach + growth.values.curl));
  }
  return wisps_.bytes() + members_.bytes() + strips_.bytes() + ambient_.bytes() + baseTangents_.bytes();
}

std::size_t HairScalp::move(std::span<const hair::GuideNode> nodes) {
  if (wispCount_ == 0) return 0;
  Vec3 low = nodes[0].position, high = low;
  reach_ = length_ = 0;
  for (std::size_t first = 0; first < nodes.size(); first += static_cast<std::size_t>(nodesEach_)) {
    float length = 0;
    for (std::size_t i = first + 1; i < first + static_cast<std::size_t>(nodesEach_); ++i) length += glm::distance(nodes[i - 1].position, nodes[i].position);
    length_ = std::max(length_, length);
  }
  middles_.clear();
  for (std::size_t i = static_cast<std::size_t>(nodesEach_ / 2); i < nodes.size(); i += static_cast<std::size_t>(nodesEach_)) middles_.push_back(nodes[i].position);
  for (const hair::GuideNode& node : nodes) {
    reach_ = std::max(reach_, glm::length(node.position) + margin_);
    low = glm::min(low, node.position);
    high = glm::max(high, node.position);
  }
  noteWay(nodes);
  low -= margin_, high += margin_;
  const Vec3 span = high - low;
  block_.nodesLow = Vec4(low, 1);
  block_.nodesSpan = Vec4(span, 0);
  bounds_ = Vec4(0.5f * (low + high), 0.5f * glm::length(span));
  std::vector<std::uint32_t> texels;
  texels.reserve(4 * nodes.size());
  for (const hair::GuideNode& node : nodes) {
    const Vec3 at = (node.position - low) / span;
    texels.push_back(glm::packUnorm2x16({at.x, at.y}));
    texels.push_back(glm::packUnorm2x16({at.z, 0}) | static_cast<std::uint32_t>(255 * saturate(node.wetness) + 0.5f) << 24);
    texels.push_back(glm::packSnorm2x16({node.frame.x, node.frame.y}));
    texels.push_back(glm::packSnorm2x16({node.frame.z, node.frame.w}));
  }
  nodes_.update(0, 0, nodesEach_, guideCount_, gl::bytesOf(texels), nodesEach_);
  wispsReady_ = 0;
  return 4 * texels.size();
}

void HairScalp::noteWay(std::span<const hair::GuideNode> nodes) {
  // Soaked hair is as much thinner as if it had gone that way, model units.
  constexpr float kWetWay = 0.1f;
  shown_.clear();
  for (const hair::GuideNode& node : nodes) shown_.emplace_back(node.position, kWetWay * node.wetness);
  wayFromShadow_ = cast_.size() == shown_.size() ? 0 : kNeverCast;
  for (std::size_t i = 0; i < std::min(cast_.size(), shown_.size()); ++i) wayFromShadow_ = std::max(wayFromShadow_, glm::distance(shown_[i], cast_[i]));
}

void HairScalp::castShadow() {
  cast_ = shown_;
  wayFromShadow_ = 0;
}

void HairScalp::bind(const shared::HairBlock& drawn) const {
  blockBuffer_.update(gl::bytesOf(drawn));
  blockBuffer_.bindAsBlock(FUR_HAIR_BINDING);
  nodes_.bind(FUR_UNIT_HAIR_NODES);
  wisps_.bind(FUR_UNIT_WISPS);
  points_.bind(FUR_UNIT_HAIR_POINTS);
  members_.bind(FUR_UNIT_MEMBER_STRANDS);
  strips_.bind(FUR_UNIT_STRIPS);
  ambient_.bind(FUR_UNIT_HAIR_AMBIENT);
  if (order_.bytes() > 0) order_.bind(FUR_UNIT_WISP_ORDER);
  if (hasSkin()) baseTangents_.bind(FUR_UNIT_BASE_TANGENTS);
}

void HairScalp::setLevel(const HairLevel& level) {
  level_ = level;
  block_.pointStep = static_cast<float>(level.step);
  block_.strandsDrawn = static_cast<float>(level.strands);
  block_.widening = static_cast<float>(strandCount_) / static_cast<float>(level.strands);
  block_.wispsDrawn = kFadingWisps * level.wispShare * static_cast<float>(wispCount_);
  // They lie over each other: a little narrower than would make up for it.
  block_.wispWidening = std::pow(level.wispShare, -0.7f);
}

int HairScalp::wispsDrawn() const {
  return std::min(static_cast<int>(std::ceil(kFadingWisps * level_.wispShare * static_cast<float>(wispCount_))), wispCount_);
}

void HairScalp::sortFrom(const Vec3& eye) {
  std::vector<std::pair<float, std::uint16_t>> far;
  const int drawn = wispsDrawn();
  far.reserve(static_cast<std::size_t>(drawn));
  for (const hair::Wisp& w : std::span(grown_).first(static_cast<std::size_t>(drawn))) {
    Vec3 middle(0);
    for (std::size_t k = 0; k < 3; ++k) middle += middles_[w.guides[k]] * w.weights[static_cast<int>(k)];
    far.emplace_back(-glm::distance(middle, eye), static_cast<std::uint16_t>(far.size()));
  }
  sortStably(far.begin(), far.end());
  std::vector<std::array<std::uint8_t, 2>> order;
  for (const auto& [depth, wisp] : far) order.push_back({static_cast<std::uint8_t>(wisp & 255), static_cast<std::uint8_t>(wisp >> 8)});
  if (order_.bytes() == 0) order_ = gl::Texture({gl::TexelFormat::RG8, wispCount_, 1, 0, gl::Filter::Nearest}, {});
  order_.update(0, 0, drawn, 1, gl::bytesOf(order), drawn);
}

bool HairScalp::update(Programs& programs) {
  if (wispsReady_ >= wispsDrawn()) return true;
  if (!programs.use(Shader::HairPoints, kPlain)) return false;
  bind(block_);
  pointsTarget_.bind();
  gl::setViewport(FUR_WISP_SEGMENTS + 1, wispsDrawn());
  gl::apply({.depthTest = false, .depthWrite = false, .cullBack = false});
  // Nobody may read what is drawn into.
  gl::unbindTexture(FUR_UNIT_HAIR_POINTS);
  gl::drawWithoutVertices(3);
  gl::bindPlatformFramebuffer();
  wispsReady_ = wispsDrawn();
  return true;
}

std::size_t HairScalp::bytes() const {
  return nodes_.bytes() + wisps_.bytes() + points_.bytes() + members_.bytes() + strips_.bytes() + ambient_.bytes() + baseTangents_.bytes() + order_.bytes();
}

}  // namespace fur::render
