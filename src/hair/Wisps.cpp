#include "hair/Wisps.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/Assert.h"
#include "core/PortableMath.h"
#include "core/Random.h"
#include "hair/MemberStrands.h"
#include "hair/WispGuides.h"

namespace fur::hair {

namespace {

constexpr float kCurlGrown = 0.4f;  // height at which a curl has its radius

// A point among three by chance, evenly.
Vec3 anyWeights(Random& random) {
  const float root = std::sqrt(random.uniform()), way = random.uniform();
  return {1 - root, root * (1 - way), root * way};
}

Quat rootFrameOf(const Wisp& wisp, std::span<const GuideNode> nodes, std::size_t each) {
  return blendFrames({nodes[wisp.guides[0] * each].frame, nodes[wisp.guides[1] * each].frame, nodes[wisp.guides[2] * each].frame},
                     wisp.weights);
}

// How far the plane stays the same over the fold between the triangles of a quad: 1 where it is flat.
float flatness(const Vec3& a, const Vec3& b, const Vec3& apex0, const Vec3& apex1) {
  const Vec3 n0 = normalizeOr(glm::cross(b - a, apex0 - a), Vec3(0)), n1 = normalizeOr(glm::cross(apex1 - a, b - a), Vec3(0));
  return glm::dot(n0, n1);
}

std::uint32_t splitsOf(const Wisp& wisp, std::span<const GuideNode> nodes, int nodesEach, const WispShape& shape) {
  constexpr float kAlike = 1e-4f;  // flat either way
  Vec3 left[kStripSegments + 1], right[kStripSegments + 1];
  for (int s = 0; s <= kStripSegments; ++s) {
    const float t = static_cast<float>(s) / kStripSegments;
    const WispPoint point = wispPoint(wisp, nodes, nodesEach, shape, t);
    left[s] = memberPoint(point, {-kStripReach, 0}, wisp.width, shape, t);
    right[s] = memberPoint(point, {kStripReach, 0}, wisp.width, shape, t);
  }
  std::uint32_t splits = 0;
  for (int s = 0; s < kStripSegments; ++s) {
    const float one = flatness(right[s], left[s + 1], left[s], right[s + 1]);
    const float other = flatness(left[s], right[s + 1], left[s + 1], right[s]);
    if (other > one + kAlike) splits |= 1u << s;
  }
  return splits;
}

Wisp wispOf(const Dart& dart, const Vec4& map, const Following& following, const HairValues& values, Random random) {
  Wisp wisp;
  wisp.root = dart.position;
  wisp.normal = dart.normal;
  wisp.atlas = dart.atlas;
  wisp.guides = following.guides;
  wisp.weightsByPlace = following.weights;
  wisp.magnetByPlace = values.magnet * (anyWeights(random) - following.weights);
  wisp.rotation = values.rotation * map.w * random.uniform(-1, 1);
  wisp.width = glm::mix(values.leastWidth, values.mostWidth, map.y);
  const float length = glm::mix(values.leastLength, 1.0f, map.z) * (1 - values.lengthVariation * random.uniform());
  wisp.length = glm::clamp(length, kLeastWispLength, 1.0f);
  wisp.random = random.uniform();
  return wisp;
}

// The way a guide leaves the skin, along the skin: 0 for one that stands upright, of length 1 for one that lies.
Vec3 leanOf(std::span<const Vec3> chain, const Vec3& normal) {
  const Vec3 way = normalizeOr(chain[std::max<std::size_t>(chain.size() / 3, 1)] - chain[0], normal);
  return way - normal * glm::dot(way, normal);
}

// By more than 60 degrees; guides that hardly lean do not.
bool leanApart(const Vec3& a, const Vec3& b) {
  const float both = glm::length(a) * glm::length(b);
  return both > 0.1f && glm::dot(a, b) < 0.5f * both;
}

// Between guides that lean apart hair would run through the head: they leave their shares to the one that has most.
void followOneSide(Wisp& wisp, const std::vector<Vec3>& leans) {
  wisp.weights = wisp.weightsByPlace;
  wisp.magnet = wisp.magnetByPlace;
  int most = 0;
  for (int k = 1; k < 3; ++k)
    if (wisp.weights[k] > wisp.weights[most]) most = k;
  for (int k = 0; k < 3; ++k) {
    if (k == most || !leanApart(leans[wisp.guides[static_cast<std::size_t>(k)]], leans[wisp.guides[static_cast<std::size_t>(most)]])) continue;
    wisp.weights[most] += std::exchange(wisp.weights[k], 0.0f);
    wisp.magnet[most] += std::exchange(wisp.magnet[k], 0.0f);
  }
}

}  // namespace

std::vector<Wisp> plantWisps(const ScalpSurface& scalp, const Guides& guides, std::span<const RootFrame> roots, const HairValues& values) {
  FUR_ASSERT(roots.size() == guides.count(), "plantWisps()", "a root for each guide", roots.size());
  std::vector<Wisp> wisps;
  if (guides.count() == 0) return wisps;
  const WispGuides choice(roots);
  const auto seed = static_cast<std::uint64_t>(values.seed);
  for (const Dart& dart : throwDarts(scalp, values.wisps, seed)) {
    const Following following = choice.at(dart.position, dart.normal);
    wisps.push_back(wispOf(dart, scalp.scalp.at(dart.atlas), following, values, Random(seed, wisps.size() + 1000)));
  }
  followGuides(wisps, guides, roots, shapeOf(values));
  return wisps;
}

void followGuides(std::span<Wisp> wisps, const Guides& guides, std::span<const RootFrame> roots, const WispShape& shape) {
  const auto each = static_cast<std::size_t>(guides.nodes);
  const std::vector<GuideNode> nodes = restNodes(guides, roots);
  std::vector<Vec3> leans(guides.count());
  for (std::size_t g = 0; g < guides.count(); ++g) leans[g] = leanOf(guides.of(g), roots[g].normal);
  for (Wisp& wisp : wisps) {
    followOneSide(wisp, leans);
    Vec3 root(0);
    for (std::size_t k = 0; k < 3; ++k) root += guides.root(wisp.guides[k]) * wisp.weights[static_cast<int>(k)];
    wisp.offset = glm::conjugate(rootFrameOf(wisp, nodes, each)) * (wisp.root - root);
    wisp.splits = splitsOf(wisp, nodes, guides.nodes, shape);
  }
}

WispShape shapeOf(const HairValues& values) { return {values.curve == 0, values.curl, values.curls, values.tipWidth, values.depth}; }

Quat mixFrames(const Quat& a, const Quat& b, float share) {
  const float way = glm::dot(a, b) < 0 ? -share : share;
  return a * (1 - share) + b * way;
}

Quat blendFrames(const Quat (&frames)[3], const Vec3& weights) {
  Quat sum = frames[0] * weights.x;
  for (int k = 1; k < 3; ++k) sum = sum + frames[k] * (glm::dot(frames[0], frames[k]) < 0 ? -weights[k] : weights[k]);
  return glm::normalize(sum);
}

GuidePoint guidePoint(std::span<const GuideNode> chain, float node, bool cubic) {
  const auto last = static_cast<float>(chain.size() - 2);
  const float first = glm::clamp(std::floor(node), 0.0f, last), f = node - first;
  const GuideNode &a = chain[static_cast<std::size_t>(first)], &b = chain[static_cast<std::size_t>(first) + 1];
  const Vec3 way = b.position - a.position, up(0, 1, 0);
  const float length = glm::length(way);
  const Vec3 from = a.frame * up * length, to = b.frame * up * length;
  GuidePoint out;
  out.frame = mixFrames(a.frame, b.frame, f);
  out.wetness = glm::mix(a.wetness, b.wetness, f);
  if (!cubic) {
    // Of shading: smooth over the nodes.
    out.position = a.position + way * f;
    out.step = glm::mix(from, to, f);
    return out;
  }
  out.position = a.position + way * (f * f * (3 - 2 * f)) + (f * (1 - f)) * (from * (1 - f) - to * f);
  out.step = way * (6 * f * (1 - f)) + from * ((1 - f) * (1 - 3 * f)) + to * (f * (3 * f - 2));
  return out;
}

Vec3 drawnWeights(const Vec3& weights) {
  const Vec3 above = glm::max(weights, Vec3(0)), squares = above * above;
  return squares * squares / glm::dot(squares, squares);
}

Curl curlAt(const WispShape& shape, float random, float t) {
  if (shape.curl <= 0) return {};
  const float u = saturate(t / kCurlGrown), radius = shape.curl * u * u * (3 - 2 * u), grows = shape.curl * 6 * u * (1 - u) / kCurlGrown;
  const float turn = 2 * kPi * shape.curls, angle = turn * t + 2 * kPi * random;
  const Vec2 way(portableCos(angle), portableSin(angle));
  return {radius * way, grows * way + radius * turn * Vec2(-way.y, way.x)};
}

WispPoint wispPoint(const Wisp& wisp, std::span<const GuideNode> nodes, int nodesEach, const WispShape& shape, float t) {
  const auto each = static_cast<std::size_t>(nodesEach);
  const float perHeight = wisp.length * static_cast<float>(nodesEach - 1);
  const Vec3 dry = wisp.weights + wisp.magnet * t;
  GuidePoint guide[3];
  Vec3 position(0), step(0);
  WispPoint out;
  for (int k = 0; k < 3; ++k) {
    guide[k] = guidePoint(nodes.subspan(wisp.guides[static_cast<std::size_t>(k)] * each, each), perHeight * t, shape.cubic);
    out.wetness += guide[k].wetness * dry[k];
  }
  const Vec3 drawn = drawnWeights(dry) - dry, weights = dry + drawn * (kWetDraws * out.wetness * t * (2 - t));
  const Vec3 changes = wisp.magnet + drawn * (kWetDraws * out.wetness * (2 - 2 * t));
  for (int k = 0; k < 3; ++k) {
    position += guide[k].position * weights[k];
    step += (guide[k].step * weights[k]) * perHeight + guide[k].position * changes[k];
  }
  const Quat frame = blendFrames({guide[0].frame, guide[1].frame, guide[2].frame}, weights);
  const float cosine = portableCos(wisp.rotation), sine = portableSin(wisp.rotation);
  const Vec3 x = frame * Vec3(cosine, 0, sine), z = frame * Vec3(-sine, 0, cosine);
  const Curl curl = curlAt(shape, wisp.random, t);
  out.position = position + rootFrameOf(wisp, nodes, each) * wisp.offset + wisp.width * (x * curl.offset.x + z * curl.offset.y);
  out.along = normalizeOr(step + wisp.width * (x * curl.step.x + z * curl.step.y), frame * Vec3(0, 1, 0));
  out.across = normalizeOr(x - out.along * glm::dot(x, out.along), z);
  out.out = glm::cross(out.across, out.along);
  return out;
}

Vec3 memberPoint(const WispPoint& point, const Vec2& member, float width, const WispShape& shape, float t) {
  const float half = 0.5f * width * wispWidth(shape.tipWidth, t, point.wetness);
  return point.position + half * (point.across * member.x + point.out * (shape.depth * member.y));
}

}  // namespace fur::hair
