// Reference nodes in the spaces of neighbouring segments, from root to tip (Halen & Wester 2007, 4.3).
//
// H pulls a node to where the segment before has it and, more weakly, to where the segment after has it, and lets nothing pull the
// segments in turn. Such chains have no energy: waves that run along them grow, the faster the stiffer (H 5.9 sees it). Here what
// pulls a node pulls the segment that holds its reference node as much the other way. That is the downward spring: it belongs to
// the next node but one, and so is the weaker one, as stiffness falls towards the tip. The springs are solved implicitly, so that
// they hold long hair and any stiffness.
//
// H takes each segment's tangent across its normal, T = B x N, which ends where the strand has turned by a right angle; parallel
// transport is the same to first order, has no such place, and is how hair is drawn (frameNodes).
#include "hair/Lengths.h"
#include "hair/MotionModels.h"

namespace fur::hair {

namespace {

// Damping of bending for its stiffness, s.
constexpr float kBendDamping = 0.01f;
// Of h^2 k / m, times the fourth power of the tangent of a turn.
constexpr float kStiffestTurn = 0.1f;

}  // namespace

void CascadeRests::assign(const GuideBlocks& guides) {
  bends.assign(guides.nodeCount(), Lanes3{});
  directions = bends;
  ratios.assign(guides.nodeCount(), Lanes{});
  stiffest = ratios;
  for (std::size_t block = 0; block < guides.blocks; ++block) {
    const std::size_t first = guides.first(block);
    SegmentFrame frame{splat(Vec3(1, 0, 0)), splat(Vec3(0, 1, 0))};
    for (std::size_t i = 1; i < static_cast<std::size_t>(guides.nodes); ++i) {
      const std::size_t at = first + i;
      const Lanes3 segment = guides.rests[at] - guides.rests[at - 1];
      if (i > 1) {
        Lanes3 bend = frame.turnedBack(segment);
        directions[at] = bend * guides.lengthInverses[at];
        ratios[at] = min(max(bend.y * guides.lengthInverses[at - 1], splat(-2.0f)), splat(2.0f));
        bend.y = bend.y - ratios[at] * guides.lengths[at - 1];
        bends[at] = bend;
        const Lanes sideways = sqrtOf(bend.x * bend.x + bend.z * bend.z) * guides.lengthInverses[at - 1];
        const Lanes turn = max(sideways, ratios[at] < 0.0f ? splat(1.0f) : splat(0.1f));
        stiffest[at] = min(kStiffestTurn / (turn * turn * turn * turn), splat(kStiffest));
      }
      frame = frame.onTo(segment * guides.lengthInverses[at]);
    }
  }
}

// A node's distance from its reference node is b[i] = p[i] - (1 + r) p[i-1] + r p[i-2] - c, where c, what the rest shape bends,
// goes with the frame of the segment before. The step's end minimizes |p - predicted|^2 + sum w |b|^2: a symmetric system with
// two bands beside the diagonal, for the three coordinates alike. Predicted is with lengths kept, so that what the strand's tension
// holds is not the springs' to hold.
void cascadeModel(const FourGuides& four, const StepValues& values, const CascadeRests& rests, std::size_t first, Lanes3* next) {
  const int n = four.nodes;
  Lanes diagonal[kMostNodes + 2], beside[kMostNodes + 2], second[kMostNodes + 2];
  Lanes3 right[kMostNodes + 2];
  SegmentFrame frame{four.root->x, four.root->y}, frameBefore{four.rootBefore->x, four.rootBefore->y};
  for (int i = 2; i < n; ++i) {
    next[i] = four.stepped(values, i, four.acceleration(values, i, four.lightness(i)));
    diagonal[i] = splat(1.0f);
    beside[i] = second[i] = Lanes{};
    right[i] = Lanes3{};
  }
  relaxLengths(four.lengths, n, four.positions, next);
  right[0] = right[1] = Lanes3{};
  diagonal[0] = diagonal[1] = beside[0] = beside[1] = second[0] = second[1] = Lanes{};
  for (int i = 2; i < n; ++i) {
    const std::size_t at = first + static_cast<std::size_t>(i);
    frame = frame.onTo(directionOr(next[i - 1] - next[i - 2], frame.y));
    frameBefore = frameBefore.onTo((four.positions[i - 1] - four.positions[i - 2]) * four.lengthInverses[i - 1]);
    const Lanes spring = min(four.stiffness[i] * four.lightness(i) * (values.tilt * kStep * kStep), rests.stiffest[at]);
    const Lanes r = rests.ratios[at], m = -1.0f - r, w = spring * (1.0f + kBendDamping / kStep);
    const auto bend = [&](const Lanes3* p, const SegmentFrame& f) { return p[i] + p[i - 1] * m + p[i - 2] * r - f.turned(rests.bends[at]); };
    const Lanes3 b = bend(next, frame) * w - bend(four.positions, frameBefore) * (w - spring);
    right[i] = right[i] - b;
    right[i - 1] = right[i - 1] - b * m;
    right[i - 2] = right[i - 2] - b * r;
    diagonal[i] += w;
    diagonal[i - 1] += w * m * m;
    diagonal[i - 2] += w * r * r;
    beside[i - 1] += w * m;
    beside[i - 2] += w * m * r;
    second[i - 2] += w * r;
  }
  // L D L^T; beside[i] and second[i] become the factors from i to i + 1 and i + 2.
  for (int i = 2; i < n; ++i) {
    const Lanes inverse = 1.0f / diagonal[i], toNext = beside[i] * inverse, toSecond = second[i] * inverse;
    if (i + 1 < n) {
      diagonal[i + 1] -= beside[i] * toNext;
      beside[i + 1] -= beside[i] * toSecond;
      right[i + 1] = right[i + 1] - right[i] * toNext;
    }
    if (i + 2 < n) {
      diagonal[i + 2] -= second[i] * toSecond;
      right[i + 2] = right[i + 2] - right[i] * toSecond;
    }
    right[i] = right[i] * inverse;
    beside[i] = toNext;
    second[i] = toSecond;
  }
  for (int i = n - 1; i >= 2; --i) {
    if (i + 1 < n) right[i] = right[i] - right[i + 1] * beside[i];
    if (i + 2 < n) right[i] = right[i] - right[i + 2] * second[i];
    next[i] = next[i] + right[i];
  }
}

}  // namespace fur::hair
