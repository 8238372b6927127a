#include "groom/Groom.h"

#include <gtest/gtest.h>

#include "core/Fnv1a.h"
#include "groom/GroomBrush.h"
#include "groom/GroomFilters.h"
#include "tests/OnEveryPlatform.h"
#include "tests/groom/GroomSetting.h"

namespace fur::groom {
namespace {

TEST(GroomMap, ReportsTheRectangleThatChangedOnce) {
  GroomMap map(32);
  EXPECT_EQ(map.takeChanged(), (geometry::TexelRect{0, 0, 32, 32}));
  EXPECT_TRUE(map.takeChanged().empty());
  map.set(5 * 32 + 7, {1, 2, 3, 4});
  map.set(9 * 32 + 3, {1, 2, 3, 4});
  map.set(9 * 32 + 3, {1, 2, 3, 4});
  EXPECT_EQ(map.takeChanged(), (geometry::TexelRect{3, 5, 8, 10}));
}

TEST(GroomMap, BringsPresencesBackToAWhole) {
  GroomMap map(16);
  map.set(0, {9, 200, 200, 200});
  const GroomMap::Texel texel = map.texels()[0];
  EXPECT_LE(texel[1] + texel[2] + texel[3], 255);
  EXPECT_EQ(texel[1], texel[3]);
  EXPECT_EQ(texel[0], 9);
}

TEST(GroomMap, SizesAreClampedAndResizingThereAndBackLosesNothing) {
  EXPECT_EQ(GroomMap(1).size(), GroomMap::kLeastSize);
  EXPECT_EQ(GroomMap(5000).size(), GroomMap::kMostSize);
  GroomMap map(64);
  for (std::uint32_t i = 0; i < 64 * 64; ++i) map.set(i, {static_cast<std::uint8_t>(i), static_cast<std::uint8_t>(i >> 6), 0, 0});
  Groom groom{map, {}};
  groom.paint.set(77, {1, 2, 3, 4});
  const auto paint = groom.paint.hash();
  resize(groom, 256);
  EXPECT_EQ(groom.paint.size(), 256);
  resize(groom, 64);
  EXPECT_EQ(groom.map.hash(), map.hash());
  EXPECT_EQ(groom.paint.hash(), paint);
}

TEST(GroomMap, GuttersRepeatTheNearestTexelOfTheirChart) {
  Setting s;
  varyLength(s.groom, s.groomSurface(), 1, 0.2f, 3);
  for (const auto& [texel, source] : s.atlas.gutter()) ASSERT_EQ(s.groom.map.texels()[texel], s.groom.map.texels()[source]);
  // A dab fills only the gutters near it, and that is enough.
  paintType(s.groom, s.groomSurface(), {glm::normalize(Vec3(1, 1, 1)), glm::normalize(Vec3(1, 1, 1)), 0.4f, 0.7f}, 2);
  for (const auto& [texel, source] : s.atlas.gutter()) ASSERT_EQ(s.groom.map.texels()[texel], s.groom.map.texels()[source]);
}

TEST(Groom, BothSidesOfASeamHaveOneLengthAndOneComb) {
  Setting s;
  varyLength(s.groom, s.groomSurface(), 1, 0.2f, 3);
  combAlong(s.groom, s.points, Vec3(1, -1, 0.5f), 0.7f);
  const auto lengths = vertexLengths(s.groom.map, s.surface, s.points);
  const auto rest = restBends(s.groom, s.surface, s.points);
  ASSERT_EQ(lengths.size(), s.surface.vertices.size());
  std::vector<int> first(s.points.count(), -1);
  for (std::size_t i = 0; i < lengths.size(); ++i) {
    ASSERT_NEAR(glm::dot(rest[i], s.surface.vertices[i].normal), 0, 1e-5);
    int& same = first[s.points.pointOf[i]];
    if (same < 0) same = static_cast<int>(i);
    ASSERT_EQ(lengths[i], lengths[static_cast<std::size_t>(same)]);
    ASSERT_LT(glm::length(rest[i] - rest[static_cast<std::size_t>(same)]), 1e-5f);
  }
}

TEST(Groom, PointsDoNotDependOnTheFurMapping) {
  geometry::Mesh mesh = geometry::makeTorus();
  const SurfacePoints charts(geometry::buildSurface(mesh, geometry::FurMapping::Charts).value());
  const SurfacePoints cube(geometry::buildSurface(mesh, geometry::FurMapping::Cube).value());
  EXPECT_EQ(charts.positions, cube.positions);
}

TEST(Groom, BaldTrianglesCostNothing) {
  Setting s;
  const auto furry = [&](const std::vector<std::uint32_t>& all, const TypeHeights& heights = kAllFull) {
    return furryTriangles(all, vertexLengths(s.groom.map, s.surface, s.points, heights));
  };
  EXPECT_EQ(furry(s.surface.furIndices), s.surface.furIndices);
  const Brush razor{Vec3(0, 0, 1), Vec3(0, 0, 1), 0.8f, 1};
  for (int i = 0; i < 30; ++i) trim(s.groom, s.groomSurface(), razor);
  const auto kept = furry(s.surface.furIndices);
  EXPECT_LT(kept.size(), s.surface.furIndices.size());
  const auto bald = [&](const std::uint32_t* corner, float reach) {
    for (int k = 0; k < 3; ++k)
      if (glm::length(s.surface.vertices[corner[k]].position - razor.centre) > reach) return false;
    return true;
  };
  std::size_t wellInside = 0;
  for (std::size_t i = 0; i < s.surface.furIndices.size(); i += 3) wellInside += bald(&s.surface.furIndices[i], 0.5f);
  EXPECT_GT(wellInside, 0u);
  EXPECT_LE(kept.size(), s.surface.furIndices.size() - 3 * wellInside);
  for (std::size_t i = 0; i < kept.size(); i += 3) ASSERT_FALSE(bald(&kept[i], 0.5f));
  setLength(s.groom.map, 0);
  EXPECT_TRUE(furry(s.surface.furIndices).empty());
}

TEST(Groom, WhereATypeIsBaldNothingIsDrawn) {
  Setting s;
  EXPECT_EQ(typesPresent(s.groom.map), 1u);
  paintType(s.groom, s.groomSurface(), {Vec3(0, 0, 1), Vec3(0, 0, 1), 0.8f, 1}, 3);
  EXPECT_EQ(typesPresent(s.groom.map), 5u);
  const auto& all = s.surface.furIndices;
  const auto furry = [&](const TypeHeights& heights) {
    return furryTriangles(all, vertexLengths(s.groom.map, s.surface, s.points, heights));
  };
  EXPECT_EQ(furry(kAllFull), all);
  setType(s.groom.map, 3);
  EXPECT_TRUE(furry({1, 1, 0, 1}).empty());
  EXPECT_EQ(furry({0, 0, 0.5f, 0}), all);
}

TEST(Groom, VerticesHaveRoomForEveryStrandOnTheirTriangles) {
  Setting s;
  varyLength(s.groom, s.groomSurface(), 1, 0.02f, 9);
  const auto lengths = vertexLengths(s.groom.map, s.surface, s.points);
  for (std::uint32_t t = 0; t < s.surface.triangleCount(); ++t)
    s.atlas.forTexelsOf(s.surface, t, [&](std::uint32_t texel, const Vec3&) {
      for (std::size_t k = 0; k < 3; ++k)
        ASSERT_GE(lengths[s.surface.indices[3 * t + k]], s.groom.map.texels()[texel][0] / 255.0f - 1e-6f);
    });
  setLength(s.groom.map, 0.25f);
  for (const float length : vertexLengths(s.groom.map, s.surface, s.points)) ASSERT_NEAR(length, 0.25f, 0.01f);
  setLength(s.groom.map, 0);
  for (const float length : vertexLengths(s.groom.map, s.surface, s.points)) ASSERT_EQ(length, 0);
}

TEST(Groom, ATriangleStaysAsLongAsAFilteredLookUpMeetsFur) {
  Setting s;
  varyLength(s.groom, s.groomSurface(), 1, 0.15f, 9);
  std::vector<GroomMap::Texel> texels = s.groom.map.texels();
  for (GroomMap::Texel& texel : texels) texel[0] = texel[0] > 130 ? texel[0] : 0;
  s.groom.map.restore(texels);
  const auto kept = furryTriangles(s.surface.indices, vertexLengths(s.groom.map, s.surface, s.points));
  EXPECT_LT(kept.size(), s.surface.indices.size());
  std::size_t next = 0;
  for (std::size_t i = 0; i < s.surface.indices.size(); i += 3) {
    if (next < kept.size() && std::equal(&kept[next], &kept[next] + 3, &s.surface.indices[i])) {
      next += 3;
      continue;
    }
    for (const Vec3& w : {Vec3(1 / 3.0f), Vec3(1, 0, 0), Vec3(0, 0.5f, 0.5f), Vec3(0.1f, 0.1f, 0.8f)})
      ASSERT_EQ(s.groom.map.lengthAt(atlasAt(s.surface, {static_cast<std::uint32_t>(i / 3), w, 0})), 0);
  }
  EXPECT_EQ(next, kept.size());
}

TEST(Groom, CoverageSaysWhatIsBaldAndWhatGrowsWhere) {
  Setting s;
  EXPECT_EQ(coverage(s.groom.map, s.atlas).bald, 0);
  EXPECT_EQ(coverage(s.groom.map, s.atlas).types[0], 1);
  setType(s.groom.map, 3);
  setLength(s.groom.map, 0.4f);
  const Coverage all = coverage(s.groom.map, s.atlas);
  EXPECT_NEAR(all.length, 0.4, 1 / 255.0);
  EXPECT_EQ(all.types[2], 1);
  setLength(s.groom.map, 0);
  EXPECT_EQ(coverage(s.groom.map, s.atlas).bald, 1);
}

TEST(GroomFilters, InvertingTwiceChangesNothing) {
  Setting s;
  varyLength(s.groom, s.groomSurface(), 0.8f, 0.2f, 4);
  const auto hash = s.groom.map.hash();
  invertLength(s.groom.map);
  EXPECT_NE(s.groom.map.hash(), hash);
  invertLength(s.groom.map);
  EXPECT_EQ(s.groom.map.hash(), hash);
}

TEST(GroomFilters, NoiseOnlyShortensByItsAmountAndDependsOnTheSeed) {
  Setting a, b;
  varyLength(a.groom, a.groomSurface(), 0.6f, 0.2f, 1);
  varyLength(b.groom, b.groomSurface(), 0.6f, 0.2f, 2);
  int least = 255;
  a.forTexels([&](std::uint32_t texel, const Vec3&) { least = std::min<int>(least, a.groom.map.texels()[texel][0]); });
  EXPECT_GE(least, 0.4 * 255 - 1);
  EXPECT_LT(least, 0.6 * 255);
  EXPECT_NE(a.groom.map.hash(), b.groom.map.hash());
}

TEST(GroomFilters, CombedAlongADirectionNoFurPointsAgainstIt) {
  Setting s;
  combAlong(s.groom, s.points, Vec3(0, -1, 0), 1);
  for (std::size_t i = 0; i < s.points.count(); ++i) {
    ASSERT_LE(s.groom.comb[i].y, 1e-6f);
    ASSERT_LE(glm::length(s.groom.comb[i]), kMaxComb + 1e-5f);
    if (std::abs(s.points.normals[i].y) < 0.9f) ASSERT_NEAR(glm::length(s.groom.comb[i]), kMaxComb, 1e-4);
  }
  raiseAll(s.groom);
  EXPECT_TRUE(s.groom.isPlain());
}

TEST(GroomFilters, WhatIsDoneToAllOfItLeavesWhatIsProtected) {
  Setting s;
  const Brush all{Vec3(0, 0, 1), Vec3(0, 0, 1), 0.5f, 1, Falloff::Flat};
  ASSERT_TRUE(protect(s.groom, s.groomSurface(), all));
  const Groom before = s.groom;
  setLength(s.groom.map, 0);
  paintAll(s.groom, 0x336699);
  combAlong(s.groom, s.points, Vec3(0, -1, 0), 1);
  keepProtected(s.groom, before, s.groomSurface());
  s.forTexels([&](std::uint32_t texel, const Vec3& position) {
    const bool kept = glm::distance(position, all.centre) < all.radius;
    ASSERT_EQ(s.groom.map.texels()[texel][0], kept ? 255 : 0);
    ASSERT_EQ(s.groom.paint.texels()[texel][3], kept ? 0 : 255);
  });
  for (std::size_t i = 0; i < s.points.count(); ++i) {
    const float distance = glm::distance(s.points.positions[i], all.centre);
    if (distance < 0.45f) ASSERT_EQ(s.groom.comb[i], Vec3(0));
    if (distance > 0.55f && std::abs(s.points.normals[i].y) < 0.9f) ASSERT_NE(s.groom.comb[i], Vec3(0));
  }
  invertMask(s.groom.mask);
  invertMask(s.groom.mask);
  EXPECT_EQ(s.groom.mask.hash(), before.mask.hash());
}

TEST(GroomFilters, TheMaskIsRedOverThePaint) {
  Setting s;
  paintAll(s.groom, 0x00ff00);
  EXPECT_EQ(paintUnderMask(s.groom).hash(), s.groom.paint.hash());
  s.groom.mask.set(5, {0, 0, 0, 255});
  const GroomMap shown = paintUnderMask(s.groom);
  EXPECT_GT(shown.texels()[5][0], 100);
  EXPECT_GT(shown.texels()[5][1], 80) << "the paint shines through";
  EXPECT_EQ(shown.texels()[6], (GroomMap::Texel{0, 255, 0, 255}));
}

TEST(GroomFilters, LengthsOfVerticesComeBack) {
  Setting s;
  std::vector<float> given;
  std::vector<int> types;
  for (std::size_t i = 0; i < s.surface.trueVertexCount; ++i) {
    given.push_back(0.5f + 0.5f * s.surface.vertices[i].position.y);
    types.push_back(s.surface.vertices[i].position.x > 0 ? 2 : 1);
  }
  paintFromVertices(s.groom, s.groomSurface(), given, types);
  // A texel is a hundredth of the sphere's radius here, and the field changes by half of that over it.
  for (std::size_t i = 0; i < given.size(); ++i) ASSERT_NEAR(s.groom.map.lengthAt(s.surface.vertices[i].atlas), given[i], 0.02);
  const Coverage halves = coverage(s.groom.map, s.atlas);
  EXPECT_NEAR(halves.types[1], 0.5, 0.05);
}

TEST(GroomFilters, AnImageIsReadInTheModelsOwnCoordinates) {
  // The sphere's own uv: u runs round it.
  Setting s(256, geometry::buildSurface(geometry::makeSphere()).value());
  const std::uint8_t halves[] = {0, 0, 0, 255, 255, 255, 255, 255};
  paintFromImage(ImageOf::Length, s.groom, s.groomSurface(), 2, 1, halves);
  EXPECT_NEAR(coverage(s.groom.map, s.atlas).bald, 0.5, 0.01);
  for (const auto& vertex : s.surface.vertices)
    if (std::abs(vertex.uv.x - 0.25f) < 0.2f) ASSERT_EQ(s.groom.map.lengthAt(vertex.atlas), 0);
}

TEST(GroomFilters, AnImagesColoursAreThePresenceOfTheTypes) {
  Setting s(256, geometry::buildSurface(geometry::makeSphere()).value());
  const std::uint8_t halves[] = {0, 255, 0, 255, 60, 0, 60, 255};
  paintFromImage(ImageOf::Types, s.groom, s.groomSurface(), 2, 1, halves);
  EXPECT_EQ(coverage(s.groom.map, s.atlas).length, 1) << "lengths stay";
  for (const auto& vertex : s.surface.vertices) {
    if (std::abs(vertex.uv.x - 0.25f) < 0.2f) ASSERT_EQ(s.groom.map.typeAt(vertex.atlas), 3);
    if (std::abs(vertex.uv.x - 0.75f) < 0.2f) ASSERT_EQ(s.groom.map.typeAt(vertex.atlas), 1);
  }
  EXPECT_EQ(typesPresent(s.groom.map), 0b1111u);
}

TEST(Groom, TheSameWorkGivesTheSameBytesOnEveryPlatform) {
  // Sines differ from library to library: a model that is made without.
  geometry::Mesh mesh = geometry::makePlane();
  for (Vec3& p : mesh.positions) p.y = 0.3f * p.x * p.x - 0.2f * p.z * p.z * p.x;
  mesh.normals.clear();
  Setting s(256, geometry::buildSurface(mesh).value());
  varyLength(s.groom, s.groomSurface(), 0.7f, 0.1f, 5);
  for (int i = 0; i < 12; ++i) {
    const Brush brush{Vec3(0.3f * (i % 3) - 0.3f, 0, 0.25f * (i % 4) - 0.3f), Vec3(0, 1, 0), 0.35f, 0.5f};
    trim(s.groom, s.groomSurface(), brush);
    paintType(s.groom, s.groomSurface(), brush, 1 + i % 4);
    comb(s.groom, s.groomSurface(), brush, Vec3(1, -1, 0));
    smooth(s.groom, s.groomSurface(), brush);
  }
  Fnv1a combs;
  combs.addAll(s.groom.comb);
  test::printOnEveryPlatform("map of a groom", s.groom.map.hash());
  test::printOnEveryPlatform("comb of a groom", combs.value());
}

}  // namespace
}  // namespace fur::groom
