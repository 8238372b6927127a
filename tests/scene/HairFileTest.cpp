#include "scene/HairFile.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstring>
#include <limits>

#include "AllocatedBytes.h"
#include "OnEveryPlatform.h"
#include "core/Fnv1a.h"
#include "core/Random.h"
#include "hair/MemberStrands.h"
#include "hair/TestScalps.h"

namespace fur::scene {
namespace {

using ByteVector = std::vector<std::uint8_t>;
constexpr float kNan = std::numeric_limits<float>::quiet_NaN(), kInf = std::numeric_limits<float>::infinity();

// Three strands of 2, 1 and 3 segments.
HairFile small() {
  HairFile hair;
  hair.segments = {2, 1, 3};
  for (int i = 0; i < 9; ++i) hair.points.push_back({0.1f * static_cast<float>(i), 1, static_cast<float>(i)});
  for (int i = 0; i < 9; ++i) hair.thickness.push_back(0.01f * static_cast<float>(9 - i));
  hair.transparency.assign(9, 0.25f);
  hair.colors.assign(9, {0.5f, 0.25f, 0.125f});
  hair.defaultThickness = 0.5f, hair.defaultTransparency = 0.125f, hair.defaultColor = {1, 0.5f, 0};
  hair.info = "three strands";
  return hair;
}

template <class T>
ByteVector with(ByteVector bytes, std::size_t at, T value) {
  std::memcpy(&bytes[at], &value, sizeof value);
  return bytes;
}
ByteVector cut(ByteVector bytes, std::size_t size) {
  bytes.resize(size);
  return bytes;
}

void expectFileError(const ByteVector& bytes, ErrorId id, const std::string& message) {
  const std::size_t before = allocatedBytes();
  auto hair = readHair(bytes, "a.hair");
  ASSERT_FALSE(hair) << "read; expected " << message;
  EXPECT_EQ(hair.error().id, id);
  EXPECT_EQ(hair.error().message, "a.hair: " + message);
  EXPECT_LT(allocatedBytes() - before, 4 * bytes.size() + 4000);
}

TEST(HairFile, ItIsReadAsItWasWritten) {
  HairFile bare = small();
  bare.thickness.clear(), bare.transparency.clear(), bare.colors.clear();
  HairFile even = small();
  even.segments = {2, 2, 2};
  for (const HairFile& hair : {small(), bare, even}) {
    const ByteVector bytes = writeHair(hair);
    auto again = readHair(bytes, "a.hair");
    ASSERT_TRUE(again) << again.error().message;
    EXPECT_EQ(*again, hair);
    EXPECT_EQ(writeHair(*again), bytes);
  }
  EXPECT_EQ(writeHair(small()).size(), 128u + 3 * 2 + 9 * (12 + 4 + 4 + 12));
  EXPECT_EQ(writeHair(even).size(), 128u + 9 * (12 + 4 + 4 + 12));
}

TEST(HairFile, TheHeaderIsAsTheFormatHasIt) {
  const ByteVector bytes = writeHair(small());
  const auto number = [&](std::size_t at) { std::uint32_t n; std::memcpy(&n, &bytes[at], 4); return n; };
  EXPECT_EQ(std::string(bytes.begin(), bytes.begin() + 4), "HAIR");
  EXPECT_EQ(number(4), 3u);
  EXPECT_EQ(number(8), 9u);
  EXPECT_EQ(number(12), 31u);
  EXPECT_EQ(std::string(reinterpret_cast<const char*>(&bytes[40])), "three strands");
  HairFile talkative = small();
  talkative.info = std::string(200, 'x');
  EXPECT_EQ(readHair(writeHair(talkative), "a.hair")->info, std::string(87, 'x'));
}

TEST(HairFile, BytesThatDoNotAddUpAreRejected) {
  const ByteVector good = writeHair(small());
  expectFileError({}, ErrorId::BadFile, "it has 0 bytes; the header of a .hair file has 128");
  expectFileError(cut(good, 127), ErrorId::BadFile, "it has 127 bytes; the header of a .hair file has 128");
  expectFileError(with(good, 0, 'h'), ErrorId::BadFile, "it does not begin with HAIR");
  expectFileError(cut(good, good.size() - 1), ErrorId::BadFile, "its 3 strands and 9 points need 294 bytes after the header; it has 293");
  expectFileError(with(good, 4, 0u), ErrorId::BadFile, "it has 0 strands and 9 points");
  expectFileError(with(good, 8, 0u), ErrorId::BadFile, "it has 3 strands and 0 points");
  expectFileError(with(good, 12, 29u), ErrorId::BadFile, "it has no points");
  expectFileError(with(good, 12, 63u), ErrorId::UnsupportedVersion, "its flags are 63; 1, 2, 4, 8 and 16 are known");
  expectFileError(with(good, 128, std::uint16_t{3}), ErrorId::BadFile, "the segments of its strands make 10 points; its header says 9");
  expectFileError(with(good, 128, std::uint16_t{65535}), ErrorId::BadFile, "the segments of its strands make 65542 points; its header says 9");
  ByteVector even = with(with(good, 12, 2u), 16, 0u);
  expectFileError(even, ErrorId::BadFile, "its strands have 0 segments each; 1 to 65535 can be");
  expectFileError(with(even, 16, 65536u), ErrorId::BadFile, "its strands have 65536 segments each; 1 to 65535 can be");
  expectFileError(with(even, 16, 4u), ErrorId::BadFile, "the segments of its strands make 15 points; its header says 9");
}

TEST(HairFile, ManyStrandsInAFewBytesTakeNoMemory) {
  const ByteVector tiny = cut(writeHair(small()), 168);
  expectFileError(with(tiny, 4, 1000000u), ErrorId::BadFile, "its 1000000 strands and 9 points need 2000288 bytes after the header; it has 40");
  expectFileError(with(tiny, 8, 8000000u), ErrorId::BadFile, "its 3 strands and 8000000 points need 256000006 bytes after the header; it has 40");
  expectFileError(with(tiny, 4, 1000001u), ErrorId::TooLarge, "it has 1000001 strands; at most 1000000 are read");
  expectFileError(with(tiny, 4, 0xffffffffu), ErrorId::TooLarge, "it has 4294967295 strands; at most 1000000 are read");
  expectFileError(with(tiny, 8, 0xffffffffu), ErrorId::TooLarge, "it has 4294967295 points; at most 8000000 are read");
}

TEST(HairFile, WhatIsNoNumberIsRejected) {
  const ByteVector good = writeHair(small());
  const std::size_t points = 128 + 6, thickness = points + 9 * 12, transparency = thickness + 9 * 4, colors = transparency + 9 * 4;
  for (const float bad : {kNan, kInf, -kInf, 1.1e9f})
    expectFileError(with(good, points + 4 * 12 + 8, bad), ErrorId::BadFile, "point 4 is no place within 10^9 of the origin");
  for (const float bad : {kNan, kInf}) {
    expectFileError(with(good, thickness + 8, bad), ErrorId::BadFile, "the thickness of point 2 is not a number");
    expectFileError(with(good, transparency, bad), ErrorId::BadFile, "the transparency of point 0 is not a number");
    expectFileError(with(good, colors + 8 * 12, bad), ErrorId::BadFile, "the colour of point 8 is not a number");
    for (const std::size_t at : {20, 24, 28, 32, 36}) expectFileError(with(good, at, bad), ErrorId::BadFile, "a default in its header is not a number");
  }
}

TEST(HairFile, AnyBytesAreReadOrRejected) {
  const ByteVector good = writeHair(small());
  Random random(9);
  int read = 0;
  for (int i = 0; i < 4000; ++i) {
    ByteVector bytes = cut(good, random.next() % 3 ? good.size() : random.next() % good.size());
    for (std::uint32_t k = 0; k < 1 + random.next() % 3 && !bytes.empty(); ++k)
      bytes[random.next() % std::min<std::size_t>(bytes.size(), random.next() % 2 ? 40 : 1000)] = static_cast<std::uint8_t>(random.next());
    auto hair = readHair(bytes, "a.hair");
    read += static_cast<bool>(hair);
    if (!hair) EXPECT_EQ(hair.error().message.find("a.hair: "), 0u);
    else (void)guidesOf(*hair, {}, "a.hair");
  }
  EXPECT_GT(read, 100);
}

// Straight strands, z up, that lean outwards from a disc.
HairFile disc(int count) {
  HairFile hair;
  Random random(3);
  for (int s = 0; s < count; ++s) {
    Vec3 root;
    do root = {random.uniform(-10, 10), random.uniform(-10, 10), 0};
    while (glm::length(root) > 10);
    for (int i = 0; i <= 12; ++i) hair.points.push_back(root + static_cast<float>(i) * Vec3(0.03f * root.x, 0.03f * root.y, 0.5f));
    hair.segments.push_back(12);
  }
  return hair;
}

TEST(HairGuides, FewStrandsBecomeGuidesOneByOne) {
  const HairFile hair = disc(20);
  auto guides = guidesOf(hair, {.up = HairUp::Z, .nodes = 5}, "a.hair");
  ASSERT_TRUE(guides);
  ASSERT_EQ(guides->count(), 20u);
  EXPECT_EQ(guides->nodes, 5);
  for (std::size_t g = 0; g < 20; ++g) {
    const Vec3 first = hair.points[13 * g], last = hair.points[13 * g + 12];
    EXPECT_EQ(guides->root(g), Vec3(first.x, first.z, -first.y));
    EXPECT_LT(glm::length(guides->of(g).back() - Vec3(last.x, last.z, -last.y)), 1e-4f);
  }
  EXPECT_EQ(guidesOf(hair, {.up = HairUp::Y}, "a.hair")->root(3), hair.points[39]);
}

TEST(HairGuides, OfManyStrandsAFewStandForAll) {
  const HairFile hair = disc(3000);
  auto guides = guidesOf(hair, {.count = 60}, "a.hair");
  ASSERT_TRUE(guides);
  EXPECT_LE(guides->count(), 60u);
  EXPECT_GE(guides->count(), 50u);
  double mean = 0;
  for (std::size_t s = 0; s < 3000; ++s) {
    const Vec3 root = hair.points[13 * s];
    float nearest = 99;
    for (std::size_t g = 0; g < guides->count(); ++g) nearest = std::min(nearest, glm::length(guides->root(g) - Vec3(root.x, root.z, -root.y)));
    EXPECT_LT(nearest, 4.5f);
    mean += nearest / 3000;
  }
  // Each serves a place of radius 10 / sqrt(60).
  EXPECT_LT(mean, 1.3);
  EXPECT_EQ(*guides, *guidesOf(hair, {.count = 60}, "a.hair"));
}

TEST(HairGuides, StrandsOfOnePlaceCountForNothing) {
  HairFile hair = disc(5);
  for (std::size_t i = 0; i < 13; ++i) hair.points[i] = hair.points[0];
  EXPECT_EQ(guidesOf(hair, {}, "a.hair")->count(), 4u);
  for (Vec3& p : hair.points) p = Vec3(1);
  auto none = guidesOf(hair, {}, "a.hair");
  ASSERT_FALSE(none);
  EXPECT_EQ(none.error().message, "a.hair: none of its strands has a length");
  auto many = guidesOf(disc(3), {.count = 2000}, "a.hair");
  ASSERT_FALSE(many);
  EXPECT_EQ(many.error().id, ErrorId::TooLarge);
  EXPECT_EQ(many.error().message, "a.hair: 2000 guides; a scalp has 1 to 1024");
}

TEST(HairGuides, TheyAreFittedToTheScalpAndStandOnTheSkin) {
  hair::test::TestScalp sphere(geometry::makeSphere());
  sphere.paint([](const Vec3& p) -> groom::GroomMap::Texel { return {static_cast<std::uint8_t>(p.y > 0.5f ? 255 : 0), 255, 255, 255}; });
  auto guides = guidesOf(disc(200), {.count = 200}, "a.hair", sphere.scalp(), sphere.query);
  ASSERT_TRUE(guides);
  Vec3 middle(0);
  for (std::size_t g = 0; g < guides->count(); ++g) {
    EXPECT_NEAR(glm::length(guides->root(g)), 1, 0.01f);
    EXPECT_GT(guides->root(g).y, 0.3f);
    EXPECT_GT(guides->of(g).back().y, guides->root(g).y + 0.2f);
    middle += guides->root(g) / static_cast<float>(guides->count());
  }
  EXPECT_LT(glm::length(Vec2(middle.x, middle.z)), 0.1f);
  sphere.paint([](const Vec3&) { return groom::GroomMap::kBlank; });
  auto none = guidesOf(disc(9), {}, "a.hair", sphere.scalp(), sphere.query);
  ASSERT_FALSE(none);
  EXPECT_EQ(none.error().message, "a.hair: the scalp for its strands covers nothing: its density is 0 everywhere");
}

TEST(HairGuides, GuidesSurviveAFile) {
  const hair::test::TestScalp sphere(geometry::makeSphere());
  const hair::Guides guides = hair::plantGuides(sphere.scalp(), {}, 50).value();
  for (const HairUp up : {HairUp::Y, HairUp::Z}) {
    auto file = readHair(writeHair(hairOfGuides(guides, 0.004f, up)), "a.hair");
    ASSERT_TRUE(file);
    EXPECT_EQ(file->defaultThickness, 0.004f);
    auto again = guidesOf(*file, {.up = up, .nodes = guides.nodes, .count = 50}, "a.hair");
    ASSERT_EQ(again->count(), 50u);
    for (std::size_t i = 0; i < guides.positions.size(); ++i) EXPECT_LT(glm::length(again->positions[i] - guides.positions[i]), 1e-5f);
  }
}

struct Hair {
  Hair() : sphere(geometry::makeSphere()) {
    values.wisps = 20, values.strands = 7, values.rootColor = 0xff0000, values.tipColor = 0x0000ff, values.variance = 0;
    guides = hair::plantGuides(sphere.scalp(), values, 12).value();
    const auto roots = sphere.roots(guides);
    nodes = hair::restNodes(guides, roots);
    wisps = hair::plantWisps(sphere.scalp(), guides, roots, values);
  }
  Result<HairFile> file() const { return hairOfWisps(wisps, nodes, guides.nodes, values, HairUp::Y); }

  hair::test::TestScalp sphere;
  hair::HairValues values;
  hair::Guides guides;
  std::vector<hair::GuideNode> nodes;
  std::vector<hair::Wisp> wisps;
};

TEST(HairExport, EveryStrandOfEveryWispIsThere) {
  const Hair hair;
  auto file = hair.file();
  ASSERT_TRUE(file);
  EXPECT_EQ(file->segments, std::vector<std::uint16_t>(140, 16));
  ASSERT_EQ(file->points.size(), 140u * 17);
  for (std::size_t s = 0; s < 140; ++s) {
    const hair::Wisp& wisp = hair.wisps[s / 7];
    EXPECT_LT(glm::length(file->points[17 * s] - wisp.root), 0.5f * wisp.width);
    EXPECT_EQ(file->thickness[17 * s], hair.values.strandWidth);
    EXPECT_EQ(file->thickness[17 * s + 16], 0.0f);
    EXPECT_LT(glm::length(file->colors[17 * s] - Vec3(1, 0, 0)), 0.01f);
    EXPECT_LT(glm::length(file->colors[17 * s + 16] - Vec3(0, 0, 1)), 0.01f);
  }
  EXPECT_TRUE(readHair(writeHair(*file), "a.hair"));
}

TEST(HairExport, CurlsGetTheSegmentsThatTheyNeed) {
  Hair hair;
  hair.values.curl = 0.5f, hair.values.curls = 8;
  EXPECT_EQ(hair.file()->segments[0], 80);
}

TEST(HairExport, MoreThanAFileHoldsIsAnError) {
  Hair hair;
  hair.values.strands = 64;
  hair.wisps.resize(20000, hair.wisps[0]);
  auto file = hair.file();
  ASSERT_FALSE(file);
  EXPECT_EQ(file.error().id, ErrorId::TooLarge);
  EXPECT_EQ(file.error().message, "hair: 1280000 strands of 21760000 points; a .hair file has at most 1000000 of 8000000");
}

TEST(HairExport, ItIsTheSameOnEveryPlatform) {
  Fnv1a hash;
  hash.addAll(writeHair(*Hair().file()));
  hash.addAll(guidesOf(disc(500), {.count = 40}, "a.hair")->positions);
  test::printOnEveryPlatform("a .hair file", hash.value());
}

}  // namespace
}  // namespace fur::scene
