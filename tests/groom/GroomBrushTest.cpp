#include "groom/GroomBrush.h"

#include <gtest/gtest.h>

#include <functional>
#include <set>

#include "tests/groom/GroomSetting.h"

namespace fur::groom {
namespace {

const Vec3 kSpots[] = {{1, 0, 0}, {1, 1, 0}, {1, 1, 1}, {-1, 0.9f, 0.2f}, {0, -1, 0.8f}, {0, 1, 0}};

Brush at(const Vec3& direction, float radius = 0.3f, float strength = 0.5f) {
  const Vec3 normal = glm::normalize(direction);
  return {normal, normal, radius, strength};
}

using Dab = std::function<bool(Groom&, const GroomSurface&, const Brush&)>;
const std::pair<const char*, Dab> kDabs[] = {
    {"trim", trim},
    {"grow", grow},
    {"type", [](Groom& g, const GroomSurface& o, const Brush& b) { return paintType(g, o, b, 3); }},
    {"comb", [](Groom& g, const GroomSurface& o, const Brush& b) { return comb(g, o, b, Vec3(0.3f, -1, 0.2f)); }},
    {"raise", raise},
    {"smooth", smooth},
    {"cut", [](Groom& g, const GroomSurface& o, const Brush& b) { return cutTo(g, o, b, 0.25f); }},
    {"take type", [](Groom& g, const GroomSurface& o, const Brush& b) { return takeType(g, o, b, 2); }},
    {"paint", [](Groom& g, const GroomSurface& o, const Brush& b) { return paint(g, o, b, 0x3366ff); }},
};

// Something on which every brush has an effect.
void tousle(Setting& s) {
  for (std::size_t i = 0; i < s.points.count(); ++i)
    s.groom.comb[i] = combedTo(Vec3(i % 3 ? 1.0f : -1.0f, i % 2 ? 1.0f : -0.5f, 0.3f), s.points.normals[i]);
  s.forTexels([&](std::uint32_t texel, const Vec3&) {
    s.groom.map.set(texel, {static_cast<std::uint8_t>(60 + texel % 100), static_cast<std::uint8_t>(texel % 50), 30, 40});
  });
}

TEST(GroomBrush, ChangesOnlyWhatLiesWithinItsBall) {
  for (const auto& [name, dab] : kDabs) {
    const char* brushName = name;  // a structured binding cannot be captured yet
    Setting s;
    tousle(s);
    for (const Vec3& spot : kSpots) {
      const Groom before = s.groom;
      const Brush brush = at(spot);
      ASSERT_TRUE(dab(s.groom, s.groomSurface(), brush)) << name;
      s.forTexels([&](std::uint32_t texel, const Vec3& position) {
        if (glm::length(position - brush.centre) <= brush.radius) return;
        ASSERT_EQ(s.groom.map.texels()[texel], before.map.texels()[texel]) << brushName;
        ASSERT_EQ(s.groom.paint.texels()[texel][3], before.paint.texels()[texel][3]) << brushName;
      });
      for (std::size_t i = 0; i < s.points.count(); ++i)
        if (glm::length(s.points.positions[i] - brush.centre) > brush.radius)
          ASSERT_EQ(s.groom.comb[i], before.comb[i]) << name;
    }
  }
}

TEST(GroomBrush, LeavesNoGapAtTheBordersOfCharts) {
  Setting s;
  for (const Vec3& spot : kSpots) {
    Groom groom = plainGroom(256, s.points);
    const Brush brush = at(spot, 0.3f, 1.0f);
    ASSERT_TRUE(trim(groom, s.groomSurface(), brush));
    std::set<std::uint32_t> charts;
    s.forTexels([&](std::uint32_t texel, const Vec3& position) {
      const float distance = glm::length(position - brush.centre) / brush.radius;
      const float left = 1 - distance * distance, wanted = distance < 1 ? 1 - left * left : 1;
      // One step of 8 bits, and the one that rounding towards the goal adds.
      ASSERT_NEAR(groom.map.texels()[texel][0] / 255.0f, wanted, 2 / 255.0f);
    });
    for (const auto& vertex : s.surface.vertices)
      if (glm::length(vertex.position - brush.centre) < 0.2f) {
        charts.insert(vertex.chart);
        ASSERT_LT(groom.map.lengthAt(vertex.atlas), 0.8f) << "filtered across a gutter";
      }
  }
}

TEST(GroomBrush, CrossesBordersAtSomeOfTheSpots) {
  // Otherwise the test above would say nothing.
  const Setting s;
  int crossing = 0;
  for (const Vec3& spot : kSpots) {
    std::set<std::uint32_t> charts;
    for (const auto& vertex : s.surface.vertices)
      if (glm::length(vertex.position - glm::normalize(spot)) < 0.3f) charts.insert(vertex.chart);
    crossing += charts.size() > 1;
  }
  EXPECT_GE(crossing, 2);
}

TEST(GroomBrush, TrimOnlyShortensAndGrowOnlyLengthensUpToTheirEnds) {
  Setting s;
  const Brush brush = at({1, 0.4f, 0.2f});
  std::uint32_t middle = 0;
  s.forTexels([&](std::uint32_t texel, const Vec3& position) {
    if (glm::length(position - brush.centre) < 0.02f) middle = texel;
  });
  for (const auto& [dab, end] : {std::pair(&trim, 0), std::pair(&grow, 255)}) {
    for (int i = 0; i < 40; ++i) {
      const GroomMap before = s.groom.map;
      dab(s.groom, s.groomSurface(), brush);
      for (std::size_t t = 0; t < before.texels().size(); ++t) {
        const int step = s.groom.map.texels()[t][0] - before.texels()[t][0];
        ASSERT_TRUE(end == 0 ? step <= 0 : step >= 0);
      }
    }
    EXPECT_EQ(s.groom.map.texels()[middle][0], end);
    EXPECT_EQ(dab(s.groom, s.groomSurface(), at({1, 0.4f, 0.2f}, 0.05f)), false) << "nothing left to do there";
  }
}

TEST(GroomBrush, MoreStrengthDoesMore) {
  Setting weak, strong;
  trim(weak.groom, weak.groomSurface(), at({0, 0, 1}, 0.3f, 0.2f));
  trim(strong.groom, strong.groomSurface(), at({0, 0, 1}, 0.3f, 0.7f));
  for (std::size_t t = 0; t < weak.groom.map.texels().size(); ++t)
    ASSERT_LE(strong.groom.map.texels()[t][0], weak.groom.map.texels()[t][0]);
}

TEST(GroomBrush, PresencesOfTheTypesStayAPartition) {
  Setting s;
  const Vec3 spot(1, 1, 1);
  for (const int type : {2, 3, 4, 2, 1, 4, 3}) {
    const GroomMap before = s.groom.map;
    paintType(s.groom, s.groomSurface(), at(spot, 0.4f, 0.6f), type);
    for (std::size_t t = 0; t < before.texels().size(); ++t) {
      const GroomMap::Texel &was = before.texels()[t], &is = s.groom.map.texels()[t];
      ASSERT_LE(is[1] + is[2] + is[3], 255);
      ASSERT_EQ(is[0], was[0]) << "length is not its business";
      for (std::size_t k = 1; k < 4; ++k)
        ASSERT_TRUE(static_cast<int>(k) == type - 1 ? is[k] >= was[k] : is[k] <= was[k]);
    }
  }
}

TEST(GroomBrush, EnoughPassesLeaveOneTypeAlone) {
  Setting s;
  for (int i = 0; i < 60; ++i) paintType(s.groom, s.groomSurface(), at({0, 0, 1}, 0.3f, 0.4f), 2);
  for (int i = 0; i < 60; ++i) paintType(s.groom, s.groomSurface(), at({0, 0, 1}, 0.3f, 0.4f), 4);
  s.forTexels([&](std::uint32_t texel, const Vec3& position) {
    if (glm::length(position - Vec3(0, 0, 1)) < 0.2f) ASSERT_EQ(s.groom.map.texels()[texel], (GroomMap::Texel{255, 0, 0, 255}));
  });
}

TEST(GroomBrush, ACombStaysAcrossTheNormalAndBounded) {
  Setting s;
  for (int i = 0; i < 60; ++i) {
    const Vec3 spot = kSpots[i % 6];
    comb(s.groom, s.groomSurface(), at(spot, 0.6f, 0.9f), Vec3(1, -2, i % 5 - 2.0f));
    if (i % 4 == 0) smooth(s.groom, s.groomSurface(), at(spot, 0.6f, 1));
    if (i % 7 == 0) raise(s.groom, s.groomSurface(), at(spot, 0.4f, 0.3f));
  }
  for (std::size_t i = 0; i < s.points.count(); ++i) {
    // Rounding of a few single-precision steps.
    ASSERT_NEAR(glm::dot(s.groom.comb[i], s.points.normals[i]), 0, 1e-5);
    ASSERT_LE(glm::length(s.groom.comb[i]), kMaxComb + 1e-5f);
  }
}

TEST(GroomBrush, ACombLaysTheFurItsWay) {
  Setting s;
  const Brush brush = at({0, 0, 1}, 0.3f, 0.8f);
  for (int i = 0; i < 8; ++i) comb(s.groom, s.groomSurface(), brush, Vec3(0, -5, 0));
  for (std::size_t i = 0; i < s.points.count(); ++i) {
    if (glm::length(s.points.positions[i] - brush.centre) > 0.1f) continue;
    EXPECT_GT(glm::dot(glm::normalize(s.groom.comb[i]), Vec3(0, -1, 0)), 0.98f);
    EXPECT_GT(glm::length(s.groom.comb[i]), 0.9f * kMaxComb);
  }
}

TEST(GroomBrush, RaisingEndsUpright) {
  Setting s;
  comb(s.groom, s.groomSurface(), at({0, 0, 1}), Vec3(1, 0, 0));
  for (int i = 0; i < 200; ++i) raise(s.groom, s.groomSurface(), at({0, 0, 1}, 0.6f, 0.6f));
  EXPECT_TRUE(s.groom.isPlain());
}

TEST(GroomBrush, SmoothingEvensOutAndKeepsWhatIsEven) {
  Setting s;
  tousle(s);
  const auto roughness = [&] {
    double sum = 0;
    for (std::size_t i = 0; i < s.surface.indices.size(); ++i) {
      const std::uint32_t a = s.points.pointOf[s.surface.indices[i]];
      const std::uint32_t b = s.points.pointOf[s.surface.indices[i - i % 3 + (i + 1) % 3]];
      if (s.points.positions[a].z < 0.9f) continue;
      const Vec3 apart = s.groom.comb[a] - s.groom.comb[b];
      sum += glm::dot(apart, apart);
    }
    return sum;
  };
  double before = roughness();
  for (int i = 0; i < 5; ++i) {
    smooth(s.groom, s.groomSurface(), at({0, 0, 1}, 0.6f, 0.8f));
    EXPECT_LT(roughness(), before);
    before = roughness();
  }
}

TEST(GroomBrush, NothingTouchesWhatTheMaskProtects) {
  for (const auto& [name, dab] : kDabs) {
    const char* brushName = name;
    Setting s;
    tousle(s);
    const Brush masked{Vec3(1, 0, 0), Vec3(1, 0, 0), 0.3f, 1, Falloff::Flat};
    ASSERT_TRUE(protect(s.groom, s.groomSurface(), masked));
    const Groom before = s.groom;
    ASSERT_TRUE(dab(s.groom, s.groomSurface(), at({1, 0, 0}, 0.6f, 1))) << name;
    s.forTexels([&](std::uint32_t texel, const Vec3& position) {
      if (glm::distance(position, masked.centre) > masked.radius) return;
      ASSERT_EQ(s.groom.map.texels()[texel], before.map.texels()[texel]) << brushName;
      ASSERT_EQ(s.groom.paint.texels()[texel][3], before.paint.texels()[texel][3]) << brushName;
    });
    // Points ask between four texels.
    for (std::size_t i = 0; i < s.points.count(); ++i)
      if (glm::distance(s.points.positions[i], masked.centre) < 0.27f) ASSERT_EQ(s.groom.comb[i], before.comb[i]) << name;
    ASSERT_TRUE(unprotect(s.groom, s.groomSurface(), masked));
    EXPECT_TRUE(s.groom.mask.isPlain());
    EXPECT_TRUE(dab(s.groom, s.groomSurface(), at({1, 0, 0}, 0.2f, 1))) << name;
  }
}

TEST(GroomBrush, ShapesAreOfOneKindEachAndEndWhereTheyAreTakenAway) {
  constexpr ShapeChannel kAll[] = {ShapeChannel::Curl, ShapeChannel::Frizz, ShapeChannel::Locks};
  for (const ShapeChannel channel : kAll) {
    Setting s;
    const Brush brush = at({1, 0, 0}, 0.4f, 0.5f);
    ASSERT_TRUE(addShape(s.groom, s.groomSurface(), brush, channel));
    EXPECT_FALSE(s.groom.shape.isPlain());
    EXPECT_TRUE(s.groom.map.isPlain());
    int most = 0;
    for (const GroomMap::Texel& texel : s.groom.shape.texels()) {
      for (std::size_t k = 0; k < 3; ++k)
        if (k != static_cast<std::size_t>(channel)) ASSERT_EQ(texel[k], 0);
      ASSERT_EQ(texel[3], texel[static_cast<std::size_t>(channel)]);
      most = std::max(most, static_cast<int>(texel[3]));
    }
    EXPECT_GT(most, 100);
    for (const ShapeChannel other : kAll)
      if (other != channel) EXPECT_FALSE(takeShape(s.groom, s.groomSurface(), brush, other));
    ASSERT_TRUE(takeShape(s.groom, s.groomSurface(), {brush.centre, brush.normal, 0.5f, 1, Falloff::Flat}, channel));
    EXPECT_TRUE(s.groom.shape.isPlain());
  }
}

TEST(GroomBrush, FalloffsStartFullEndAtTheRimAndKeepTheirOrder) {
  for (const Falloff falloff : {Falloff::Smooth, Falloff::Linear, Falloff::Sharp, Falloff::Flat}) {
    EXPECT_EQ(falloffAt(falloff, 0), 1);
    if (falloff != Falloff::Flat) EXPECT_EQ(falloffAt(falloff, 1), 0);
  }
  for (float x = 0.1f; x < 1; x += 0.1f) {
    EXPECT_GT(falloffAt(Falloff::Linear, x * x), falloffAt(Falloff::Sharp, x * x));
    EXPECT_GT(falloffAt(Falloff::Smooth, x * x), falloffAt(Falloff::Sharp, x * x));
  }
}

TEST(GroomBrush, CutLeavesWhatIsShorterAndEndsAtItsLength) {
  Setting s;
  tousle(s);
  const Groom before = s.groom;
  for (int i = 0; i < 40; ++i) cutTo(s.groom, s.groomSurface(), at({1, 1, 0}, 0.4f), 0.4f);
  int cut = 0;
  s.forTexels([&](std::uint32_t texel, const Vec3& position) {
    const int was = before.map.texels()[texel][0], is = s.groom.map.texels()[texel][0];
    ASSERT_LE(is, was);
    if (was <= 102) ASSERT_EQ(is, was);
    if (was <= 102 || glm::distance(position, glm::normalize(Vec3(1, 1, 0))) > 0.3f) return;
    ASSERT_EQ(is, 102);
    ++cut;
  });
  EXPECT_GT(cut, 100);
}

TEST(GroomBrush, PaintCoversWhatIsThereAndComesOffAgain) {
  Setting s;
  const Brush flat{Vec3(1, 0, 0), Vec3(1, 0, 0), 0.3f, 1, Falloff::Flat};
  ASSERT_TRUE(paint(s.groom, s.groomSurface(), flat, 0xff8000));
  Brush half = flat;
  half.strength = 0.5f;
  ASSERT_TRUE(paint(s.groom, s.groomSurface(), half, 0x0080ff));
  int inside = 0;
  s.forTexels([&](std::uint32_t texel, const Vec3& position) {
    if (glm::distance(position, flat.centre) > flat.radius) return;
    const GroomMap::Texel& t = s.groom.paint.texels()[texel];
    ASSERT_NEAR(t[0], 128, 1);
    ASSERT_EQ(t[1], 128);
    ASSERT_NEAR(t[2], 128, 1);
    ASSERT_EQ(t[3], 255);
    ++inside;
  });
  EXPECT_GT(inside, 100);
  // A filtered look-up at the rim meets no black.
  s.forTexels([&](std::uint32_t texel, const Vec3& position) {
    if (std::abs(glm::distance(position, flat.centre) - flat.radius) < 0.02f) ASSERT_EQ(s.groom.paint.texels()[texel][1], 128);
  });
  ASSERT_TRUE(unpaint(s.groom, s.groomSurface(), flat));
  EXPECT_TRUE(s.groom.paint.isPlain());
}

TEST(GroomBrush, TheFirstSoftStrokeHasTheBrushsColourThroughout) {
  Setting s;
  ASSERT_TRUE(paint(s.groom, s.groomSurface(), at({1, 0, 0}), 0x204060));
  s.forTexels([&](std::uint32_t texel, const Vec3&) {
    const GroomMap::Texel& t = s.groom.paint.texels()[texel];
    if (t[3] > 0) ASSERT_EQ(t[0] << 16 | t[1] << 8 | t[2], 0x204060);
  });
}

TEST(GroomBrush, TheFarSideOfAThinSheetStaysAsItIs) {
  geometry::Mesh mesh;
  for (const float y : {0.0f, -0.01f})
    for (const Vec2 at : {Vec2(-0.5f, -0.5f), Vec2(0.5f, -0.5f), Vec2(0.5f, 0.5f), Vec2(-0.5f, 0.5f)})
      mesh.positions.push_back({at.x, y, at.y});
  mesh.indices = {0, 2, 1, 0, 3, 2, 4, 5, 6, 4, 6, 7};
  Setting s(64, geometry::buildSurface(mesh).value());
  ASSERT_TRUE(trim(s.groom, s.groomSurface(), {Vec3(0), Vec3(0, 1, 0), 0.3f, 1}));
  for (std::uint32_t t = 0; t < s.surface.triangleCount(); ++t)
    s.atlas.forTexelsOf(s.surface, t, [&](std::uint32_t texel, const Vec3&) {
      const bool below = s.surface.vertices[s.surface.indices[3 * t]].position.y < 0;
      if (below) ASSERT_EQ(s.groom.map.texels()[texel][0], 255);
    });
}

TEST(GroomBrush, BrushesThatAreNoneDoNothing) {
  for (const auto& [name, dab] : kDabs) {
    Setting s;
    tousle(s);
    const auto hash = s.groom.map.hash();
    const auto before = s.groom.comb;
    const float nan = std::nanf("");
    for (const Brush& brush : {Brush{Vec3(0, 5, 0), Vec3(0, 1, 0), 0.3f, 1}, Brush{Vec3(1, 0, 0), Vec3(1, 0, 0), 0, 1},
                               Brush{Vec3(1, 0, 0), Vec3(1, 0, 0), 0.3f, 0}, Brush{Vec3(nan), Vec3(1, 0, 0), 0.3f, 1},
                               Brush{Vec3(1, 0, 0), Vec3(1, 0, 0), nan, 1}, Brush{Vec3(1, 0, 0), Vec3(nan), 0.3f, 1}})
      EXPECT_FALSE(dab(s.groom, s.groomSurface(), brush)) << name;
    EXPECT_EQ(s.groom.map.hash(), hash) << name;
    EXPECT_EQ(s.groom.comb, before) << name;
  }
}

TEST(GroomBrush, DabsThatDoNotMeetMayComeInAnyOrder) {
  Setting a, b;
  const Brush left = at({-1, 0, 0}), right = at({1, 0, 0});
  for (const Brush& brush : {left, right}) trim(a.groom, a.groomSurface(), brush), comb(a.groom, a.groomSurface(), brush, Vec3(0, 1, 0));
  for (const Brush& brush : {right, left}) comb(b.groom, b.groomSurface(), brush, Vec3(0, 1, 0)), trim(b.groom, b.groomSurface(), brush);
  EXPECT_EQ(a.groom.map.hash(), b.groom.map.hash());
  EXPECT_EQ(a.groom.comb, b.groom.comb);
}

}  // namespace
}  // namespace fur::groom
