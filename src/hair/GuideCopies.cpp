// Shapes of guides that are taken to other places, and which guides there are.
#include <algorithm>
#include <string>

#include "core/NumberText.h"
#include "hair/GuideChain.h"
#include "hair/GuideEdits.h"

namespace fur::hair {

namespace {

Mat3 axesOf(const RootFrame& root) { return Mat3(root.tangent, root.normal, glm::cross(root.tangent, root.normal)); }

void append(Guides& to, std::span<const Vec3> chain, std::uint8_t flags) {
  to.positions.insert(to.positions.end(), chain.begin(), chain.end());
  to.flags.push_back(flags);
}

}  // namespace

bool copyShape(Guides& guides, std::span<const RootFrame> roots, const groom::Brush& brush, std::size_t from) {
  if (!isUsable(brush) || from >= guides.count()) return false;
  const std::vector<Vec3> shape(guides.of(from).begin(), guides.of(from).end());
  bool changed = false;
  for (std::size_t g = 0; g < guides.count(); ++g) {
    const std::span<Vec3> chain = guides.of(g);
    const float w = g == from || guides.flags[g] & kHidden ? 0.0f : weightOfLine(brush, chain);
    if (!(w > 0)) continue;
    const Mat3 turn = axesOf(roots[g]) * glm::transpose(axesOf(roots[from]));
    Vec3 before = chain[0];
    for (std::size_t i = 1; i < chain.size(); ++i) {
      const Vec3 own = chain[i] - before, other = turn * (shape[i] - shape[i - 1]), mixed = glm::mix(own, other, w);
      before = chain[i];
      const float length = glm::mix(glm::length(own), glm::length(other), w);
      const Vec3 to = chain[i - 1] + (w < 1 ? normalizeOr(mixed, normalizeOr(other, Vec3(0, 1, 0))) * length : other);
      changed |= to != chain[i];
      chain[i] = to;
    }
  }
  return changed;
}

Result<Guides> mirrored(const Guides& guides, const Plane& plane, float onPlane) {
  Guides out;
  out.nodes = guides.nodes;
  for (std::size_t g = 0; g < guides.count(); ++g) {
    const float side = glm::dot(guides.root(g) - plane.point, plane.normal);
    if (side < -onPlane) continue;
    append(out, guides.of(g), guides.flags[g]);
    if (side <= onPlane) continue;
    std::vector<Vec3> other(guides.of(g).begin(), guides.of(g).end());
    for (Vec3& p : other) p -= plane.normal * (2 * glm::dot(p - plane.point, plane.normal));
    append(out, other, guides.flags[g]);
  }
  if (out.count() > kMostGuides)
    return Error{ErrorId::TooLarge, "guides: mirrored they are " + decimal(out.count()) + "; a scalp has at most " + decimal(kMostGuides)};
  return out;
}

bool setFlag(Guides& guides, const groom::Brush& brush, GuideFlag flag, bool on) {
  bool changed = false;
  for (std::size_t g = 0; isUsable(brush) && g < guides.count(); ++g) {
    if ((guides.flags[g] & kHidden && flag != kHidden) || !(weightOfLine(brush, guides.of(g)) > 0)) continue;
    const auto now = static_cast<std::uint8_t>(on ? guides.flags[g] | flag : guides.flags[g] & ~flag);
    changed |= now != guides.flags[g];
    guides.flags[g] = now;
  }
  return changed;
}

bool setFlag(Guides& guides, GuideFlag flag, bool on) {
  const std::vector<std::uint8_t> before = guides.flags;
  for (std::uint8_t& flags : guides.flags) flags = static_cast<std::uint8_t>(on ? flags | flag : flags & ~flag);
  return before != guides.flags;
}

bool removeGuides(Guides& guides, const groom::Brush& brush) {
  if (!isUsable(brush)) return false;
  Guides kept;
  kept.nodes = guides.nodes;
  for (std::size_t g = 0; g < guides.count(); ++g)
    if (guides.flags[g] & kHidden || !(weightOfLine(brush, guides.of(g)) > 0)) append(kept, guides.of(g), guides.flags[g]);
  if (kept.count() == guides.count()) return false;
  guides = std::move(kept);
  return true;
}

}  // namespace fur::hair
