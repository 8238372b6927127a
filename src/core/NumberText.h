// Numbers and their texts, the same on every platform and whatever the locale. In place of std::strtod and std::snprintf,
// which bring 12 KB of code for long double to a page; <charconv> of the wasm compiler knows no fractions.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace fur {

inline bool isDigit(char c) { return c >= '0' && c <= '9'; }

// The value of a hexadecimal digit, -1 of anything else.
inline int hexDigit(char c) {
  if (isDigit(c)) return c - '0';
  const char small = static_cast<char>(c | 0x20);
  return small >= 'a' && small <= 'f' ? small - 'a' + 10 : -1;
}

// The whole of `text` as C writes decimal numbers (no spaces, hexadecimal, inf or nan), or false. Correct to the last
// bit for up to 15 digits at exponents within 22, else to 1e-15 of the number; infinite beyond double's range.
bool readDecimal(std::string_view text, double& out);

// The shortest text, of at least 6 digits before zeros at its end go, that reads back as the same float.
std::string shortDecimal(double value);

// The lowest `digits` hexadecimal digits, in small letters.
std::string hexadecimal(std::uint64_t value, int digits);

}  // namespace fur
