// PCG32 (O'Neill 2014, "PCG: A Family of Simple Fast Space-Efficient Statistically Good Algorithms
// for Random Number Generation"): small, seedable, the same sequence on every platform.
#pragma once

#include <cstdint>

namespace fur {

class Random {
 public:
  explicit Random(std::uint64_t seed, std::uint64_t stream = 1) : increment_((stream << 1u) | 1u) {
    next();
    state_ += seed;
    next();
  }

  std::uint32_t next() {
    const std::uint64_t old = state_;
    state_ = old * 6364136223846793005ull + increment_;
    const auto shifted = static_cast<std::uint32_t>(((old >> 18u) ^ old) >> 27u);
    const auto turn = static_cast<std::uint32_t>(old >> 59u);
    return (shifted >> turn) | (shifted << ((32u - turn) & 31u));
  }

  // In [0, 1), 24 bits, exact in float.
  float uniform() { return static_cast<float>(next() >> 8) * (1.0f / 16777216.0f); }
  float uniform(float low, float high) { return low + (high - low) * uniform(); }

 private:
  std::uint64_t state_ = 0;
  std::uint64_t increment_;
};

// In [0, 1), always the same of the same two numbers. Not inlined, which keeps the download small.
[[gnu::noinline]] inline float chanceOf(std::uint32_t a, std::uint32_t b) {
  std::uint32_t x = a * 0x9e3779b1u ^ b * 0x85ebca77u;
  x = (x ^ x >> 15) * 0x2c1b3c6du;
  x = (x ^ x >> 12) * 0x297a2d39u;
  return static_cast<float>((x ^ x >> 15) >> 8) * (1.0f / 16777216.0f);
}

}  // namespace fur
