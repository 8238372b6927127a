// Contacts with the fur: a ball that is pressed into it, or a hand that strokes it.
#pragma once

#include "dynamics/Lanes.h"

namespace fur::dynamics {

// Radians. The largest bend by forces and comb, at which tips just stay above the skin; and by contacts, at which tips point
// back to it.
inline constexpr float kMaxBend = 1.35f, kMostPressed = 2.1f;

// A ball that moves during the step. Strands under it bend away from its centre until their tips are below its surface, and
// are dragged along with its motion.
struct Contact {
  Vec3 from{0}, to{0};  // its centre, world space
  float radius = 0;     // 0: none
  float grip = 0.5f;    // 0..1: how much they are dragged along
  float presses = kMostPressed;  // the largest bend, radians
  bool operator==(const Contact&) const = default;
};

// A contact in one step, in model space.
class Press {
 public:
  Press() = default;
  Press(const Contact& contact, const Mat4& modelToWorld, float furLength);

  // Whether it may touch a strand rooted in the ball round `centre`.
  bool reaches(const Vec3& centre, float radius) const;
  // Bends the strands that it touches and returns their lanes. Under a ball at rest, strands that are low enough stay as they
  // were `before`. `lengths` in model units.
  LaneMask apply(Lanes3& bends, const Lanes3& before, const Lanes3& roots, const Lanes3& normals,
                 const Lanes& lengths) const;
  bool moves() const { return drag_ > 0; }
  bool operator==(const Press&) const = default;

 private:
  Vec3 from_{0}, way_{0}, along_{0};  // along_: unit, or 0
  float perWay_ = 0;                  // 1 / |way|^2, or 0
  float radius_ = 0, furLength_ = 0, most_ = 0;
  float drag_ = 0;                    // how far strands are dragged along in this step, 0..1
};

}  // namespace fur::dynamics
