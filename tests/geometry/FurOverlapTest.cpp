// Charts that reach over their borders: every strand once, nothing moved, little drawn twice.
#include <gtest/gtest.h>

#include <map>

#include "geometry/FurOverlap.h"
#include "geometry/SurfaceChecks.h"
#include "geometry/Weld.h"

namespace fur::geometry {
namespace {

Mesh makeCube() {
  Mesh mesh;
  for (int i = 0; i < 8; ++i) mesh.positions.push_back(Vec3(i & 1, i >> 1 & 1, i >> 2) - 0.5f);
  for (const auto& [a, b, c, d] : {std::array{0u, 2u, 3u, 1u}, {4u, 5u, 7u, 6u}, {0u, 1u, 5u, 4u}, {2u, 6u, 7u, 3u},
                                   {0u, 4u, 6u, 2u}, {1u, 3u, 7u, 5u}})
    mesh.indices.insert(mesh.indices.end(), {a, b, c, a, c, d});
  fitToUnitSphere(mesh);
  return mesh;
}

// A strip of triangles that only touch at points, beside a fan of single charts round one vertex.
Mesh makeScraps() {
  Mesh mesh;
  Random random(9);
  for (std::uint32_t i = 0; i < 120; ++i) {
    const Vec3 shared(0.02f * static_cast<float>(i), 0, 0);
    const auto first = static_cast<std::uint32_t>(mesh.positions.size());
    for (int k = 0; k < 2; ++k)
      mesh.positions.push_back(shared + Vec3(random.uniform(-0.05f, 0.05f), random.uniform(-0.05f, 0.05f), random.uniform(-0.05f, 0.05f)));
    mesh.positions.push_back(shared);
    mesh.positions.push_back(shared + Vec3(0.02f, 0, 0));
    mesh.indices.insert(mesh.indices.end(), {first, first + 2, first + 3, first + 1, first + 3, first + 2});
  }
  return mesh;
}

struct OverlapShape {
  const char* name;
  Surface surface;
};

// Made once for all tests: they only look.
const std::vector<OverlapShape>& overlapShapes() {
  static const std::vector<OverlapShape> shapes = {{"lump", built(makeLump())},
                                                   {"torus", built(makeTorus())},
                                                   {"fine sphere", built(withoutUv(makeSphere(120, 60)))},
                                                   {"coarse sphere", built(withoutUv(makeSphere(14, 7)))},
                                                   {"cube-mapped lump", buildSurface(makeLump(), FurMapping::Cube).value()},
                                                   {"cube-mapped torus", buildSurface(makeTorus(), FurMapping::Cube).value()},
                                                   {"cube", built(makeCube())},
                                                   {"scraps", built(makeScraps())}};
  return shapes;
}

// The triangles of furIndices on each true triangle, by their corners' positions.
std::vector<std::vector<std::uint32_t>> layersOf(const Surface& surface) {
  std::vector<Vec3> positions;
  for (const SurfaceVertex& v : surface.vertices) positions.push_back(v.position);
  const Weld weld = weldPositions(positions);
  const auto key = [&](const std::uint32_t* v) { return std::array{weld.idOf[v[0]], weld.idOf[v[1]], weld.idOf[v[2]]}; };
  std::map<std::array<std::uint32_t, 3>, std::uint32_t> triangles;
  for (std::uint32_t t = 0; t < surface.triangleCount(); ++t) triangles[key(&surface.indices[3 * t])] = t;
  std::vector<std::vector<std::uint32_t>> layers(surface.triangleCount());
  for (std::uint32_t i = 0; i < surface.furIndices.size(); i += 3) layers[triangles.at(key(&surface.furIndices[i]))].push_back(i);
  return layers;
}

TEST(FurOverlap, ShowsEveryStrandOnceEverywhere) {
  Random random(4);
  for (const auto& [name, surface] : overlapShapes()) {
    for (const auto& layers : layersOf(surface)) {
      for (int sample = 0; sample < 8; ++sample) {
        float u = random.uniform(), v = random.uniform();
        if (u + v > 1) u = 1 - u, v = 1 - v;
        std::vector<std::pair<float, float>> parts;
        for (const std::uint32_t i : layers) {
          const auto at = [&, &surface = surface](std::uint32_t k) { return surface.vertices[surface.furIndices[i + k]].strands; };
          const Vec2 ends = glm::clamp(at(0) * (1 - u - v) + at(1) * u + at(2) * v, 0.0f, 1.0f);
          if (ends.x < ends.y) parts.emplace_back(ends.x, ends.y);
        }
        std::sort(parts.begin(), parts.end());
        float shown = 0;
        // Interpolation rounds numbers of size 16 to a few millionths.
        for (const auto& [from, to] : parts) {
          ASSERT_NEAR(from, shown, 1e-5f) << name;
          shown = to;
        }
        ASSERT_NEAR(shown, 1.0f, 1e-5f) << name;
      }
    }
  }
}

TEST(FurOverlap, CopiesTrueVerticesButForTheirFur) {
  for (const auto& [name, surface] : overlapShapes()) {
    for (std::size_t t = 0; const auto& layers : layersOf(surface)) {
      for (const std::uint32_t i : layers)
        for (std::uint32_t k = 0; k < 3; ++k) {
          const SurfaceVertex &copy = surface.vertices[surface.furIndices[i + k]], &real = surface.vertices[surface.indices[3 * t + k]];
          ASSERT_EQ(copy.position, real.position) << name;
          ASSERT_EQ(copy.normal, real.normal) << name;
          ASSERT_EQ(copy.uv, real.uv) << name;
          ASSERT_EQ(copy.atlas, real.atlas) << name;
          ASSERT_EQ(copy.chart, real.chart) << name;
        }
      ++t;
    }
  }
}

TEST(FurOverlap, KeepsCopiesBehindTheTrueVertices) {
  for (const auto& [name, surface] : overlapShapes()) {
    for (const std::uint32_t v : surface.indices) ASSERT_LT(v, surface.trueVertexCount) << name;
    for (const SurfaceEdge& edge : surface.edges) ASSERT_LT(std::max(edge.a, edge.b), surface.trueVertexCount) << name;
    for (const std::uint32_t v : surface.furIndices) ASSERT_LT(v, surface.vertices.size()) << name;
  }
}

TEST(FurOverlap, UnfoldsCopiesAtTheirTrueSize) {
  // Each triangle keeps its size but for what its border side has already (the sphere's rims are stretched
  // by a third), and where ways round a vertex meet again.
  for (const Mesh& mesh : {withoutUv(makeSphere()), makeLump(), makeTorus()}) {
    const Surface surface = built(mesh);
    std::size_t copied = 0, even = 0;
    for (std::size_t i = 0; i < surface.furIndices.size(); ++i) {
      const SurfaceVertex& a = surface.vertices[surface.furIndices[i]];
      const SurfaceVertex& b = surface.vertices[surface.furIndices[i % 3 == 2 ? i - 2 : i + 1]];
      if (std::min(surface.furIndices[i], surface.furIndices[i % 3 == 2 ? i - 2 : i + 1]) < surface.trueVertexCount) continue;
      const float ratio = glm::length(b.fur - a.fur) / glm::length(b.position - a.position);
      ++copied;
      even += ratio > 0.75f && ratio < 1.33f;
    }
    EXPECT_GT(copied, 300u);
    EXPECT_GT(static_cast<double>(even), 0.9 * static_cast<double>(copied));
  }
}

// Where a chart's true triangles meet its copies: the same fur and the same gradients on both sides.
TEST(FurOverlap, GoesOnSmoothlyAcrossTheBorder) {
  const Surface surface = built(makeLump());
  std::map<std::array<float, 5>, const SurfaceVertex*> own;
  const auto key = [](const SurfaceVertex& v) { return std::array{v.position.x, v.position.y, v.position.z, v.fur.x, v.fur.y}; };
  for (std::size_t i = 0; i < surface.trueVertexCount; ++i) own[key(surface.vertices[i])] = &surface.vertices[i];
  std::size_t onBorder = 0;
  for (std::size_t i = surface.trueVertexCount; i < surface.vertices.size(); ++i) {
    const SurfaceVertex& copy = surface.vertices[i];
    const auto found = own.find(key(copy));
    if (found == own.end()) continue;
    ++onBorder;
    ASSERT_EQ(copy.strands.y, std::max(1.0f, copy.strands.x));  // here all strands are this chart's or a lower one's
    ASSERT_EQ(copy.gradS, found->second->gradS);
    ASSERT_EQ(copy.gradT, found->second->gradT);
  }
  EXPECT_GT(onBorder, 100u);
}

TEST(FurOverlap, ReachesAsFarAsItSays) {
  const Surface surface = built(withoutUv(makeTorus(150, 68)));  // atlas charts and fur charts are the same
  std::vector<std::pair<std::uint32_t, Vec3>> borders;           // a lower chart's strands only
  for (std::size_t i = 0; i < surface.trueVertexCount; ++i)
    if (const SurfaceVertex& v = surface.vertices[i]; v.strands.x >= 1.0f) borders.emplace_back(v.chart, v.position);
  std::size_t within = 0;
  for (std::size_t i = 0; i < surface.trueVertexCount; ++i) {
    const SurfaceVertex& v = surface.vertices[i];
    float nearest = 1e9f, own = 1e9f;
    for (const auto& [chart, position] : borders) {
      const Vec3 way = position - v.position;
      nearest = std::min(nearest, glm::dot(way, way));
      if (chart == v.chart) own = std::min(own, glm::dot(way, way));
    }
    nearest = std::sqrt(nearest);
    own = std::sqrt(own);
    if (nearest > kReach) ASSERT_LE(v.strands.x, 0.0f);
    // Paths along the edges of a grid are up to 1.5 times as long as the straight way.
    if (own < 0.5f * kReach) ASSERT_GT(v.strands.x, 0.2f);
    within += own < 0.5f * kReach;
  }
  EXPECT_GT(within, 300u);
}

TEST(FurOverlap, DrawsLittleTwice) {
  for (const auto& [name, surface] : overlapShapes()) {
    if (std::string(name).find("cube-mapped") == 0 || surface.triangleCount() < 2000) continue;
    double all = 0.0, drawn = 0.0;
    const auto layers = layersOf(surface);
    for (std::size_t t = 0; t < layers.size(); ++t) {
      all += areaOf(surface, t);
      drawn += areaOf(surface, t) * static_cast<double>(layers[t].size());
    }
    // Edges of these shapes are up to three times kReach long, and a zone is at least a triangle wide.
    EXPECT_LT(drawn, 1.6 * all) << name;
  }
}

TEST(FurOverlap, GivesCoarseShapesHardBorders) {
  // Twelve triangles, each with all corners on a border.
  const Surface cube = built(makeCube());
  EXPECT_LE(cube.furIndices.size(), 2 * cube.indices.size());
  // A hundred scraps of two triangles, a fan: copies stay bounded.
  for (const auto& [name, surface] : overlapShapes())
    EXPECT_LE(surface.furIndices.size(), (1 + kMostCopies) * surface.indices.size()) << name;
}

TEST(FurOverlap, IsTheSameOnEveryRun) {
  const Surface first = built(makeLump()), second = built(makeLump());
  EXPECT_EQ(first.furIndices, second.furIndices);
  ASSERT_EQ(first.vertices.size(), second.vertices.size());
  for (std::size_t i = 0; i < first.vertices.size(); ++i) {
    ASSERT_EQ(first.vertices[i].fur, second.vertices[i].fur);
    ASSERT_EQ(first.vertices[i].strands, second.vertices[i].strands);
  }
}

}  // namespace
}  // namespace fur::geometry
