// Which edges bear a fin, and how opaque it is (Sheppard 2004, 3.2.1).
#pragma once

#include <algorithm>
#include <cmath>

#include "core/Math.h"

namespace fur::furgen {

// Eq. 3.1: an edge bears a fin where (n1.v)(n2.v) is below this, of unit vectors.
inline constexpr float kFinThreshold = 0.3f;

// `facing`: (n1.v)(n2.v), of the two faces' normals and the way to the eye; `across`: N.v, of the fin's own normal. Eq. 3.2: 3 |N.v|,
// up to 1. As printed that jumps where fins begin, while the text has them fade in: it rises from 0 at the threshold to all of it where
// the surface is seen edge-on.
inline float finOpacity(float facing, float across) {
  return std::min(3.0f * std::abs(across), 1.0f) * (1.0f - glm::smoothstep(0.0f, kFinThreshold, facing));
}

}  // namespace fur::furgen
