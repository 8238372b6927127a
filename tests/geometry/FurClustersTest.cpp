// The patches that shells are drawn by.
#include <gtest/gtest.h>

#include <set>
#include <tuple>

#include "core/Random.h"
#include "geometry/SurfaceChecks.h"

namespace fur::geometry {
namespace {

using Corner = std::tuple<float, float, float>;

std::array<Corner, 3> place(const Surface& s, const std::vector<std::uint32_t>& indices, std::size_t first) {
  std::array<Corner, 3> out;
  for (std::size_t k = 0; k < 3; ++k) {
    const Vec3& p = s.vertices[indices[first + k]].position;
    out[k] = {p.x, p.y, p.z};
  }
  std::sort(out.begin(), out.end());
  return out;
}

TEST(FurClusters, HoldEveryTriangleOnceAndLeaveNothingOut) {
  const Surface s = built(makeLump());
  std::size_t own = 0, all = 0;
  for (const FurCluster& c : s.furClusters) {
    ASSERT_EQ(c.ownFirst, own);
    ASSERT_GT(c.ownCount, 0u);
    ASSERT_LE(c.ownCount, 3 * kClusterTriangles);
    own += c.ownCount;
    if (c.count == 0) continue;
    ASSERT_EQ(c.first, all);
    all += c.count;
  }
  EXPECT_EQ(own, s.indices.size());
  EXPECT_EQ(all, s.furIndices.size());
  std::multiset<std::array<Corner, 3>> before, after;
  for (std::size_t i = 0; i < s.indices.size(); i += 3)
    before.insert(place(s, s.indices, i)), after.insert(place(s, s.ownFurIndices, i));
  EXPECT_EQ(before, after);
}

TEST(FurClusters, KeepCopiesWithTheTriangleTheyLieOnLaterChartsFirst) {
  const Surface s = built(makeLump());
  std::size_t copies = 0;
  for (const FurCluster& c : s.furClusters) {
    std::set<std::array<Corner, 3>> mine;
    for (std::size_t i = c.ownFirst; i < c.ownFirst + c.ownCount; i += 3) mine.insert(place(s, s.ownFurIndices, i));
    bool copying = false;
    for (std::size_t i = c.first; i < c.first + c.count; i += 3) {
      ASSERT_TRUE(mine.count(place(s, s.furIndices, i)));
      const bool copy = s.furIndices[i] >= s.trueVertexCount;
      ASSERT_TRUE(copy || !copying) << "a triangle of the surface after a copy";
      copying = copy;
      copies += copy;
    }
  }
  EXPECT_GT(copies, 0u);
}

TEST(FurClusters, LoseTheirBaldTrianglesAndKeepTheOthers) {
  const Surface s = built(makeLump());
  const auto above = [&](const std::vector<std::uint32_t>& all) {
    std::vector<std::uint32_t> left;
    for (std::size_t i = 0; i < all.size(); i += 3)
      if (s.vertices[all[i]].position.y > 0.2f) left.insert(left.end(), {all[i], all[i + 1], all[i + 2]});
    return left;
  };
  const FurPatches patches = remainingPatches(s, above(s.furIndices), above(s.ownFurIndices));
  std::size_t all = 0, own = 0;
  for (const FurCluster& c : patches.clusters) all += c.count, own += c.ownCount;
  EXPECT_EQ(all, patches.indices.size());
  EXPECT_EQ(own, patches.ownIndices.size());
  EXPECT_LT(patches.clusters.size(), s.furClusters.size());
  for (const FurCluster& c : patches.clusters)
    for (std::size_t i = c.first; i < c.first + c.count; ++i)
      ASSERT_LE(glm::length(s.vertices[patches.indices[i]].position - c.centre), c.radius + 1e-5f);
}

TEST(FurClusters, AreSmallAndFaceOneWay) {
  const Surface s = built(makeLump());
  for (const FurCluster& c : s.furClusters) {
    for (std::size_t i = c.ownFirst; i < c.ownFirst + c.ownCount; ++i) {
      const SurfaceVertex& v = s.vertices[s.ownFurIndices[i]];
      ASSERT_LE(glm::length(v.position - c.centre), c.radius + 1e-5f);
      ASSERT_GE(glm::dot(v.normal, c.axis), c.cosine - 1e-5f);
    }
    ASSERT_LT(c.radius, 0.4f);
  }
}

TEST(FurClusters, AreSeenWhereverFurOfThemFacesTheEye) {
  const Surface s = built(makeLump());
  const float length = 0.2f;
  Random random(7);
  for (int trial = 0; trial < 50; ++trial) {
    const Vec3 eye = glm::normalize(Vec3(random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1)) + Vec3(1e-3f)) *
                     random.uniform(1.5f, 5.0f);
    const auto order = clustersNearToFar(s.furClusters, eye, length);
    const std::set<std::uint32_t> seen(order.begin(), order.end());
    for (std::uint32_t i = 0; i < s.furClusters.size(); ++i) {
      if (seen.count(i)) continue;
      const FurCluster& c = s.furClusters[i];
      for (std::size_t k = c.ownFirst; k < c.ownFirst + c.ownCount; k += 3) {
        Vec3 p[3];
        for (std::size_t j = 0; j < 3; ++j) {
          const SurfaceVertex& v = s.vertices[s.ownFurIndices[k + j]];
          p[j] = v.position + length * v.normal;
        }
        const Vec3 raised = glm::cross(p[1] - p[0], p[2] - p[0]);
        // In a crease the raised surface folds over; no fur is drawn that high there.
        if (glm::dot(glm::normalize(raised), c.axis) < c.cosine - 0.05f) continue;
        ASSERT_LE(glm::dot(raised, eye - p[0]), 0.0f) << "cluster " << i;
      }
    }
    EXPECT_LT(order.size(), s.furClusters.size());
    for (std::size_t i = 1; i < order.size(); ++i)
      ASSERT_LE(glm::length(eye - s.furClusters[order[i - 1]].centre), glm::length(eye - s.furClusters[order[i]].centre));
  }
}

}  // namespace
}  // namespace fur::geometry
