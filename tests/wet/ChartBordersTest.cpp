#include "wet/ChartBorders.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "geometry/Adjacency.h"
#include "geometry/Primitives.h"

namespace fur::wet {
namespace {

using geometry::Surface;
using geometry::SurfacePoint;

constexpr int kMapTexels = 256;

// Two squares side by side in the plane y = 0 that meet at x = 0, each in triangles; the right one lies elsewhere in the atlas, turned by a
// quarter, or the other way round as well.
Surface twoSquares(bool mirrored = false) {
  Surface s;
  const auto add = [&s](Vec3 position, Vec2 atlas, std::uint32_t chart, const Vec4& atlasFromSkin) {
    geometry::SurfaceVertex v{};
    v.position = position;
    v.normal = Vec3(0, 1, 0);
    v.atlas = atlas;
    v.fur = 2.0f * atlas;
    v.gradS = 2.0f * Vec3(atlasFromSkin.x, 0, atlasFromSkin.z);
    v.gradT = 2.0f * Vec3(atlasFromSkin.y, 0, atlasFromSkin.w);
    v.atlasFromFur = Vec4(0.5f, 0, 0, 0.5f);
    v.chart = chart;
    s.vertices.push_back(v);
  };
  const Vec4 left(1, 0, 0, 1), right = mirrored ? Vec4(0, 1, 1, 0) : Vec4(0, 1, -1, 0);
  const float low = mirrored ? 0.55f : 0.95f, high = mirrored ? 0.95f : 0.55f;
  add({-0.4f, 0, -0.2f}, {0.05f, 0.05f}, 0, left);
  add({0, 0, -0.2f}, {0.45f, 0.05f}, 0, left);
  add({0, 0, 0.2f}, {0.45f, 0.45f}, 0, left);
  add({-0.4f, 0, 0.2f}, {0.05f, 0.45f}, 0, left);
  add({0, 0, -0.2f}, {low, 0.55f}, 1, right);
  add({0.4f, 0, -0.2f}, {low, 0.95f}, 1, right);
  add({0.4f, 0, 0.2f}, {high, 0.95f}, 1, right);
  add({0, 0, 0.2f}, {high, 0.55f}, 1, right);
  s.indices = {0, 2, 1, 0, 3, 2, 4, 6, 5, 4, 7, 6};
  s.trueVertexCount = s.vertices.size();
  s.chartCount = 2;
  return s;
}

Vec2 texelCentre(std::uint32_t texel) { return (Vec2(texel % kMapTexels, texel / kMapTexels) + 0.5f) / static_cast<float>(kMapTexels); }

// Where border number `border` takes a point, by the matrix in its texel `matrix` (0: of the atlas, 1: of fur).
Vec2 beyond(const ChartBorders& borders, std::uint32_t border, int matrix, const Vec2& at) {
  const Vec4* texels = &borders.texels()[FUR_BORDER_TEXELS * (border - 1)];
  const Vec4 &m = texels[matrix], &origins = texels[2];
  return Vec2(m.x, m.y) * at.x + Vec2(m.z, m.w) * at.y + (matrix ? Vec2(origins.z, origins.w) : Vec2(origins));
}

TEST(ChartBorders, LeadToTheSamePlaceOfTheSkinInTheOtherChart) {
  const Surface surface = twoSquares();
  const SurfaceWetting wetting(surface, kMapTexels);
  const ChartBorders borders(surface, wetting);
  EXPECT_EQ(borders.texels().size(), kMapTexels) << "a row of the mask";
  EXPECT_EQ(std::count(borders.texels().begin(), borders.texels().end(), Vec4(0)), kMapTexels - 2 * 3) << "one edge, seen from both sides";
  int led[2] = {};
  for (const auto& [texel, border] : borders.gutter()) {
    const Vec2 at = texelCentre(texel);
    if (border == 0) continue;
    const int chart = wetting.chartOfTexel()[texel];
    ++led[chart];
    // Of the left chart (u, v) lies at x = u - 0.45, z = v - 0.25; of the right one at x = v - 0.55, z = 0.75 - u.
    const Vec2 expected = chart == 0 ? Vec2(0.75f - (at.y - 0.25f), 0.55f + at.x - 0.45f) : Vec2(0.45f + at.y - 0.55f, 0.25f + 0.75f - at.x);
    EXPECT_NEAR(glm::distance(beyond(borders, border, 0, at), expected), 0, 1e-5f) << texel;
    EXPECT_NEAR(glm::distance(beyond(borders, border, 1, 2.0f * at), 2.0f * expected), 0, 1e-5f) << "fur coordinates, twice as large, " << texel;
  }
  // Two texels wide along 0.4 of the map, and what lies within three texels of the edge's ends; not where the surface ends, on three sides.
  for (const int count : led) {
    EXPECT_GE(count, static_cast<int>(2 * 0.4 * kMapTexels));
    EXPECT_LE(count, static_cast<int>(2 * 0.4 * kMapTexels) + 2 * 4 * 6);
  }
}

TEST(ChartBorders, LeadNowhereToAMirroredChart) {
  const Surface surface = twoSquares(true);
  const ChartBorders borders(surface, SurfaceWetting(surface, kMapTexels));
  EXPECT_TRUE(borders.texels().empty());
  for (const auto& [texel, border] : borders.gutter()) EXPECT_EQ(border, 0u) << texel;
}

TEST(ChartBorders, OfARoundBodyLeadToWithinATexel) {
  geometry::Mesh mesh = geometry::makeSphere();
  mesh.uv.clear();
  const Surface surface = geometry::buildSurface(mesh).value();
  const SurfaceWetting wetting(surface, kMapTexels);
  const ChartBorders borders(surface, wetting);
  const geometry::AtlasTexels& atlas = wetting.atlas();
  double apart = 0, width = 0;
  int led = 0, onSkin = 0;
  for (std::size_t i = 0; i < borders.gutter().size(); ++i) {
    const auto [texel, border] = borders.gutter()[i];
    ASSERT_EQ(texel, atlas.gutter()[i].first);
    if (border == 0) continue;
    ++led;
    const Vec2 there = beyond(borders, border, 0, texelCentre(texel)) * static_cast<float>(kMapTexels);
    const auto other = static_cast<std::uint32_t>(static_cast<int>(there.y) * kMapTexels + static_cast<int>(there.x));
    const std::uint32_t triangle = atlas.triangleOf()[other];
    if (triangle == geometry::kNoTriangle) continue;  // of the texels along a border every second has its middle in the gutter
    ++onSkin;
    // The place there, and the one that the gutter repeats: it lies up to two texels inside of it.
    const std::uint32_t source = atlas.gutter()[i].second;
    const auto placeOf = [&](std::uint32_t at) { return positionAt(surface, SurfacePoint{atlas.triangleOf()[at], atlas.weightsAt(surface, atlas.triangleOf()[at], at), 0}); };
    apart += glm::distance(placeOf(other), placeOf(source));
    width += glm::distance(texelCentre(texel), texelCentre(source)) * kMapTexels;
  }
  ASSERT_GT(led, 1000);
  EXPECT_GT(onSkin, led / 2);
  // As far apart on the skin as in the map, to a third: charts are stretched by that.
  const double texelOnSkin = std::sqrt(4 * 3.14159 / static_cast<double>(kMapTexels * kMapTexels - std::count(atlas.triangleOf().begin(), atlas.triangleOf().end(), geometry::kNoTriangle)));
  EXPECT_NEAR(apart / (width * texelOnSkin), 1, 0.34);
}

}  // namespace
}  // namespace fur::wet
