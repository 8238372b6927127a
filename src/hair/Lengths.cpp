#include "hair/Lengths.h"

namespace fur::hair {

namespace {

constexpr int kNewtonSteps = 2;

// Row s of the system: -d[s].g[s-1], 2 d[s].g[s], -d[s].g[s+1], the first with a fixed end; d: segments, g: where they pull.
void newtonStep(const Lanes* lengths, int nodes, const Lanes3* g, Lanes3* p) {
  Lanes upper[kMostNodes], share[kMostNodes];
  upper[1] = share[1] = Lanes{};
  for (int s = 2; s < nodes; ++s) {
    const Lanes3 d = p[s] - p[s - 1];
    const Lanes diagonal = dot(d, g[s]) * splat(s == 2 ? 1.0f : 2.0f), before = s == 2 ? Lanes{} : dot(d, g[s - 1]);
    const Lanes pivot = 1.0f / max(diagonal + before * upper[s - 1], 0.01f * diagonal + 1e-12f);
    share[s] = (0.5f * (lengths[s] * lengths[s] - dot(d, d)) + before * share[s - 1]) * pivot;
    upper[s] = s + 1 == nodes ? Lanes{} : -dot(d, g[s + 1]) * pivot;
  }
  Lanes pull{};
  Lanes3 moved{};  // by the segment after
  for (int s = nodes - 1; s >= 2; --s) {
    pull = share[s] - upper[s] * pull;
    // What has collapsed or been torn out is left to the pass that follows.
    pull = min(max(pull, splat(-1.0f)), splat(1.0f));
    const Lanes3 here = g[s] * pull;
    p[s] = p[s] + here - moved;
    moved = here;
  }
}

}  // namespace

void relaxLengths(const Lanes* lengths, int nodes, const Lanes3* was, Lanes3* p) {
  Lanes3 g[kMostNodes];
  for (int s = 2; s < nodes; ++s) {
    const Lanes3 before = was[s] - was[s - 1], now = p[s] - p[s - 1];
    g[s] = select(dot(before, now) > 0.5f * lengths[s] * lengths[s], before, now);
  }
  for (int i = 0; i < kNewtonSteps; ++i) newtonStep(lengths, nodes, g, p);
}

}  // namespace fur::hair
