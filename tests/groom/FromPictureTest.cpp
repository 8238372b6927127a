// What pictures make of a groom.
#include "groom/FromPicture.h"

#include <gtest/gtest.h>

#include <limits>

#include "geometry/Primitives.h"
#include "tests/groom/GroomSetting.h"

namespace fur::groom {
namespace {

constexpr std::uint8_t kHalves[] = {200, 100, 50, 255, 0, 0, 0, 64};  // left: opaque orange, right: black, a quarter opaque
constexpr Picture kPicture{2, 1, kHalves};

// With its own texture coordinates: u runs round it.
struct PicturedSphere : Setting {
  PicturedSphere() : Setting(128, geometry::buildSurface(geometry::makeSphere()).value()) {}
};

// The texels of the map whose picture is the left or the right half, away from where they meet.
template <class Check>
void forHalves(const PicturedSphere& s, const GroomMap& map, Check check) {
  for (std::uint32_t t = 0; t < s.surface.triangleCount(); ++t) {
    const auto vertex = [&](std::size_t k) -> const geometry::SurfaceVertex& { return s.surface.vertices[s.surface.indices[3 * t + k]]; };
    s.atlas.forTexelsOf(s.surface, t, [&](std::uint32_t texel, const Vec3& w) {
      const Vec2 uv = w.x * vertex(0).uv + w.y * vertex(1).uv + w.z * vertex(2).uv;
      const float u = uv.x - std::floor(uv.x);
      if (u > 0.05f && u < 0.45f) check(map.texels()[texel], true);
      if (u > 0.55f && u < 0.95f) check(map.texels()[texel], false);
    });
  }
}

TEST(FromPicture, ColoursArePaintedAsFarAsThePictureIsOpaque) {
  PicturedSphere s;
  paintColors(s.groom, s.groomSurface(), kPicture);
  forHalves(s, s.groom.paint, [](const GroomMap::Texel& texel, bool left) {
    EXPECT_EQ(texel, left ? (GroomMap::Texel{200, 100, 50, 255}) : (GroomMap::Texel{0, 0, 0, 64}));
  });
}

TEST(FromPicture, IsOpaqueWhereNoTexelLetsAnythingThrough) {
  std::vector<std::uint8_t> rgba(4 * 6, 255);
  EXPECT_TRUE(isOpaque({3, 2, rgba}));
  rgba.back() = 254;
  EXPECT_FALSE(isOpaque({3, 2, rgba}));
}

TEST(FromPicture, AlphaIsTheLength) {
  PicturedSphere s;
  lengthFromAlpha(s.groom, s.groomSurface(), kPicture);
  forHalves(s, s.groom.map, [](const GroomMap::Texel& texel, bool left) { EXPECT_EQ(texel, (GroomMap::Texel{static_cast<std::uint8_t>(left ? 255 : 64), 0, 0, 0})); });
}

TEST(FromPicture, TheDarkerItIsTheMoreIsOfTheBaldTypeAndOthersKeepTheirShares) {
  PicturedSphere s;
  std::vector<GroomMap::Texel> texels(s.groom.map.texels().size(), {255, 100, 0, 0});
  s.groom.map.restore(texels);
  constexpr std::uint8_t grey[] = {255, 255, 255, 255, 51, 51, 51, 255};
  thinByPicture(s.groom, s.groomSurface(), {2, 1, grey}, 4);
  forHalves(s, s.groom.map, [](const GroomMap::Texel& texel, bool left) {
    EXPECT_EQ(texel, left ? (GroomMap::Texel{255, 100, 0, 0}) : (GroomMap::Texel{255, 20, 0, 204}));
  });
}

TEST(FromPicture, DirectionsCombAlongUAndVAndStayOnTheSkin) {
  PicturedSphere s;
  constexpr std::uint8_t along[] = {255, 128, 255, 255}, upright[] = {128, 128, 255, 255}, half[] = {255, 128, 128, 255};
  combFromPicture(s.groom, s.groomSurface(), {1, 1, along});
  int checked = 0;
  for (std::size_t i = 0; i < s.points.count(); ++i) {
    const Vec3 at = s.points.positions[i], &comb = s.groom.comb[i];
    EXPECT_LE(glm::length(comb), kMaxComb * 1.0001f);
    EXPECT_LT(std::abs(glm::dot(comb, s.points.normals[i])), 1e-3f);
    if (std::abs(at.y) > 0.7f) continue;
    // u runs round the axis.
    const Vec3 round = glm::normalize(Vec3(at.z, 0, -at.x));
    EXPECT_GT(std::abs(glm::dot(comb, round)), 0.95f * kMaxComb);
    ++checked;
  }
  EXPECT_GT(checked, 50);
  const std::vector<Vec3> full = s.groom.comb;
  combFromPicture(s.groom, s.groomSurface(), {1, 1, half});
  for (std::size_t i = 0; i < full.size(); ++i) EXPECT_NEAR(glm::length(s.groom.comb[i]), glm::length(full[i]) * 128 / 255, 1e-3f);
  combFromPicture(s.groom, s.groomSurface(), {1, 1, upright});
  for (const Vec3& comb : s.groom.comb) EXPECT_EQ(comb, Vec3(0));
}

TEST(FromPicture, OfAPictureWithoutBlueTheDirectionSaysHowFarItLiesDown) {
  PicturedSphere s;
  constexpr std::uint8_t little[] = {255 - 64, 128, 0, 255};
  combFromPicture(s.groom, s.groomSurface(), {1, 1, little});
  float most = 0;
  for (const Vec3& comb : s.groom.comb) most = std::max(most, glm::length(comb));
  EXPECT_NEAR(most, kMaxComb * 63 / 127, 0.02f);
}

TEST(FromPicture, CoordinatesRepeatAndThoseThatAreNoNumbersAreTheFirst) {
  const auto bad = std::numeric_limits<float>::quiet_NaN(), far = std::numeric_limits<float>::infinity();
  EXPECT_EQ(kPicture.at({0.75f, 0}), kPicture.at({-0.25f, 5.5f}));
  EXPECT_NE(kPicture.at({0.75f, 0}), kPicture.at({0.25f, 0}));
  for (const float c : {bad, far, -far}) EXPECT_EQ(kPicture.at({c, c}), kHalves);
}

}  // namespace
}  // namespace fur::groom
