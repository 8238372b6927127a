// A ball of fur for the tests of dynamics: strands all over it, upright.
#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include "core/Random.h"
#include "dynamics/BendField.h"

namespace fur::dynamics {

struct FurBall {
  std::vector<Vec3> positions, directions, tangents;

  explicit FurBall(std::size_t count = 300) {
    Random random(9);
    while (positions.size() < count) {
      Vec3 v;
      v.x = random.uniform(-1, 1);
      v.y = random.uniform(-1, 1);
      v.z = random.uniform(-1, 1);
      if (glm::length(v) < 0.1f) continue;
      positions.push_back(glm::normalize(v));
      directions.push_back(glm::normalize(v));
      tangents.push_back(normalizeOr(glm::cross(Vec3(0, 1, 0), v), Vec3(1, 0, 0)));
    }
  }
  BendField field() const {
    BendField f;
    f.reset(positions, directions, tangents);
    return f;
  }
};

inline const Mat4 kStill(1.0f);

inline float farthest(const BendField& a, const BendField& b) {
  float most = 0;
  for (std::size_t i = 0; i < a.bends().size(); ++i) most = std::max(most, glm::length(a.bends()[i] - b.bends()[i]));
  return most;
}

inline float largest(const BendField& a) {
  float most = 0;
  for (const Vec4& bend : a.bends()) most = std::max(most, glm::length(Vec3(bend)));
  return most;
}

inline BendForces windy() {
  BendForces forces;
  forces.gravity = Vec3(0, -0.25f, 0);
  forces.wind.force = Vec3(0.4f, 0, 0.1f);
  return forces;
}

inline BendForces noForces() {
  BendForces forces;
  forces.gravity = Vec3(0);
  return forces;
}

}  // namespace fur::dynamics
