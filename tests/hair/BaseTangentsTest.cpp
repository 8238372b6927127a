#include "hair/BaseTangents.h"

#include "tests/hair/TestScalps.h"

namespace fur::hair {
namespace {

Vec3 wayOf(const std::array<std::uint8_t, 4>& texel, const Vec3& normal) {
  const Vec2 parts = Vec2(texel[0], texel[1]) / 127.5f - 1.0f;
  const Vec3 x = evenTangent(normal);
  return x * parts.x + glm::cross(normal, x) * parts.y;
}

// Hair on a sphere that leans to +x and lies the more the less the skin faces there.
struct Leaning {
  Leaning() : sphere(geometry::makeSphere()) {
    values.wisps = 800, values.magnet = 0;
    std::vector<Vec3> places;
    for (const Dart& dart : throwDarts(sphere.scalp(), 80, 1)) places.push_back(dart.position);
    const Guides guides = test::guidesAt(places, [](const Vec3& at) { return 0.2f * at + Vec3(0.4f, 0, 0); });
    const auto roots = sphere.roots(guides);
    tangents = baseTangents(sphere.scalp(), plantWisps(sphere.scalp(), guides, roots, values), restNodes(guides, roots), guides.nodes, values);
  }
  test::TestScalp sphere;
  HairValues values;
  std::vector<std::array<std::uint8_t, 4>> tangents;
};

TEST(BaseTangents, GoTheWayThatHairLeavesTheSkin) {
  const Leaning leaning;
  ASSERT_EQ(leaning.tangents.size(), leaning.sphere.surface.vertices.size());
  for (std::size_t v = 0; v < leaning.tangents.size(); ++v) {
    const Vec3 normal = leaning.sphere.surface.vertices[v].normal;
    if (std::abs(normal.x) > 0.8f) continue;  // there hair stands or lies every way
    const Vec3 x(1, 0, 0), flat = glm::normalize(x - normal * glm::dot(x, normal));
    EXPECT_GT(glm::dot(wayOf(leaning.tangents[v], normal), flat), 0.85f) << v;
    EXPECT_EQ(leaning.tangents[v][3], 255);
  }
}

TEST(BaseTangents, HairThatStandsLiesAlongNothing) {
  const Leaning leaning;
  float most = 0, least = 1;
  for (std::size_t v = 0; v < leaning.tangents.size(); ++v) {
    const float lies = leaning.tangents[v][2] / 127.5f - 1;
    const float x = leaning.sphere.surface.vertices[v].normal.x;
    if (x > 0.97f) least = std::min(least, lies);
    if (std::abs(x) < 0.1f) most = std::max(most, lies);
  }
  EXPECT_LT(least, 0.25f);
  EXPECT_GT(most, 0.8f);
}

TEST(BaseTangents, ThereAreNoneWhereNoHairGrows) {
  test::TestScalp bald(geometry::makeSphere());
  bald.paint([](const Vec3&) { return groom::GroomMap::Texel{0, 255, 255, 255}; });
  for (const auto& texel : baseTangents(bald.scalp(), {}, {}, 8, {})) EXPECT_EQ(texel[3], 0);
}

}  // namespace
}  // namespace fur::hair
