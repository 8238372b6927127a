#include "wet/ChartBorders.h"

#include <algorithm>

#include "geometry/Adjacency.h"

namespace fur::wet {

namespace {

using geometry::SurfaceVertex;
using Mat2 = glm::mat2;

// An edge as one of its charts has it.
struct BorderEdge {
  const SurfaceVertex &from, &to;
};

// How fur coordinates change along the edge, as its ends say, and by a step along the skin across it.
Mat2 furSteps(const BorderEdge& edge, const Vec3& across) {
  return {edge.to.fur - edge.from.fur, 0.5f * Vec2(glm::dot(edge.from.gradS + edge.to.gradS, across), glm::dot(edge.from.gradT + edge.to.gradT, across))};
}
Mat2 atlasFromFur(const BorderEdge& edge) {
  const Vec4& m = edge.from.atlasFromFur;
  return {m.x, m.y, m.z, m.w};
}

constexpr float kMostStretched = 4;

// What leads from one chart to the other, FUR_BORDER_TEXELS of it. False: nothing does.
bool findWay(const BorderEdge& here, const BorderEdge& there, Vec4* texels) {
  const Vec3 across = glm::cross(here.from.normal, here.to.position - here.from.position);
  const Mat2 steps = furSteps(here, across), stepsThere = furSteps(there, across);
  const float stretched = glm::determinant(stepsThere) / glm::determinant(steps);
  if (!(stretched > 1 / kMostStretched && stretched < kMostStretched)) return false;
  const Mat2 fur = stepsThere * glm::inverse(steps), atlas = atlasFromFur(there) * fur * glm::inverse(atlasFromFur(here));
  texels[0] = Vec4(atlas[0], atlas[1]);
  texels[1] = Vec4(fur[0], fur[1]);
  // Both as the middles of the edge lie.
  texels[2] = 0.5f * Vec4(there.from.atlas + there.to.atlas - atlas * (here.from.atlas + here.to.atlas),
                          there.from.fur + there.to.fur - fur * (here.from.fur + here.to.fur));
  return true;
}

float squaredFrom(const BorderEdge& edge, const Vec2& at) {
  const Vec2 way = edge.to.atlas - edge.from.atlas, from = at - edge.from.atlas;
  const Vec2 apart = from - way * saturate(glm::dot(from, way) / std::max(glm::dot(way, way), 1e-20f));
  return glm::dot(apart, apart);
}

}  // namespace

ChartBorders::ChartBorders(const geometry::Surface& surface, const SurfaceWetting& wetting) : gutter_(wetting.atlas().gutter()) {
  for (auto& [texel, border] : gutter_) border = 0;
  const geometry::Weld weld = geometry::weldVertices({surface.vertices.data(), surface.trueVertexCount});
  std::vector<std::uint32_t> verticesAt(weld.count, 0), indices;
  for (const std::uint32_t id : weld.idOf) ++verticesAt[id];
  // Triangles at borders, whose points have a vertex in each chart.
  for (std::size_t i = 0; i < surface.indices.size(); i += 3) {
    int points = 0;
    for (std::size_t k = 0; k < 3; ++k) points += verticesAt[weld.idOf[surface.indices[i + k]]] > 1;
    for (std::size_t k = 0; k < 3 && points > 1; ++k) indices.push_back(surface.indices[i + k]);
  }

  const int size = wetting.atlas().size();
  const auto& charts = wetting.chartOfTexel();
  std::vector<float> nearest(gutter_.size(), 1e9f);  // squared
  std::uint32_t count = 0;
  const auto gutterFrom = [this](std::uint32_t texel) { return std::lower_bound(gutter_.begin(), gutter_.end(), std::pair(texel, std::uint32_t{0})); };
  const auto add = [&](const BorderEdge& here, const BorderEdge& there) {
    if (count == FUR_MOST_BORDERS) return;
    texels_.resize(FUR_BORDER_TEXELS * (count + 1));
    if (!findWay(here, there, &texels_[FUR_BORDER_TEXELS * count])) return;
    ++count;
    constexpr float kReach = geometry::AtlasTexels::kGutter + 1.0f;
    const auto texels = static_cast<float>(size);
    const Vec2 low = glm::max(glm::min(here.from.atlas, here.to.atlas) * texels - kReach, 0.0f),
               high = glm::min(glm::max(here.from.atlas, here.to.atlas) * texels + kReach, texels - 1);
    for (int y = static_cast<int>(low.y); y <= static_cast<int>(high.y); ++y) {
      const auto texelIn = [&](float x) { return static_cast<std::uint32_t>(y * size + static_cast<int>(x)); };
      const std::uint32_t last = texelIn(high.x);
      for (auto at = gutterFrom(texelIn(low.x)); at != gutter_.end() && at->first <= last; ++at) {
        const Vec2 middle = Vec2(at->first % static_cast<std::uint32_t>(size), y) + 0.5f;
        const float squared = squaredFrom(here, middle / texels);
        float& least = nearest[static_cast<std::size_t>(at - gutter_.begin())];
        if (charts[at->first] != here.from.chart || squared >= least) continue;
        least = squared;
        at->second = count;
      }
    }
  };
  const auto corner = [&](const geometry::TriangleSide& side, std::uint32_t k) -> const SurfaceVertex& {
    return surface.vertices[indices[std::size_t{3} * side.triangle + (side.side + k) % 3]];
  };
  const std::vector<geometry::TriangleSide> sides = geometry::sortedSides(indices, weld);
  for (std::size_t i = 0; i + 1 < sides.size(); ++i) {
    const geometry::TriangleSide &one = sides[i], &two = sides[i + 1];
    if (one.low != two.low || one.high != two.high || one.forwards == two.forwards) continue;
    const BorderEdge a{corner(one, 0), corner(one, 1)}, b{corner(two, 1), corner(two, 0)};
    if (a.from.atlas == b.from.atlas && a.to.atlas == b.to.atlas) continue;
    add(a, b);
    add(b, a);
  }
  const auto across = static_cast<std::size_t>(size);
  texels_.resize((FUR_BORDER_TEXELS * count + across - 1) / across * across);
}

}  // namespace fur::wet
