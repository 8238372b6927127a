#include "hair/ShownNodes.h"

#include "hair/Lengths.h"

namespace fur::hair {

namespace {

struct QuatLanes {
  Lanes w{};
  Lanes3 v{};
};

QuatLanes frameOf(const FrameLanes& roots) {
  QuatLanes out;
  for (std::size_t lane = 0; lane < kLanes; ++lane) {
    const Quat q = glm::quat_cast(Mat3(laneOf(roots.x, lane), laneOf(roots.y, lane), laneOf(roots.z, lane)));
    out.w[lane] = q.w;
    setLane(out.v, lane, {q.x, q.y, q.z});
  }
  return out;
}

// As in frameNodes().
QuatLanes turnedOnTo(const QuatLanes& q, const Lanes3& from, const Lanes3& to) {
  const Lanes3 x{1.0f - 2.0f * (q.v.y * q.v.y + q.v.z * q.v.z), 2.0f * (q.v.x * q.v.y + q.w * q.v.z), 2.0f * (q.v.x * q.v.z - q.w * q.v.y)};
  Lanes w = 1.0f + dot(from, to);
  const LaneMask back = w <= 1e-6f;
  const Lanes3 axis = select(back, x, cross(from, to));
  w = back ? splat(0.0f) : w;
  const QuatLanes out{w * q.w - dot(axis, q.v), q.v * w + axis * q.w + cross(axis, q.v)};
  const Lanes size = 1.0f / sqrtOf(out.w * out.w + dot(out.v, out.v));
  return {out.w * size, out.v * size};
}

}  // namespace

void showBlock(const GuideBlocks& guides, std::size_t block, const FrameLanes& now, float share, std::span<GuideNode> shown) {
  const std::size_t first = guides.first(block), n = static_cast<std::size_t>(guides.nodes);
  const std::size_t lanes = std::min(kLanes, guides.guides - block * kLanes);
  Lanes3 nodes[kMostNodes], along[kMostNodes + 1];  // along: of the segment up to the node
  along[0] = now.y;
  for (std::size_t i = 0; i < n; ++i) {
    const Lanes3 a = guides.rootsBefore[block].placedBack(guides.earlier[first + i]);
    const Lanes3 b = guides.roots[block].placedBack(guides.positions[first + i]);
    nodes[i] = now.placed(a + (b - a) * splat(share));
    if (i == 0) continue;
    along[i] = directionOr(nodes[i] - nodes[i - 1], along[i - 1]);
    nodes[i] = nodes[i - 1] + along[i] * guides.lengths[first + i];
  }
  QuatLanes frame = frameOf(now);
  Lanes3 last = now.y;
  for (std::size_t i = 0; i < n; ++i) {
    const Lanes3& next = i + 1 < n ? along[i + 1] : along[i];
    const Lanes3 here = i == 0 ? next : directionOr(along[i] + next, next);
    frame = turnedOnTo(frame, last, here);
    last = here;
    for (std::size_t lane = 0; lane < lanes; ++lane) {
      GuideNode& to = shown[guides.guideAt[block * kLanes + lane] * n + i];
      to.position = laneOf(nodes[i], lane);
      to.frame = Quat(frame.w[lane], frame.v.x[lane], frame.v.y[lane], frame.v.z[lane]);
    }
  }
}

}  // namespace fur::hair
