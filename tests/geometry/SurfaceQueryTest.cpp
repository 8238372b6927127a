// The hierarchy against looking at every triangle.
#include <gtest/gtest.h>

#include "geometry/SurfaceChecks.h"
#include "geometry/SurfaceQuery.h"

namespace fur::geometry {
namespace {

Vec3 randomPoint(Random& random, float reach) {
  return Vec3(random.uniform(-reach, reach), random.uniform(-reach, reach), random.uniform(-reach, reach));
}

std::optional<float> nearestByForce(const Surface& surface, const Vec3& origin, const Vec3& direction) {
  std::optional<float> nearest;
  for (std::size_t t = 0; t < surface.triangleCount(); ++t) {
    const auto v = cornersOf(surface, t);
    const glm::dvec3 a = v[0]->position, e1 = glm::dvec3(v[1]->position) - a, e2 = glm::dvec3(v[2]->position) - a;
    const glm::dvec3 d = direction, p = glm::cross(d, e2);
    const double det = glm::dot(e1, p);
    if (det <= 0.0) continue;
    const glm::dvec3 s = glm::dvec3(origin) - a, q = glm::cross(s, e1);
    const double u = glm::dot(s, p) / det, w = glm::dot(d, q) / det, distance = glm::dot(e2, q) / det;
    if (u < 0.0 || w < 0.0 || u + w > 1.0 || distance <= 0.0) continue;
    if (!nearest || distance < *nearest) nearest = static_cast<float>(distance);
  }
  return nearest;
}

TEST(SurfaceQuery, AgreesWithEveryTriangleOnRays) {
  const Surface surface = built(makeLump(48, 24));
  const SurfaceQuery query(surface);
  Random random(3);
  int hits = 0;
  for (int i = 0; i < 3000; ++i) {
    const Vec3 origin = randomPoint(random, 2.0f), direction = randomPoint(random, 1.0f);
    const auto hit = query.castRay(origin, direction);
    const auto expected = nearestByForce(surface, origin, direction);
    ASSERT_EQ(hit.has_value(), expected.has_value()) << i;
    if (!hit) continue;
    ++hits;
    // Float against double over distances of a few units.
    ASSERT_NEAR(hit->distance, *expected, 1e-4f * (1.0f + *expected));
    const Vec3 error = positionAt(surface, *hit) - (origin + direction * hit->distance);
    ASSERT_LT(glm::length(error), 1e-4f * (1.0f + hit->distance));
  }
  EXPECT_GT(hits, 100);
}

TEST(SurfaceQuery, SeesNoBackFaces) {
  const Surface surface = built(makeSphere());
  EXPECT_FALSE(SurfaceQuery(surface).castRay(Vec3(0), Vec3(1, 0.2f, 0)));
}

TEST(SurfaceQuery, HitsAlongTheAxes) {
  const Surface surface = built(makeSphere());
  const SurfaceQuery query(surface);
  for (const Vec3& axis : {Vec3(1, 0, 0), Vec3(0, 1, 0), Vec3(0, 0, 1)}) {
    for (const float sign : {-1.0f, 1.0f}) {
      const auto hit = query.castRay(axis * sign * 3.0f, axis * -sign);
      ASSERT_TRUE(hit);
      EXPECT_NEAR(hit->distance, 2.0f, 0.01f);  // facets lie up to 0.2 % inside the sphere
      EXPECT_GT(glm::dot(normalAt(surface, *hit), axis * sign), 0.99f);
    }
  }
}

TEST(SurfaceQuery, HasNoGapsBetweenTriangles) {
  const Surface surface = built(makeSphere(24, 12));
  const SurfaceQuery query(surface);
  for (const SurfaceVertex& v : surface.vertices) ASSERT_TRUE(query.castRay(v.position * 3.0f, -v.position));
  for (const SurfaceEdge& edge : surface.edges) {
    const Vec3 middle = (surface.vertices[edge.a].position + surface.vertices[edge.b].position) * 0.5f;
    ASSERT_TRUE(query.castRay(middle * 3.0f, -middle));
  }
}

TEST(SurfaceQuery, FindsTheSameTrianglesWithinARadiusAsLookingAtAll) {
  const Surface surface = built(makeLump(32, 16));
  const SurfaceQuery query(surface);
  Random random(9);
  for (int i = 0; i < 200; ++i) {
    const Vec3 centre = randomPoint(random, 1.0f);
    const float radius = random.uniform(0.0f, 0.5f);
    std::vector<std::uint32_t> surely, maybe;
    for (std::uint32_t t = 0; t < surface.triangleCount(); ++t) {
      // The nearest of a fine net of points of the triangle bounds its distance from above.
      const auto v = cornersOf(surface, t);
      float nearest = 1e9f, longest = 0.0f;
      for (std::size_t k = 0; k < 3; ++k) longest = std::max(longest, glm::length(v[k]->position - v[(k + 1) % 3]->position));
      // No point of it is further from a corner.
      if (glm::length(v[0]->position - centre) > radius + 1.1f * longest) continue;
      for (int a = 0; a <= 16; ++a) {
        for (int b = 0; a + b <= 16; ++b) {
          const Vec3 p = (v[0]->position * static_cast<float>(a) + v[1]->position * static_cast<float>(b) +
                          v[2]->position * static_cast<float>(16 - a - b)) / 16.0f;
          nearest = std::min(nearest, glm::length(p - centre));
        }
      }
      if (nearest <= radius) surely.push_back(t);
      if (nearest <= radius + longest / 16.0f) maybe.push_back(t);
    }
    const auto found = query.trianglesWithin(centre, radius);
    EXPECT_EQ(query.isNear(centre, radius), !found.empty());
    ASSERT_TRUE(std::includes(found.begin(), found.end(), surely.begin(), surely.end()));
    ASSERT_TRUE(std::includes(maybe.begin(), maybe.end(), found.begin(), found.end()));
  }
}

TEST(SurfaceQuery, FindsNothingWhenEmpty) {
  const SurfaceQuery query;
  EXPECT_FALSE(query.castRay(Vec3(0), Vec3(1, 0, 0)));
  EXPECT_TRUE(query.trianglesWithin(Vec3(0), 1.0f).empty());
}

TEST(SurfaceQuery, InterpolatesTheAtlas) {
  const Surface surface = built(makePlane(4));
  const auto hit = SurfaceQuery(surface).castRay(Vec3(0.1f, 1, 0.2f), Vec3(0, -1, 0));
  ASSERT_TRUE(hit);
  const Vec2 expected = Vec2(0.1f, 0.2f) / 1.41421356f + 0.5f;
  EXPECT_NEAR(atlasAt(surface, *hit).x, expected.x, 1e-5f);
  EXPECT_NEAR(atlasAt(surface, *hit).y, expected.y, 1e-5f);
}

}  // namespace
}  // namespace fur::geometry
