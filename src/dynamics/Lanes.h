// SIMD for four vertices at a time: the compiler's vector extension, one register natively and in wasm (-msimd128), with the
// rounding of plain floats. Columns stores vectors by component (structure of arrays), padded to whole blocks.
#pragma once

#include <cmath>
#include <cstring>
#include <span>
#include <vector>

#include "core/Math.h"

namespace fur::dynamics {

using Lanes [[gnu::vector_size(16)]] = float;
using LaneMask [[gnu::vector_size(16)]] = int;
inline constexpr std::size_t kLanes = 4;

inline Lanes splat(float x) { return Lanes{x, x, x, x}; }
inline Lanes load(const float* from) {
  Lanes out;
  std::memcpy(&out, from, sizeof out);
  return out;
}
inline void store(float* to, const Lanes& x) { std::memcpy(to, &x, sizeof x); }
inline Lanes min(const Lanes& a, const Lanes& b) { return a < b ? a : b; }
inline Lanes max(const Lanes& a, const Lanes& b) { return a > b ? a : b; }
inline Lanes sqrtOf(const Lanes& x) { return Lanes{std::sqrt(x[0]), std::sqrt(x[1]), std::sqrt(x[2]), std::sqrt(x[3])}; }
inline bool any(const LaneMask& mask) { return (mask[0] | mask[1] | mask[2] | mask[3]) != 0; }
// A wave of period 1 in [-1, 1], within 6 % of a sine, for |phase| < 4e6.
inline Lanes waveAt(const Lanes& phase) {
  const Lanes x = phase - ((phase + 12582912.0f) - 12582912.0f);  // rounding to whole numbers: 1.5 * 2^23
  return x * (8.0f - 16.0f * max(x, -x));
}

struct Lanes3 {
  Lanes x, y, z;
};
inline Lanes3 splat(const Vec3& v) { return {splat(v.x), splat(v.y), splat(v.z)}; }
inline Lanes3 operator+(const Lanes3& a, const Lanes3& b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
inline Lanes3 operator-(const Lanes3& a, const Lanes3& b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
inline Lanes3 operator*(const Lanes3& a, const Lanes& s) { return {a.x * s, a.y * s, a.z * s}; }
inline Lanes dot(const Lanes3& a, const Lanes3& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
inline Lanes3 cross(const Lanes3& a, const Lanes3& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
inline Lanes3 select(const LaneMask& mask, const Lanes3& yes, const Lanes3& no) {
  return {mask ? yes.x : no.x, mask ? yes.y : no.y, mask ? yes.z : no.z};
}
inline Lanes3 transformed(const Mat3& m, const Lanes3& v) {
  return {m[0].x * v.x + m[1].x * v.y + m[2].x * v.z, m[0].y * v.x + m[1].y * v.y + m[2].y * v.z,
          m[0].z * v.x + m[1].z * v.y + m[2].z * v.z};
}
inline Lanes3 across(const Lanes3& v, const Lanes3& direction) { return v - direction * dot(v, direction); }
inline Lanes3 clampLength(const Lanes3& v, float limit) {
  const Lanes squared = dot(v, v);
  const LaneMask over = squared > limit * limit;
  if (!any(over)) return v;
  return v * (over ? limit / sqrtOf(squared) : splat(1.0f));
}
// Zero for vectors that are nearly zero.
inline Lanes3 normalize(const Lanes3& v) {
  const Lanes squared = dot(v, v);
  return v * (squared > 1e-20f ? 1.0f / sqrtOf(max(squared, splat(1e-20f))) : splat(0.0f));
}

// All x, then all y, then all z, each padded to a whole block.
class Columns {
 public:
  static constexpr std::size_t kBlock = 64;
  static std::size_t padded(std::size_t count) { return (count + kBlock - 1) / kBlock * kBlock; }

  void assign(std::size_t count, const Vec3& value) {
    rows_ = padded(count);
    numbers_.resize(3 * rows_);
    for (std::size_t i = 0; i < rows_; ++i) set(i, value);
  }
  void assign(std::span<const Vec3> values, const Vec3& padding) {
    assign(values.size(), padding);
    take(values);
  }
  // The same number of new values.
  void take(std::span<const Vec3> values) {
    for (std::size_t i = 0; i < values.size(); ++i) set(i, values[i]);
  }
  void clear() { numbers_.clear(); }
  bool empty() const { return numbers_.empty(); }
  void set(std::size_t i, const Vec3& v) {
    float* to = &numbers_[i];
    to[0] = v.x;
    to[rows_] = v.y;
    to[2 * rows_] = v.z;
  }
  Vec3 at(std::size_t i) const {
    const float* from = &numbers_[i];
    return {from[0], from[rows_], from[2 * rows_]};
  }
  Lanes3 lanes(std::size_t i) const {
    const float* from = &numbers_[i];
    return {load(from), load(from + rows_), load(from + 2 * rows_)};
  }
  void set(std::size_t i, const Lanes3& v) {
    float* to = &numbers_[i];
    store(to, v.x);
    store(to + rows_, v.y);
    store(to + 2 * rows_, v.z);
  }

 private:
  std::vector<float> numbers_;
  std::size_t rows_ = 0;
};

}  // namespace fur::dynamics
