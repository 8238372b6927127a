#include "core/Fnv1a.h"

#include <string_view>
#include <vector>

#include <gtest/gtest.h>

namespace fur {
namespace {

std::uint64_t hashOf(std::string_view text) {
  Fnv1a hash;
  hash.addAll(text);
  return hash.value();
}

// draft-eastlake-fnv, appendix "FNV Test Vectors".
TEST(Fnv1a, GivesThePublishedValues) {
  EXPECT_EQ(hashOf(""), 0xcbf29ce484222325u);
  EXPECT_EQ(hashOf("a"), 0xaf63dc4c8601ec8cu);
  EXPECT_EQ(hashOf("foobar"), 0x85944171f73967e8u);
}

TEST(Fnv1a, IsTheSameOfBytesInPiecesAndAtOnce) {
  const std::vector<std::uint16_t> words{0x6f66, 0x626f, 0x7261};  // "foobar", little-endian
  Fnv1a atOnce, inPieces;
  atOnce.addAll(words);
  for (const std::uint16_t word : words) inPieces.add(word);
  EXPECT_EQ(atOnce.value(), hashOf("foobar"));
  EXPECT_EQ(inPieces.value(), hashOf("foobar"));
}

}  // namespace
}  // namespace fur
