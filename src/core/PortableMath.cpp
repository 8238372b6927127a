#include "core/PortableMath.h"

#include <cmath>
#include <cstdint>
#include <cstring>

namespace fur {

namespace {

// Taylor series in double on [-pi/2, pi/2]; the term after x^15 is below 1e-11 there.
double sineCore(double x) {
  const double y = x * x;
  double sum = 1.0;
  for (int k = 7; k >= 1; --k) sum = 1.0 - sum * y / ((2.0 * k) * (2.0 * k + 1.0));
  return x * sum;
}

}  // namespace

float portableSin(float x) {
  constexpr double kPi = 3.14159265358979323846;
  const double turns = std::floor(static_cast<double>(x) / kPi + 0.5);
  const double reduced = static_cast<double>(x) - turns * kPi;
  const bool odd = static_cast<std::int64_t>(turns) % 2 != 0;
  return static_cast<float>(odd ? -sineCore(reduced) : sineCore(reduced));
}

float portableCos(float x) {
  constexpr double kPi = 3.14159265358979323846;
  const double shifted = static_cast<double>(x) + kPi / 2;
  const double turns = std::floor(shifted / kPi + 0.5);
  const double reduced = shifted - turns * kPi;
  const bool odd = static_cast<std::int64_t>(turns) % 2 != 0;
  return static_cast<float>(odd ? -sineCore(reduced) : sineCore(reduced));
}

float portableLog(float x) {
  // x = m 2^e with m in [sqrt(1/2), sqrt(2)); ln m = 2 artanh((m - 1) / (m + 1)).
  std::uint32_t bits;
  std::memcpy(&bits, &x, sizeof bits);
  int exponent = static_cast<int>(bits >> 23) - 127;
  bits = (bits & 0x007fffffu) | 0x3f800000u;
  float mantissa;
  std::memcpy(&mantissa, &bits, sizeof mantissa);
  double m = mantissa;
  if (m > 1.41421356) {
    m *= 0.5;
    ++exponent;
  }
  const double z = (m - 1.0) / (m + 1.0), y = z * z;
  double sum = 0.0;
  for (int k = 8; k >= 0; --k) sum = sum * y + 1.0 / (2 * k + 1);
  return static_cast<float>(2.0 * z * sum + exponent * 0.69314718055994531);
}

float portableExp(float x) {
  const double scaled = static_cast<double>(x) * 1.4426950408889634;
  const double whole = std::floor(scaled + 0.5);
  const double r = (scaled - whole) * 0.69314718055994531;
  double sum = 1.0;
  for (int k = 10; k >= 1; --k) sum = 1.0 + sum * r / k;
  const auto bits = static_cast<std::uint64_t>(static_cast<std::int64_t>(whole) + 1023) << 52;
  double power;
  std::memcpy(&power, &bits, sizeof power);
  return static_cast<float>(sum * power);
}

float portableAtan(float x) {
  // Three times the tangent of half the angle: below 0.2, where ten terms are plenty.
  double t = x;
  for (int k = 0; k < 3; ++k) t /= 1.0 + std::sqrt(1.0 + t * t);
  const double y = t * t;
  double sum = 0.0;
  for (int k = 9; k >= 0; --k) sum = 1.0 / (2 * k + 1) - sum * y;
  return static_cast<float>(8.0 * t * sum);
}

}  // namespace fur
