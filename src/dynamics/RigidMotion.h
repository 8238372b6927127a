// Makes transforms and settings safe to compute with.
#pragma once

#include <algorithm>
#include <cmath>

#include "core/Math.h"

namespace fur::dynamics {

inline Vec3 finiteOr0(const Vec3& v) { return std::isfinite(v.x + v.y + v.z) ? v : Vec3(0); }
inline float unitOr0(float x) { return x > 0.0f ? std::min(x, 1.0f) : 0.0f; }

inline bool finite(const Mat4& m) {
  float sum = 0;
  for (int c = 0; c < 4; ++c)
    for (int r = 0; r < 4; ++r) sum += m[c][r];
  return std::isfinite(sum);
}

// The rotation of a rigid (perhaps uniformly scaled) transform.
inline Mat3 rotationOf(const Mat4& m) {
  return Mat3(normalizeOr(Vec3(m[0]), Vec3(1, 0, 0)), normalizeOr(Vec3(m[1]), Vec3(0, 1, 0)),
              normalizeOr(Vec3(m[2]), Vec3(0, 0, 1)));
}

}  // namespace fur::dynamics
