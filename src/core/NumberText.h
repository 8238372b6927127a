// Numbers to text and back, the same on every platform and in every locale. std::strtod and std::snprintf would add 12 KB of
// code for long double to the download, and <charconv> of the wasm compiler has no fractions.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace fur {

inline bool isDigit(char c) { return c >= '0' && c <= '9'; }

// The value of a hexadecimal digit, -1 for any other character.
inline int hexDigit(char c) {
  if (isDigit(c)) return c - '0';
  const char small = static_cast<char>(c | 0x20);
  return small >= 'a' && small <= 'f' ? small - 'a' + 10 : -1;
}

// Reads all of `text` as a decimal number in C's syntax, without spaces, hexadecimal, inf and nan; false when it is not one.
// Correct to the last bit for up to 15 digits and exponents within 22, else within 1e-15 of the number; infinite
// beyond the range of double.
bool readDecimal(std::string_view text, double& out);

// A whole number. std::to_string would add 0.9 KB to the download: a function for each of five types.
std::string decimal(std::int64_t number);

// The shortest text that reads back as the same float, from 6 digits up; zeros at its end are left out.
std::string shortDecimal(double value);

// The lowest `digits` hexadecimal digits, in lower case.
std::string hexadecimal(std::uint64_t value, int digits);

}  // namespace fur
