#include "core/Result.h"

#include <gtest/gtest.h>

#include <memory>

namespace fur {
namespace {

Result<int> half(int x) {
  if (x % 2 != 0) return Error{ErrorId::BadFile, "odd"};
  return x / 2;
}

TEST(Result, HoldsAValueOrAnError) {
  EXPECT_TRUE(half(4));
  EXPECT_EQ(half(4).value(), 2);
  EXPECT_FALSE(half(3));
  EXPECT_EQ(half(3).error().id, ErrorId::BadFile);
  EXPECT_EQ(half(3).error().message, "odd");
}

TEST(Result, CarriesWhatCanOnlyBeMoved) {
  Result<std::unique_ptr<int>> result(std::make_unique<int>(5));
  EXPECT_EQ(**result, 5);
}

TEST(ErrorCode, IsSpelledAsThePublicInterfaceSpellsIt) {
  EXPECT_STREQ(errorCode(ErrorId::WebglUnavailable), "webgl-unavailable");
  EXPECT_STREQ(errorCode(ErrorId::OutOfMemory), "out-of-memory");
  EXPECT_STREQ(errorCode(ErrorId::BadFile), "bad-file");
  EXPECT_STREQ(errorCode(ErrorId::TooLarge), "too-large");
  EXPECT_STREQ(errorCode(ErrorId::UnsupportedVersion), "unsupported-version");
  EXPECT_STREQ(errorCode(ErrorId::Network), "network");
}

}  // namespace
}  // namespace fur
