#include "core/NumberText.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <limits>

#include "core/Random.h"

namespace fur {
namespace {

TEST(NumberText, ReadsDecimalNumbersAsCDoes) {
  for (const char* text : {"0", "-0", "+1", "1.", ".5", "12.25e-3", "1E5", "0.1", "6.02214076e23", "9007199254740993"}) {
    double value = -1;
    EXPECT_TRUE(readDecimal(text, value)) << text;
    EXPECT_EQ(value, std::strtod(text, nullptr)) << text;
  }
}

TEST(NumberText, ReadsNothingElse) {
  double value;
  for (const char* text : {"", "-", ".", "e5", "1e", "1e+", "1.2.3", " 1", "1 ", "0x10", "inf", "nan", "1,5", "--1"})
    EXPECT_FALSE(readDecimal(text, value)) << text;
}

TEST(NumberText, IsInfiniteBeyondADouble) {
  double value;
  EXPECT_TRUE(readDecimal("-1e400", value));
  EXPECT_EQ(value, -INFINITY);
  EXPECT_TRUE(readDecimal("1e-99999999999", value));
  EXPECT_EQ(value, 0.0);
}

TEST(NumberText, WritesTheShortestTextThatReadsBackAsTheSameFloat) {
  Random random(5);
  for (int i = 0; i < 20'000; ++i) {
    const auto bits = static_cast<std::uint32_t>(random.next());
    float value;
    std::memcpy(&value, &bits, sizeof value);
    if (!std::isfinite(value)) continue;
    char expected[32];
    for (int digits = 6; digits <= 9; ++digits) {
      std::snprintf(expected, sizeof expected, "%.*g", digits, static_cast<double>(value));
      if (std::strtof(expected, nullptr) == value) break;
    }
    ASSERT_EQ(shortDecimal(value), expected);
    double back;
    ASSERT_TRUE(readDecimal(shortDecimal(value), back)) << expected;
    ASSERT_EQ(static_cast<float>(back), value) << expected;
  }
}

TEST(NumberText, WritesWhatAPersonWouldWrite) {
  EXPECT_EQ(shortDecimal(0.1f), "0.1");
  EXPECT_EQ(shortDecimal(-2), "-2");
  EXPECT_EQ(shortDecimal(9.9999999), "10");
  EXPECT_EQ(shortDecimal(16777215), "16777215");
  EXPECT_EQ(shortDecimal(1e30), "1e+30");
  EXPECT_EQ(shortDecimal(0.000012345f), "1.2345e-05");
  EXPECT_EQ(shortDecimal(NAN), "nan");
  EXPECT_EQ(shortDecimal(-INFINITY), "-inf");
}

TEST(NumberText, WritesWholeNumbersToTheEndsOfTheirRange) {
  EXPECT_EQ(decimal(0), "0");
  EXPECT_EQ(decimal(-1), "-1");
  EXPECT_EQ(decimal(1090), "1090");
  EXPECT_EQ(decimal(std::numeric_limits<std::int64_t>::max()), "9223372036854775807");
  EXPECT_EQ(decimal(std::numeric_limits<std::int64_t>::min()), "-9223372036854775808");
}

TEST(NumberText, WritesTheLowestHexadecimalDigits) {
  EXPECT_EQ(hexadecimal(0xabc, 6), "000abc");
  EXPECT_EQ(hexadecimal(0x12345, 4), "2345");
  EXPECT_EQ(hexadecimal(0xfedcba9876543210, 16), "fedcba9876543210");
}

}  // namespace
}  // namespace fur
