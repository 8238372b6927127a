#include "hair/Hanging.h"

#include <algorithm>
#include <cmath>

namespace fur::hair {

namespace {

struct Skin {
  const geometry::Surface& surface;
  const geometry::SurfaceQuery& query;
  float clearance;

  // Where `at` lies below the skin, or nearer to it than the clearance: the way out of it.
  struct Depth {
    Vec3 normal{0};
    float toOutside = 0;
  };
  // `outward`: the side of the skin; `reach`: how deep it may lie.
  Depth depthOf(const Vec3& at, const Vec3& outward, float reach) const {
    const auto near = geometry::nearestPoint(surface, query, at, reach, outward);
    if (!near) return {};
    const Vec3 normal = normalizeOr(normalAt(surface, *near), outward);
    return {normal, std::max(clearance - glm::dot(at - positionAt(surface, *near), normal), 0.0f)};
  }
};

// Where a segment goes that wants to go into the skin: along it, and where it has no way there, `aside`.
Vec3 alongSkin(const Vec3& wanted, const Vec3& normal, const Vec3& aside) {
  const auto across = [&](const Vec3& v) { return v - normal * glm::dot(v, normal); };
  const Vec3 slide = across(wanted);
  return normalizeOr(slide + across(aside) * std::max(1 - 2 * glm::length(slide), 0.0f), normalizeOr(across(aside), wanted));
}

bool hangOne(std::span<Vec3> chain, const Skin& skin, const Vec3& down, float share, const Vec3& aside) {
  constexpr float kDeepest = 0.6f;  // model units: no segment gets deeper
  const std::vector<Vec3> before(chain.begin(), chain.end());
  const Vec3 outward = normalizeOr(chain[1] - chain[0], Vec3(0, 1, 0));
  for (std::size_t i = 1; i < chain.size(); ++i) {
    const Vec3 segment = before[i] - before[i - 1];
    const float length = glm::length(segment), up = static_cast<float>(i) / static_cast<float>(chain.size() - 1);
    const float turn = std::min(share * (share + 2 * up), 1.0f);
    Vec3 way = normalizeOr(glm::mix(normalizeOr(segment, outward), down, turn), aside);
    if (skin.depthOf(chain[i - 1] + way * length, outward, kDeepest).toOutside > 0) {
      const Skin::Depth here = skin.depthOf(chain[i - 1], outward, kDeepest);
      if (glm::dot(way, here.normal) < 0) way = alongSkin(way, here.normal, aside);
    }
    const Vec3 end = chain[i - 1] + way * length;
    const Skin::Depth depth = skin.depthOf(end, outward, kDeepest);
    chain[i] = chain[i - 1] + normalizeOr(end + depth.normal * depth.toOutside - chain[i - 1], way) * length;
  }
  return !std::equal(chain.begin(), chain.end(), before.begin());
}

// From a root along the skin to the place, in steps.
std::vector<Vec3> wayTo(const Vec3& root, Vec3 outward, const Skin& skin, const Vec3& place) {
  constexpr float kStep = 0.03f, kReach = 0.1f;  // model units
  constexpr int kMostSteps = 400;
  std::vector<Vec3> way{root};
  for (int i = 0; i < kMostSteps && glm::distance(way.back(), place) > kStep; ++i) {
    Vec3 ahead = normalizeOr(place - way.back(), outward);
    if (const Skin::Depth depth = skin.depthOf(way.back() + ahead * kStep, outward, kReach); depth.toOutside > 0) {
      outward = depth.normal;
      if (glm::dot(ahead, outward) < 0) ahead = alongSkin(ahead, outward, Vec3(0, 1, 0));
    }
    const Vec3 next = way.back() + ahead * kStep;
    const Skin::Depth depth = skin.depthOf(next, outward, kReach);
    way.push_back(next + depth.normal * depth.toOutside);
  }
  way.push_back(place);
  return way;
}

std::vector<Vec3> firstShare(const std::vector<Vec3>& way, float share) {
  float left = lengthOf(way) * share;
  std::vector<Vec3> out{way[0]};
  for (std::size_t i = 1; i < way.size() && left > 0; ++i) {
    const float length = glm::distance(way[i - 1], way[i]);
    out.push_back(length > left ? glm::mix(way[i - 1], way[i], left / length) : way[i]);
    left -= length;
  }
  return out;
}

// Calls edit(guide, chain) for each that is shown; whether one of them changed anything.
template <class Edit>
bool forShown(Guides& guides, Edit edit) {
  bool changed = false;
  for (std::size_t g = 0; g < guides.count(); ++g)
    if (!(guides.flags[g] & kHidden)) changed |= edit(g, guides.of(g));
  return changed;
}

}  // namespace

bool hang(Guides& guides, const geometry::Surface& surface, const geometry::SurfaceQuery& query, const Vec3& down, float share, float clearance) {
  const Vec3 way = normalizeOr(down, Vec3(0));
  if (way == Vec3(0) || !(share > 0)) return false;
  Vec3 middle(0);
  for (std::size_t g = 0; g < guides.count(); ++g) middle += guides.root(g) / static_cast<float>(guides.count());
  return forShown(guides, [&](std::size_t, std::span<Vec3> chain) {
    const Vec3 off = chain[0] - middle;
    return hangOne(chain, {surface, query, clearance}, way, std::min(share, 1.0f), normalizeOr(off - way * glm::dot(off, way), Vec3(0, 0, -1)));
  });
}

bool part(Guides& guides, std::span<const RootFrame> roots, const Vec3& line, float share) {
  if (!(share > 0)) return false;
  return forShown(guides, [&](std::size_t g, std::span<Vec3> chain) {
    const Vec3 normal = roots[g].normal, way = normalizeOr(chain[1] - chain[0], normal), side(chain[0].x < line.x ? -1.0f : 1.0f, 0, 0);
    const Vec3 wanted = normalizeOr(way * (1 - std::min(share, 1.0f)) + (side - normal * glm::dot(side, normal)) * share, way);
    const Quat turn(way, wanted);
    for (Vec3& p : chain.subspan(1)) p = chain[0] + turn * (p - chain[0]);
    return wanted != way;
  });
}

bool gather(Guides& guides, const geometry::Surface& surface, const geometry::SurfaceQuery& query, const Vec3& place, float share, float clearance) {
  if (!(share > 0) || !std::isfinite(place.x + place.y + place.z)) return false;
  return forShown(guides, [&](std::size_t, std::span<Vec3> chain) {
    const std::vector<Vec3> way = wayTo(chain[0], normalizeOr(chain[1] - chain[0], Vec3(0, 1, 0)), {surface, query, clearance}, place);
    const std::vector<Vec3> even = resampled(firstShare(way, std::min(share, 1.0f)), static_cast<int>(chain.size()));
    std::copy(even.begin(), even.end(), chain.begin());
    return true;
  });
}

bool bundle(Guides& guides, float share) {
  if (!(share > 0)) return false;
  const auto each = static_cast<std::size_t>(guides.nodes);
  std::vector<Vec3> mean(each, Vec3(0));
  float count = 0;
  forShown(guides, [&](std::size_t, std::span<Vec3> chain) {
    for (std::size_t i = 0; i < each; ++i) mean[i] += chain[i];
    ++count;
    return false;
  });
  for (Vec3& p : mean) p /= std::max(count, 1.0f);
  // The cross-section turns with the mean, and no more than that.
  std::vector<Quat> turns{Quat(1, 0, 0, 0)};
  for (std::size_t i = 2; i < each; ++i) {
    const Vec3 before = normalizeOr(mean[i - 1] - mean[i - 2], Vec3(0, 1, 0));
    turns.push_back(Quat(before, normalizeOr(mean[i] - mean[i - 1], before)) * turns.back());
  }
  return forShown(guides, [&](std::size_t, std::span<Vec3> chain) {
    const Vec3 off = chain[0] - mean[0];
    for (std::size_t i = 1; i < each; ++i) chain[i] = glm::mix(chain[i], mean[i] + turns[i - 1] * off, std::min(share, 1.0f));
    return true;
  });
}

}  // namespace fur::hair
