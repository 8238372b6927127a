#include "hair/GuideBlocks.h"

#include <algorithm>
#include <cmath>
#include <cstring>

#include "hair/AdaptiveDetail.h"

namespace fur::hair {

namespace {

// Where two segments have turned back on each other further than this, their lengths would hold them there.
constexpr float kLeastBendCosine = -0.5f;


// Node 0 and 1 go with the root. Of the others: the acceleration that holds up the rest shape under gravity (0, -1, 0) where the
// segments pull but do not push. Hair that hangs straight down needs none, and swings as a pendulum does; hair that stands needs
// all. This is by how far the reference nodes are raised, times k / m.
void findRaises(std::span<const Vec3> chain, std::span<Vec3> raises) {
  Vec3 pullOfNext(0);  // by the segment to the next node
  for (std::size_t i = chain.size(); i-- > 0;) {
    const Vec3 inward = i > 0 ? normalizeOr(chain[i - 1] - chain[i], Vec3(0)) : Vec3(0);
    const Vec3 load = pullOfNext + Vec3(0, -1, 0);
    const Vec3 pull = inward * std::max(0.0f, -glm::dot(load, inward));
    raises[i] = -(load + pull);
    pullOfNext = -pull;
  }
}

// The same for segments that do not hang from each other (the forest): each needs what lies across it, and all if it stands.
void findRaisesAlone(std::span<const Vec3> chain, std::span<Vec3> raises) {
  for (std::size_t i = 0; i < chain.size(); ++i) {
    const Vec3 along = i > 0 ? normalizeOr(chain[i] - chain[i - 1], Vec3(0)) : Vec3(0);
    raises[i] = Vec3(0, 1, 0) - along * std::min(0.0f, along.y);
  }
}

Vec3 inFrame(const RootFrame& frame, const Vec3& v) {
  return {glm::dot(v, frame.tangent), glm::dot(v, frame.normal), glm::dot(v, glm::cross(frame.tangent, frame.normal))};
}

}  // namespace

void FrameLanes::set(std::size_t lane, const RootFrame& frame) {
  setLane(origin, lane, frame.position);
  setLane(x, lane, frame.tangent);
  setLane(y, lane, frame.normal);
  setLane(z, lane, glm::cross(frame.tangent, frame.normal));
}

RootFrame FrameLanes::at(std::size_t lane) const { return {laneOf(origin, lane), laneOf(y, lane), laneOf(x, lane)}; }

FrameLanes mix(const FrameLanes& a, const FrameLanes& b, float share) {
  const Lanes s = splat(share);
  FrameLanes out;
  out.origin = a.origin + (b.origin - a.origin) * s;
  out.y = normalize(a.y + (b.y - a.y) * s);
  out.x = normalize(across(a.x + (b.x - a.x) * s, out.y));
  // Half a turn within a step passes through no frame at all.
  const LaneMask lost = (dot(out.y, out.y) < 0.5f) | (dot(out.x, out.x) < 0.5f);
  out.x = select(lost, b.x, out.x);
  out.y = select(lost, b.y, out.y);
  out.z = cross(out.x, out.y);
  return out;
}

bool same(const FrameLanes& a, const FrameLanes& b) { return std::memcmp(&a, &b, sizeof a) == 0; }

void GuideBlocks::assign(const Guides& from, std::span<const RootFrame> rootsAsMade) {
  nodes = from.nodes;
  guides = from.count();
  blocks = (guides + kLanes - 1) / kLanes;
  const auto n = static_cast<std::size_t>(nodes);
  std::vector<Vec3> places(guides);
  for (std::size_t i = 0; i < guides; ++i) places[i] = rootsAsMade[i].position;
  guideAt = clusteredOrder(places, from.flags);
  if (guides > 0) guideAt.resize(blocks * kLanes, guideAt.back());
  roots.assign(blocks, {});
  still.assign(blocks, LaneMask{});
  reach.assign(blocks, Lanes{});
  windMiddle.assign(blocks, Lanes3{});
  windTip = windMiddle;
  for (auto* vectors : {&rests, &raises, &raisesAlone, &positions, &pushes}) vectors->assign(nodeCount(), Lanes3{});
  for (auto* numbers : {&lengths, &lengthInverses, &leastCosines, &fromRoot, &stiffness, &wetness}) numbers->assign(nodeCount(), Lanes{});
  std::vector<Vec3> chain(n), raised(n), raisedAlone(n);
  for (std::size_t slot = 0; slot < blocks * kLanes; ++slot) {
    const std::size_t guide = guideAt[slot], block = slot / kLanes, lane = slot % kLanes;
    const RootFrame& root = rootsAsMade[guide];
    for (std::size_t i = 0; i < n; ++i) chain[i] = finite(from.of(guide)[i]) ? from.of(guide)[i] : i > 0 ? chain[i - 1] : root.position;
    findRaises(chain, raised);
    findRaisesAlone(chain, raisedAlone);
    roots[block].set(lane, root);
    still[block][lane] = (from.flags[guide] & kStatic) ? -1 : 0;
    float sum = glm::length(chain[0] - root.position);
    reach[block][lane] = sum;
    Vec3 lastAlong = root.normal;
    for (std::size_t i = 0; i < n; ++i) {
      const std::size_t at = first(block) + i;
      setLane(rests[at], lane, inFrame(root, chain[i] - root.position));
      setLane(raises[at], lane, inFrame(root, raised[i]));
      setLane(raisesAlone[at], lane, inFrame(root, raisedAlone[i]));
      setLane(positions[at], lane, chain[i]);
      if (i == 0) continue;
      const float length = glm::length(chain[i] - chain[i - 1]);
      lengths[at][lane] = length;
      lengthInverses[at][lane] = 1.0f / std::max(length, 1e-6f);
      const Vec3 along = (chain[i] - chain[i - 1]) * lengthInverses[at][lane];
      leastCosines[at][lane] = std::max(-1.0f, std::min(kLeastBendCosine, glm::dot(along, lastAlong) - 0.1f));
      lastAlong = along;
      fromRoot[at][lane] = fromRoot[at - 1][lane] + length;
      reach[block][lane] += length;
    }
  }
  rootsBefore = roots;
  earlier = before = goals = positions;
}

}  // namespace fur::hair
