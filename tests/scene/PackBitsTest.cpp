#include "scene/PackBits.h"

#include <gtest/gtest.h>

#include "core/Random.h"

namespace fur::scene {
namespace {

using ByteVector = std::vector<std::uint8_t>;

TEST(PackBits, UnpacksTheExampleOfAppleAndTiff) {
  const ByteVector packed{0xfe, 0xaa, 0x02, 0x80, 0x00, 0x2a, 0xfd, 0xaa, 0x03, 0x80, 0x00, 0x2a, 0x22, 0xf7, 0xaa};
  ByteVector bytes(24);
  ASSERT_TRUE(unpackBits(packed, bytes));
  EXPECT_EQ(bytes, (ByteVector{0xaa, 0xaa, 0xaa, 0x80, 0x00, 0x2a, 0xaa, 0xaa, 0xaa, 0xaa, 0x80, 0x00, 0x2a, 0x22, 0xaa, 0xaa,
                          0xaa, 0xaa, 0xaa, 0xaa, 0xaa, 0xaa, 0xaa, 0xaa}));
  EXPECT_EQ(packBits(bytes), packed);
}

TEST(PackBits, WhatGoesInComesOut) {
  Random random(3);
  for (int round = 0; round < 300; ++round) {
    ByteVector bytes;
    while (bytes.size() < random.next() % 900) bytes.insert(bytes.end(), 1 + random.next() % (round + 1), static_cast<std::uint8_t>(random.next() % 4));
    const ByteVector packed = packBits(bytes);
    EXPECT_LE(packed.size(), bytes.size() + bytes.size() / 128 + 1);
    ByteVector back(bytes.size());
    ASSERT_TRUE(unpackBits(packed, back));
    ASSERT_EQ(back, bytes);
  }
}

TEST(PackBits, EvenMapsTakeAHundredthAndLess) { EXPECT_LT(packBits(ByteVector(65536, 255)).size(), 1100u); }

TEST(PackBits, RefusesTooFewTooManyAndCutOff) {
  const ByteVector packed = packBits(ByteVector{1, 2, 3, 4, 4, 4, 4, 4});
  for (const std::size_t size : {0u, 7u, 9u}) {
    ByteVector bytes(size);
    EXPECT_FALSE(unpackBits(packed, bytes)) << size;
  }
  ByteVector bytes(8);
  for (std::size_t cut = 0; cut < packed.size(); ++cut)
    EXPECT_FALSE(unpackBits(std::span(packed).first(cut), bytes)) << cut;
  EXPECT_TRUE(unpackBits(packed, bytes));
}

}  // namespace
}  // namespace fur::scene
