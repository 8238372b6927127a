#include "hair/PlantGuides.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "core/NumberText.h"
#include "core/PortableMath.h"

namespace fur::hair {

namespace {

constexpr float kNear = 0.02f, kFar = 4.0f;  // how far off the skin a root is looked for, at first and at last

// The mean area that a dart holds, in squared distances to the next, as throwDarts() spreads them.
constexpr double kAreaOfDart = 1.15;

std::optional<geometry::SurfacePoint> footOf(const geometry::Surface& surface, const geometry::SurfaceQuery& query, const Vec3& root,
                                             const Vec3& away) {
  for (float reach = kNear; reach <= kFar; reach *= 3)
    for (const Vec3& side : {away, -away})
      if (auto foot = geometry::nearestPoint(surface, query, root, reach, side)) return foot;
  return std::nullopt;
}

// An arc of this length whose tip's direction has turned by the bend (dynamics/BendField.h has the same curve).
void bendChain(std::span<Vec3> chain, const Vec3& root, const Vec3& normal, Vec3 bend, float length) {
  bend -= normal * glm::dot(bend, normal);
  const float angle = std::min(glm::length(bend), groom::kMaxComb);
  const Vec3 over = normalizeOr(bend, Vec3(0));
  for (std::size_t i = 0; i < chain.size(); ++i) {
    const float t = static_cast<float>(i) / static_cast<float>(chain.size() - 1), turn = angle * t;
    // (sin x) / x and (1 - cos x) / x, whose limits at 0 are 1 and 0.
    const float along = turn > 1e-3f ? portableSin(turn) / turn : 1.0f, across = turn > 1e-3f ? (1 - portableCos(turn)) / turn : 0.5f * turn;
    chain[i] = root + (length * t) * (normal * along + over * across);
  }
}

Error badCount(int count) {
  return {ErrorId::TooLarge, "guides: " + decimal(count) + " of them; a scalp has 1 to " + decimal(kMostGuides)};
}

}  // namespace

Vec3 evenTangent(const Vec3& n) {
  // The shortest turn from y to n takes x there; at n = -y there is none.
  const Vec3 x(1, 0, 0), between = Vec3(n.x, n.y + 1, n.z);
  const Vec3 turned = n.y > -0.999f ? x - between * (n.x / (1 + n.y)) : x - n * n.x;
  return normalizeOr(turned - n * glm::dot(turned, n), Vec3(0, 0, 1));
}

Vec3 skinAt(const geometry::Surface& surface, const geometry::SurfaceQuery& query, const Vec3& root, const Vec3& way) {
  const auto foot = footOf(surface, query, root, normalizeOr(way, Vec3(0, 1, 0)));
  return foot ? geometry::positionAt(surface, *foot) : root;
}

std::vector<RootFrame> rootFrames(const geometry::Surface& surface, const geometry::SurfaceQuery& query, const Guides& guides) {
  std::vector<RootFrame> out(guides.count());
  for (std::size_t g = 0; g < out.size(); ++g) {
    const std::span<const Vec3> chain = guides.of(g);
    if (!std::isfinite(chain[0].x + chain[0].y + chain[0].z)) continue;
    out[g].position = chain[0];
    out[g].normal = normalizeOr(chain[1] - chain[0], Vec3(0, 1, 0));
    if (const auto foot = footOf(surface, query, chain[0], out[g].normal)) out[g].normal = geometry::normalAt(surface, *foot);
    out[g].tangent = evenTangent(out[g].normal);
  }
  return out;
}

int guidesAtSpacing(const ScalpSurface& scalp, float spacing) {
  const double count = areaOf(scalp) / (kAreaOfDart * static_cast<double>(spacing) * static_cast<double>(spacing));
  return count < static_cast<double>(kMostGuides) ? std::max(static_cast<int>(count + 0.5), 1) : static_cast<int>(kMostGuides);
}

Result<Guides> plantGuides(const ScalpSurface& scalp, const HairValues& values, int count, std::span<const Vec3> comb) {
  if (count < 1 || static_cast<std::size_t>(count) > kMostGuides) return badCount(count);
  // Another seed than wisps have, whose first would all stand at a guide.
  const std::vector<Dart> darts = throwDarts(scalp, count, static_cast<std::uint64_t>(values.seed) + 0x10000);
  if (darts.empty()) return Error{ErrorId::BadFile, "guides: the scalp covers nothing: its density is 0 everywhere"};
  Guides out;
  out.nodes = std::clamp(values.nodes, kLeastNodes, kMostNodes);
  out.positions.resize(darts.size() * static_cast<std::size_t>(out.nodes));
  out.flags.assign(darts.size(), 0);
  for (std::size_t g = 0; g < darts.size(); ++g) {
    Vec3 bend(0);
    const std::uint32_t* corners = &scalp.surface.indices[std::size_t{3} * darts[g].triangle];
    for (int k = 0; k < 3 && !comb.empty(); ++k) bend += comb[corners[k]] * darts[g].weights[k];
    bendChain(out.of(g), darts[g].position, darts[g].normal, bend, values.guideLength);
  }
  return out;
}

}  // namespace fur::hair
