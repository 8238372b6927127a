// Math aliases. All lengths are in model units: a loaded model is scaled to the unit
// bounding sphere at the origin, so 1 is the model's bounding radius.
// Matrices are column-major (GLM), vectors are columns, right-handed, +y is up.
#pragma once

#include <cmath>

#include <glm/glm.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/gtc/quaternion.hpp>

namespace fur {

using Vec2 = glm::vec2;
using Vec3 = glm::vec3;
using Vec4 = glm::vec4;
using IVec2 = glm::ivec2;
using Mat3 = glm::mat3;
using Mat4 = glm::mat4;
using Quat = glm::quat;

inline constexpr float kPi = 3.14159265358979f;

inline float saturate(float x) { return glm::clamp(x, 0.0f, 1.0f); }

// A zero-length or non-finite vector gives `fallback`, never NaN.
inline Vec3 normalizeOr(const Vec3& v, const Vec3& fallback) {
  const float squared = glm::dot(v, v);
  return squared > 1e-24f && squared < 1e24f ? v / std::sqrt(squared) : fallback;
}

}  // namespace fur
