// The shaders of long hair against their C++ twins: points of wisps, strands in them, and the triangles of their strips.
#include "tests/hair/TestScalps.h"

#include <bit>
#include <cmath>

#include "hair/AmbientOcclusion.h"
#include "hair/MemberStrands.h"
#include "hair/Wisps.h"
#include "render/ShaderSources.h"
#include "render/ShaderText.h"
#include "render/passes/hair/DrawnHair.h"
#include "tests/render/Picture.h"

namespace fur::render {
namespace {

// FUNCTION of hair_twins.frag.
enum Function { kPosition, kAlong, kAcross, kMemberPoint, kMemberOffset, kStripPlace, kStripAcross };
constexpr int kVertices = 6 * FUR_WISP_SEGMENTS;  // of a strip

// Sines and cosines of GPUs, as in TwinsGLTest.cpp.
constexpr float kHairGpuPrecision = 5e-4f;
// Four numbers of a frame are off by up to half of 1/32767 each; a quaternion that is off by 1/32767 turns by twice that.
constexpr float kPackedTurn = 2 / 32767.0f;
// Wetness has 255 steps, and is rounded in the node and in the point; and by so much is a wisp's half width off, as a share of it.
constexpr float kPackedWetness = 1.1f / 255, kPackedGather = hair::kWetGathers * kPackedWetness;

hair::HairValues ordinary() {
  hair::HairValues values;
  values.wisps = 12, values.strands = 9, values.nodes = 8;
  values.curl = 0, values.magnet = 0, values.rotation = 0;
  return values;
}

// Hair on a sphere whose guides swing to a side, the wetter the nearer to their tips, as a scalp in GL objects.
struct Head {
  explicit Head(const hair::HairValues& from = ordinary()) : sphere(geometry::makeSphere()), values(from) {
    guides = hair::plantGuides(sphere.scalp(), values, 20).value();
    for (std::size_t i = 0; i < guides.positions.size(); ++i) {
      const float t = static_cast<float>(i % each()) / static_cast<float>(each() - 1);
      guides.positions[i] += t * t * Vec3(0.3f, -0.1f, 0.05f * static_cast<float>(i / each() % 3));
    }
    const auto roots = sphere.roots(guides);
    wisps = hair::plantWisps(sphere.scalp(), guides, roots, values);
    nodes = hair::restNodes(guides, roots);
    for (std::size_t i = 0; i < nodes.size(); ++i) {
      nodes[i].wetness = static_cast<float>(i % 7) / 6;
      if (i % 2) nodes[i].frame = nodes[i].frame * -1.0f;  // the same frame
    }
    members = hair::memberStrands(values.strands, values);
    strips = hair::drawStrips(members, values.strandWidth, values.mostWidth, values.tipWidth);
    ambient = hair::ambientVisibility(sphere.scalp().surface, wisps, nodes, guides.nodes, values);
    upload();
  }
  void upload() {
    scalp.grow({values, wisps, members, strips, ambient, {}, static_cast<int>(guides.count()), guides.nodes});
    scalp.move(nodes);
    EXPECT_TRUE(scalp.update(programs)) << programs.error().message;
  }

  // What the function gives for each column and row; `pointStep` as the passes set it.
  std::vector<Vec4> evaluate(Function function, int columns, int rows, float pointStep = 1) const {
    const auto program = gl::Program::link("hair_twins", stageText(shaders::kScreenVert), stageText(shaders::kHairTwinsFrag),
                                           "#define FUNCTION " + std::to_string(function) + "\n");
    EXPECT_TRUE(program) << (program ? "" : program.error().message);
    program.value().bindBlock("FrameBlock", FUR_FRAME_BINDING);
    program.value().bindBlock("HairBlock", FUR_HAIR_BINDING);
    program.value().bindSampler("wisps", FUR_UNIT_WISPS);
    program.value().bindSampler("hairPoints", FUR_UNIT_HAIR_POINTS);
    program.value().bindSampler("memberStrands", FUR_UNIT_MEMBER_STRANDS);
    shared::FrameBlock frame{};
    frame.eye = Vec4(kEye, 1);
    const gl::Buffer frameBlock(gl::BufferKind::Uniform, gl::bytesOf(frame), true);
    frameBlock.bindAsBlock(FUR_FRAME_BINDING);
    shared::HairBlock block = scalp.block();
    block.strandsDrawn = static_cast<float>(scalp.strands());
    block.pointStep = pointStep;
    scalp.bind(block);
    const gl::Texture texture({gl::TexelFormat::RGBA32UI, columns, rows, 0, gl::Filter::Nearest}, {});
    const gl::Target target = gl::Target::toTexture(texture);
    target.bind();
    program.value().use();
    gl::setViewport(columns, rows);
    gl::apply({.depthTest = false, .depthWrite = false, .cullBack = false});
    gl::drawWithoutVertices(3);
    const std::vector<std::uint32_t> bits = gl::readWholeNumbers(columns, rows);
    std::vector<Vec4> values(bits.size() / 4);
    for (std::size_t i = 0; i < bits.size(); i += 4)
      for (int k = 0; k < 4; ++k) values[i / 4][k] = std::bit_cast<float>(bits[i + static_cast<std::size_t>(k)]);
    EXPECT_EQ(gl::takeError(), "");
    return values;
  }
  std::vector<Vec4> ofPoints(Function function) const { return evaluate(function, FUR_WISP_SEGMENTS + 1, static_cast<int>(wisps.size())); }

  hair::WispPoint point(std::size_t wisp, float t) const { return hair::wispPoint(wisps[wisp], nodes, guides.nodes, hair::shapeOf(values), t); }
  std::size_t each() const { return static_cast<std::size_t>(guides.nodes); }

  static constexpr Vec3 kEye{0.5f, 1, 4};
  test::Stage stage{16, 16};
  Programs programs;
  hair::test::TestScalp sphere;
  hair::HairValues values;
  hair::Guides guides;
  std::vector<hair::GuideNode> nodes;
  std::vector<hair::Wisp> wisps;
  std::vector<hair::MemberStrand> members;
  hair::StripPicture strips;
  std::vector<std::uint8_t> ambient;
  HairScalp scalp;
};

float heightOf(std::size_t point) { return static_cast<float>(point) / FUR_WISP_SEGMENTS; }

// How far points of a wisp may be off, as all is packed in 16 bits.
struct Precision {
  Precision(const Head& head, std::size_t wisp, float t) {
    const hair::Wisp& w = head.wisps[wisp];
    // From one number of a place to the next, along the box's diagonal; each is rounded by up to half of it.
    const float step = glm::length(Vec3(head.scalp.block().nodesSpan)) / 65535;
    const float segment = hair::lengthOf(head.guides.of(0)) / static_cast<float>(head.guides.nodes - 1);
    const float radius = w.width * head.values.curl, rate = 2 * kPi * head.values.curls;
    const float guideLength = w.length * static_cast<float>(head.guides.nodes - 1) * segment;
    // Of nodes, of which a wisp is the mean; of the curve's tangents between them, which are as long as a segment, and at most a
    // quarter of one aside; and of the point itself. Frames turn those tangents, the way from the guides and the curl.
    // Water moves a point to its nearest guide, by a wetness that is off by up to half of 1/255.
    const auto [drawn, drawnWay] = drawnTo(head, w, t);
    const float wetness = hair::kWetDraws * 0.5f / 255;
    position = wetness * t * (2 - t) * glm::length(drawn) + step * (0.5f + 0.25f + 0.5f) + kPackedTurn * (0.25f * segment + glm::length(w.offset) + radius) + kHairGpuPrecision * radius;
    // The way that a point takes with t. A cubic is at most half as steep again as the line between two nodes, and its tangents
    // count for at most 1 together; magnet and water move whole guides.
    const float way = 1.5f * step * guideLength / segment + kPackedTurn * guideLength + step * (glm::length(w.magnet) + 2 * hair::kWetDraws) +
                      (kHairGpuPrecision + kPackedTurn) * radius * rate + wetness * ((2 - 2 * t) * glm::length(drawn) + t * (2 - t) * glm::length(drawnWay));
    constexpr float kAside = 1e-2f;
    const float speed = glm::length(head.point(wisp, t + kAside).position - head.point(wisp, t - kAside).position) / (2 * kAside);
    along = way / speed + kPackedTurn;
    // What `along` leaves of the frame's x, which it is made perpendicular to.
    const Vec3 x = frameX(head, w, t), left = x - head.point(wisp, t).along * glm::dot(x, head.point(wisp, t).along);
    across = (along + kPackedTurn + kHairGpuPrecision) / glm::length(left);
  }
  float position, along, across;

 private:
  // What all the water there can be moves a point by, and that as t grows.
  static std::pair<Vec3, Vec3> drawnTo(const Head& head, const hair::Wisp& w, float t) {
    const float nodes = w.length * static_cast<float>(head.guides.nodes - 1);
    const Vec3 dry = w.weights + w.magnet * t, moves = hair::drawnWeights(dry) - dry;
    std::pair<Vec3, Vec3> sum{Vec3(0), Vec3(0)};
    for (int k = 0; k < 3; ++k) {
      const auto at = hair::guidePoint(std::span(head.nodes).subspan(w.guides[static_cast<std::size_t>(k)] * head.each(), head.each()), nodes * t, head.values.curve == 0);
      sum.first += at.position * moves[k];
      sum.second += at.step * (moves[k] * nodes);
    }
    return sum;
  }
  static Vec3 frameX(const Head& head, const hair::Wisp& w, float t) {
    const float node = w.length * static_cast<float>(head.guides.nodes - 1) * t;
    Quat frames[3];
    for (std::size_t k = 0; k < 3; ++k)
      frames[k] = hair::guidePoint(std::span(head.nodes).subspan(w.guides[k] * head.each(), head.each()), node, head.values.curve == 0).frame;
    const Vec3 dry = w.weights + w.magnet * t;
    const float wet = hair::kWetDraws * head.point(static_cast<std::size_t>(&w - head.wisps.data()), t).wetness * t * (2 - t);
    return hair::blendFrames(frames, dry + (hair::drawnWeights(dry) - dry) * wet) * Vec3(std::cos(w.rotation), 0, std::sin(w.rotation));
  }
};

void expectTwins(const hair::HairValues& values) {
  const Head head(values);
  ASSERT_EQ(head.wisps.size(), 12u);
  const auto positions = head.ofPoints(kPosition), along = head.ofPoints(kAlong), across = head.ofPoints(kAcross);
  for (std::size_t i = 0; i < positions.size(); ++i) {
    const std::size_t wisp = i / (FUR_WISP_SEGMENTS + 1);
    const float t = heightOf(i % (FUR_WISP_SEGMENTS + 1));
    const hair::WispPoint point = head.point(wisp, t);
    const Precision precision(head, wisp, t);
    ASSERT_LT(glm::distance(Vec3(positions[i]), point.position), precision.position) << "wisp " << wisp << " at " << t;
    ASSERT_LT(glm::distance(Vec3(along[i]), point.along), precision.along) << "wisp " << wisp << " at " << t;
    ASSERT_LT(glm::distance(Vec3(across[i]), point.across), precision.across) << "wisp " << wisp << " at " << t;
    ASSERT_NEAR(positions[i].w, point.wetness, kPackedWetness);
    ASSERT_EQ(along[i].w, head.wisps[wisp].random);
    ASSERT_EQ(across[i].w, static_cast<float>(hair::wispKind(head.wisps[wisp].random)));
  }
}

TEST(HairTwins, WispsFollowTheirGuidesByCurvesAndByLines) {
  hair::HairValues values = ordinary();
  expectTwins(values);
  values.curve = 1;
  expectTwins(values);
}

TEST(HairTwins, WispsTurnWanderAndCurl) {
  hair::HairValues turned = ordinary(), wandering = ordinary(), curled = ordinary();
  turned.rotation = 1.5f;
  expectTwins(turned);
  wandering.magnet = 1;
  expectTwins(wandering);
  curled.curl = 0.4f;
  expectTwins(curled);
  curled.rotation = 1, curled.magnet = 0.5f, curled.curve = 1;
  expectTwins(curled);
}

TEST(HairTwins, AShortWispEndsWithinItsGuides) {
  hair::HairValues values = ordinary();
  values.lengthVariation = 1;
  expectTwins(values);
}

TEST(HairTwins, StrandsRunWhereTheirPictureHasThem) {
  hair::HairValues values = ordinary();
  values.frizz = 1, values.stray = 0.5f, values.tipVariation = 1;
  const Head head(values);
  const auto drawn = head.evaluate(kMemberOffset, FUR_TWIN_SIZE, static_cast<int>(head.members.size()));
  for (std::size_t i = 0; i < drawn.size(); ++i) {
    const hair::MemberStrand& strand = head.members[i / FUR_TWIN_SIZE];
    const float t = static_cast<float>(i % FUR_TWIN_SIZE) / (FUR_TWIN_SIZE - 1);
    // Two sines of amplitudes 1 and 0.5, under waves of less than a third.
    ASSERT_LT(glm::distance(Vec2(drawn[i]), hair::memberOffset(strand, t)), 0.5f * kHairGpuPrecision);
    // A division, to 2.5 units in the last place (GLSL ES 3.00, 4.5.1), and its fourth power.
    ASSERT_NEAR(drawn[i].z, hair::memberWidth(strand, t), 4e-6f);
  }
}

TEST(HairTwins, StrandsLieInTheirWisp) {
  const Head head;
  const auto drawn = head.ofPoints(kMemberPoint);
  for (std::size_t i = 0; i < drawn.size(); ++i) {
    const std::size_t wisp = i / (FUR_WISP_SEGMENTS + 1);
    const float t = heightOf(i % (FUR_WISP_SEGMENTS + 1)), width = head.wisps[wisp].width;
    const Precision precision(head, wisp, t);
    const Vec3 place = hair::memberPoint(head.point(wisp, t), {0.7f, -0.4f}, width, hair::shapeOf(head.values), t);
    ASSERT_LT(glm::distance(Vec3(drawn[i]), place), precision.position + 0.5f * width * (precision.across + precision.along + kPackedGather));
  }
}

// --- strips ---

struct Strip {
  Strip(const Head& head, float step)
      : places(head.evaluate(kStripPlace, static_cast<int>(kVertices / step), static_cast<int>(head.wisps.size()), step)),
        sides(head.evaluate(kStripAcross, static_cast<int>(kVertices / step), static_cast<int>(head.wisps.size()), step)) {}
  std::vector<Vec4> places, sides;
};

// A corner of a segment: its point of the wisp and its side.
using Corner = std::pair<long, float>;

TEST(HairStrips, AreSplitAlongTheDiagonalThatTheWispSays) {
  Head head;
  for (std::size_t i = 0; i < head.wisps.size(); ++i) head.wisps[i].splits = 0x9d2cu * static_cast<std::uint32_t>(i) & 0xffffu;
  head.upload();
  for (const int step : {1, 2, 4}) {
    const Strip strip(head, static_cast<float>(step));
    for (std::size_t v = 0; v < strip.places.size(); v += 6) {
      const auto each = static_cast<std::size_t>(kVertices / step);
      const long segment = static_cast<long>(v % each / 6) * step;
      const auto corner = [&](std::size_t i) { return Corner(std::lround(strip.places[v + i].w * FUR_WISP_SEGMENTS), strip.sides[v + i].w); };
      std::vector<Corner> one{corner(0), corner(1), corner(2)}, other{corner(3), corner(4), corner(5)};
      std::sort(one.begin(), one.end());
      std::sort(other.begin(), other.end());
      std::vector<Corner> both, all;
      std::set_intersection(one.begin(), one.end(), other.begin(), other.end(), std::back_inserter(both));
      std::set_union(one.begin(), one.end(), other.begin(), other.end(), std::back_inserter(all));
      const Corner left(segment, -1.0f), right(segment, 1.0f), leftTip(segment + step, -1.0f), rightTip(segment + step, 1.0f);
      ASSERT_EQ(all, (std::vector<Corner>{left, right, leftTip, rightTip}));
      const bool fromLeft = head.wisps[v / each].splits >> segment & 1u;
      const std::vector<Corner> diagonal = fromLeft ? std::vector<Corner>{left, rightTip} : std::vector<Corner>{right, leftTip};
      ASSERT_EQ(both, diagonal) << "segment " << segment << " of " << v / each;
    }
  }
}

TEST(HairStrips, HaveTheirLeftAgainstAcrossAndFaceTheEye) {
  const Head head;
  const Strip strip(head, 1);
  for (std::size_t v = 0; v < strip.places.size(); ++v) {
    const std::size_t wisp = v / kVertices;
    const float t = strip.places[v].w;
    const hair::WispPoint point = head.point(wisp, t);
    const Precision precision(head, wisp, t);
    const Vec3 across(strip.sides[v]);
    const float half = 0.5f * head.wisps[wisp].width * hair::wispWidth(head.values.tipWidth, t, point.wetness);
    const float off = half * (precision.along + kPackedTurn);
    ASSERT_GT(glm::dot(across, point.across), -half * precision.across);
    // In the cross-section, an ellipse, and as far out as the outline that the eye sees of it.
    ASSERT_LT(std::abs(glm::dot(across, point.along)), off);
    const Vec3 way = normalizeOr(glm::cross(point.along, Head::kEye - point.position), Vec3(0));
    const float a = half * glm::dot(way, point.across), b = half * head.values.depth * glm::dot(way, point.out);
    ASSERT_NEAR(std::abs(glm::dot(across, way)), std::sqrt(a * a + b * b), half * precision.across + 0.5f * head.wisps[wisp].width * kPackedGather);
    const Vec3 place = point.position + across * (strip.sides[v].w * hair::kStripReach);
    ASSERT_LT(glm::distance(Vec3(strip.places[v]), place), precision.position);
  }
}

TEST(DrawnHair, HasItsShadowDrawnAnewOnceItHasMovedByAPixel) {
  Head head;
  DrawnHair hair;
  hair.setScalps(1);
  hair.grow(0, {head.values, head.wisps, head.members, head.strips, head.ambient, {}, static_cast<int>(head.guides.count()), head.guides.nodes});
  Frame near;
  near.width = near.height = 400;
  near.camera.eye = Vec3(0, 0, 4);
  Frame far = near;
  far.camera.eye.z = 40;
  const auto revisionAfter = [&](float way, const Frame& frame) {
    std::vector<hair::GuideNode> nodes = head.nodes;
    for (hair::GuideNode& node : nodes) node.position.x += way;
    hair.move(0, nodes);
    hair.fit(frame);
    return hair.revision();
  };
  const unsigned long far0 = revisionAfter(0, far);
  EXPECT_EQ(revisionAfter(0, far), far0);
  EXPECT_EQ(revisionAfter(0.008f, far), far0);
  const unsigned long near0 = revisionAfter(0.008f, near);
  EXPECT_NE(near0, far0) << "the same way is more of a picture from near";
  EXPECT_EQ(revisionAfter(0.0081f, near), near0);
  EXPECT_NE(revisionAfter(0.2f, near), near0);
}

}  // namespace
}  // namespace fur::render
