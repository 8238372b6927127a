// The equations by which guides move (Halen & Wester 2007, 4 and 5.9), for single numbers as for four guides at a time.
#pragma once

#include <algorithm>

#include "core/Math.h"

namespace fur::hair {

// P + k (P - P_prev) + dt^2 a (H 4.1, where P'' = F / m): the next position. `damping` is H's k, the share of its velocity that a
// node keeps from one step to the next: 1 is undamped. Vectors are Vec3 and numbers float, or Lanes3 and Lanes.
template <class Vector, class Number>
inline Vector verletStep(const Vector& p, const Vector& pPrev, const Vector& acceleration, const Number& damping, const Number& dt) {
  return p + (p - pPrev) * damping + acceleration * (dt * dt);
}

// k / (L c)^a (H 5.9), a = 1, 2 or 3: stiffness at the distance L from the root, where it is k at L = 1 / c. Finite at the root too.
inline float springStiffness(float k, float distance, float c, int a) {
  const float x = std::max(distance * c, 1e-6f);
  return k / (a <= 1 ? x : a == 2 ? x * x : x * x * x);
}

// ((z . z_h + 1) / 2) (k - alpha) + alpha (H 4.4): alpha is what is left of stiffness k where the head hangs upside down.
inline float tiltStiffness(float k, float alpha, float zDotZh) { return 0.5f * (zDotZh + 1.0f) * (k - alpha) + alpha; }

}  // namespace fur::hair
