// Maps as pictures for other programs, and back.
#include "groom/MapPictures.h"

#include <gtest/gtest.h>

#include "geometry/Adjacency.h"
#include "groom/GroomBrush.h"
#include "groom/GroomFilters.h"
#include "tests/groom/GroomSetting.h"

namespace fur::groom {
namespace {

Setting dressed() {
  Setting one;
  varyLength(one.groom, one.groomSurface(), 0.9f, 0.1f, 3);
  paintType(one.groom, one.groomSurface(), {{1, 0, 0}, {1, 0, 0}, 0.7f, 0.7f}, 2);
  paint(one.groom, one.groomSurface(), {{0, 0, 1}, {0, 0, 1}, 0.7f, 0.6f}, 0x3080c0);
  protect(one.groom, one.groomSurface(), {{0, 1, 0}, {0, 1, 0}, 0.6f, 0.8f});
  for (std::uint32_t i = 0; i < one.groom.shape.texels().size(); i += 3) one.groom.shape.set(i, {static_cast<std::uint8_t>(i % 200), 17, 90, static_cast<std::uint8_t>(std::max(i % 200, 90u))});
  return one;
}

const MapPicture& named(const std::vector<MapPicture>& all, std::string_view name) {
  for (const MapPicture& picture : all)
    if (name == picture.name) return picture;
  ADD_FAILURE() << name;
  return all.front();
}

// As whoever decodes a file gives it.
std::vector<std::uint8_t> rgbaOf(const MapPicture& picture) {
  std::vector<std::uint8_t> out;
  const auto channels = static_cast<std::size_t>(picture.channels);
  for (std::size_t i = 0; i < picture.pixels.size(); i += channels)
    for (std::size_t k = 0; k < 4; ++k)
      out.push_back(channels == 1 ? (k < 3 ? picture.pixels[i] : 255) : k < channels ? picture.pixels[i + k] : 255);
  return out;
}

TEST(MapPictures, WhatIsWrittenComesBackAsTheSameGroom) {
  const Setting one = dressed();
  const auto pictures = mapPictures(one.groom, one.groomSurface());
  Setting other;
  for (const auto& [name, what] : {std::pair("length", ImageOf::Length), std::pair("types", ImageOf::Types),
                                   std::pair("paint", ImageOf::Paint), std::pair("mask", ImageOf::Mask), std::pair("shape", ImageOf::Shape)}) {
    const MapPicture& picture = named(pictures, name);
    readMapPicture(what, other.groom, picture.size, picture.size, rgbaOf(picture));
  }
  for (const auto map : kMaps)
    for (std::size_t i = 0; i < (one.groom.*map).texels().size(); ++i)
      for (std::size_t k = 0; k < 4; ++k) ASSERT_NEAR((one.groom.*map).texels()[i][k], (other.groom.*map).texels()[i][k], 1) << i;
}

TEST(MapPictures, AModelWithoutTextureCoordinatesTakesALengthMapAsItGaveIt) {
  // The import of any picture, which knows no atlas: there its coordinates are the model's.
  const Setting one = dressed();
  const auto pictures = mapPictures(one.groom, one.groomSurface());
  const MapPicture& picture = named(pictures, "length");
  Setting other;
  paintFromImage(ImageOf::Length, other.groom, other.groomSurface(), picture.size, picture.size, rgbaOf(picture));
  int texels = 0, apart = 0;
  one.forTexels([&](std::uint32_t texel, const Vec3&) {
    ++texels;
    apart += std::abs(one.groom.map.texels()[texel][0] - other.groom.map.texels()[texel][0]) > 1;
  });
  // Texels of triangles that are too fine to hold any may take a neighbour.
  EXPECT_LE(apart, texels / 500);
}

TEST(MapPictures, ALargerPictureIsReadAtTheMapsSize) {
  Setting one(256), other(64);
  setLength(one.groom.map, 0.5f);
  const MapPicture picture = mapPictures(one.groom, one.groomSurface()).front();
  readMapPicture(ImageOf::Length, other.groom, picture.size, picture.size, rgbaOf(picture));
  for (const GroomMap::Texel& texel : other.groom.map.texels()) ASSERT_EQ(texel[0], 128);
}

TEST(MapPictures, TheCombIsADirectionInTheAtlasAndALength) {
  Setting one;
  const MapPicture upright = named(mapPictures(one.groom, one.groomSurface()), "comb");
  EXPECT_EQ(upright.pixels[0], 128);
  combAlong(one.groom, one.points, Vec3(1, 0.2f, 0), 1);
  const MapPicture combed = named(mapPictures(one.groom, one.groomSurface()), "comb");
  const std::vector<Vec3> bends = restBends(one.groom, one.surface, one.points);
  int compared = 0;
  for (std::uint32_t t = 0; t < one.surface.triangleCount(); t += 7)
    one.atlas.forTexelsOf(one.surface, t, [&](std::uint32_t texel, const Vec3& weights) {
      const geometry::SurfacePoint at{t, weights, 0};
      const Vec3 bend = valueAt(one.surface, at, bends);
      if (glm::length(bend) < 0.3f) return;
      const std::uint8_t* pixel = &combed.pixels[std::size_t{3} * texel];
      EXPECT_NEAR(pixel[2] / 255.0f * kMaxComb, glm::length(bend), 0.01f);
      // The way that the fur leans: so much of the way in which u grows, so much of that across it, to the side of v.
      const auto vertex = [&](std::size_t k) -> const geometry::SurfaceVertex& { return one.surface.vertices[one.surface.indices[std::size_t{3} * t + k]]; };
      const Vec3 ab = vertex(1).position - vertex(0).position, ac = vertex(2).position - vertex(0).position;
      const Vec2 uvB = vertex(1).atlas - vertex(0).atlas, uvC = vertex(2).atlas - vertex(0).atlas;
      const Vec2 way(pixel[0] / 255.0f * 2 - 1, pixel[1] / 255.0f * 2 - 1);
      const float area = uvB.x * uvC.y - uvC.x * uvB.y;
      const auto moved = [&](const Vec2& by) { return ab * ((by.x * uvC.y - uvC.x * by.y) / area) + ac * ((uvB.x * by.y - by.x * uvB.y) / area); };
      const Vec3 alongU = glm::normalize(moved({1, 0})), alongV = moved({0, 1});
      const Vec3 across = glm::normalize(alongV - alongU * glm::dot(alongV, alongU));
      EXPECT_GT(glm::dot(alongU * way.x + across * way.y, glm::normalize(bend)), 0.97f);
      ++compared;
    });
  EXPECT_GT(compared, 1000);
}

TEST(MapPictures, TheLayoutRunsBetweenTexelsOfAChartAndOfNone) {
  const Setting one;
  constexpr int kSize = 256;
  const MapPicture layout = layoutPicture(one.surface, kSize);
  int outlined = 0, within = 0;
  for (int y = 3; y < kSize - 3; ++y)
    for (int x = 3; x < kSize - 3; ++x) {
      const auto owned = [&](int dx, int dy) { return one.atlas.triangleOf()[static_cast<std::size_t>((y + dy) * kSize + x + dx)] != geometry::kNoTriangle; };
      const bool line = layout.pixels[4 * static_cast<std::size_t>(y * kSize + x) + 3] > 100;
      bool all = true;
      for (int dy = -3; dy <= 3; ++dy)
        for (int dx = -3; dx <= 3; ++dx) all = all && owned(dx, dy);
      if (owned(0, 0) && !owned(1, 0)) outlined += line ? 1 : -100000;
      if (all) within += line;
    }
  EXPECT_GT(outlined, 100);
  // But for triangles finer than a texel, which own some in the gap between two charts.
  EXPECT_LT(within, kSize * kSize / 1000);
}

TEST(MapPictures, NamesTellWhatIsReadBack) {
  EXPECT_EQ(mapOfFile(mapFileName("bunny", "length")), ImageOf::Length);
  EXPECT_EQ(mapOfFile(mapFileName("my-map-cat", "paint")), ImageOf::Paint);
  EXPECT_EQ(mapOfFile("cat-map-mask (2).png"), ImageOf::Mask);
  EXPECT_EQ(mapOfFile("cat-map-types.png"), ImageOf::Types);
  for (const char* other : {"", "cat.png", "cat-map-.png", "cat-map-comb.png", "cat-map-length.jpg", "length.png", "cat-map-lengthy.png"})
    EXPECT_EQ(mapOfFile(other), std::nullopt) << other;
}

}  // namespace
}  // namespace fur::groom
