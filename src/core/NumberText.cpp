#include "core/NumberText.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace fur {

namespace {

// value * 10^exponent
double scaled(double value, int exponent) {
  for (; exponent > 22 && value != 0.0 && std::isfinite(value); exponent -= 22) value *= 1e22;
  for (; exponent < -22 && value != 0.0; exponent += 22) value /= 1e22;
  double power = 1.0;  // exact up to 10^22
  for (int i = 0; i < std::min(std::abs(exponent), 22); ++i) power *= 10.0;
  return exponent < 0 ? value / power : value * power;
}

}  // namespace

bool readDecimal(std::string_view text, double& out) {
  const char *at = text.data(), *const end = at + text.size();
  const auto sign = [&] {
    const bool negative = at < end && *at == '-';
    if (at < end && (*at == '-' || *at == '+')) ++at;
    return negative;
  };
  const bool negative = sign();
  std::uint64_t mantissa = 0;
  int exponent = 0;
  bool point = false, any = false;
  for (; at < end && (isDigit(*at) || (*at == '.' && !point)); ++at) {
    if (*at == '.') {
      point = true;
      continue;
    }
    any = true;
    const bool fits = mantissa < 1'000'000'000'000'000'000u;  // digits beyond count only for the size
    if (fits) mantissa = mantissa * 10 + static_cast<std::uint64_t>(*at - '0');
    exponent += (fits ? 0 : 1) - (point ? 1 : 0);
  }
  if (any && at < end && (*at == 'e' || *at == 'E')) {
    ++at;
    const bool down = sign();
    any = at < end;
    int given = 0;
    for (; at < end && isDigit(*at); ++at) given = std::min(given * 10 + (*at - '0'), 100'000);
    exponent += down ? -given : given;
  }
  out = scaled(static_cast<double>(mantissa), exponent);
  if (negative) out = -out;
  return any && at == end;
}

std::string decimal(std::int64_t number) {
  std::string out;
  auto rest = static_cast<std::uint64_t>(number);
  if (number < 0) rest = 0 - rest;
  do out.insert(out.begin(), static_cast<char>('0' + rest % 10));
  while (rest /= 10);
  return number < 0 ? "-" + out : out;
}

std::string shortDecimal(double value) {
  std::string out = std::signbit(value) ? "-" : "";
  const double size = std::abs(value);
  if (!std::isfinite(value)) return std::isnan(value) ? "nan" : out + "inf";
  if (size == 0.0) return out + "0";
  int exponent = 0;  // of the first digit
  while (size >= scaled(1, exponent + 1)) ++exponent;
  while (size < scaled(1, exponent)) --exponent;
  int digits = 6;
  double whole;
  do {
    whole = std::nearbyint(scaled(size, digits - 1 - exponent));
  } while (static_cast<float>(scaled(whole, exponent + 1 - digits)) != static_cast<float>(size) && ++digits <= 9);
  std::string text = decimal(static_cast<std::int64_t>(whole));
  if (text.size() > static_cast<std::size_t>(digits)) ++exponent;  // 9.9999996 became 10.0000
  text.erase(text.find_last_not_of('0') + 1);
  if (exponent < -4 || exponent >= digits) {
    if (text.size() > 1) text.insert(1, ".");
    const int power = std::abs(exponent);
    text += exponent < 0 ? "e-" : "e+";
    if (power < 10) text += '0';
    return out + text + decimal(power);
  }
  if (exponent < 0) return out + "0." + std::string(static_cast<std::size_t>(-exponent - 1), '0') + text;
  const auto before = static_cast<std::size_t>(exponent) + 1;
  if (text.size() < before) text.append(before - text.size(), '0');
  if (text.size() > before) text.insert(before, ".");
  return out + text;
}

std::string hexadecimal(std::uint64_t value, int digits) {
  std::string out;
  while (digits-- > 0) out += "0123456789abcdef"[value >> (4 * digits) & 15];
  return out;
}

}  // namespace fur
