// What touches the fur: a ball that is pressed into it, or a hand that strokes it.
#pragma once

#include "dynamics/Lanes.h"

namespace fur::dynamics {

// Radians. Fur never lies through the skin; a ball may press it flatter than wind and comb do, where its tips turn over.
inline constexpr float kMaxBend = 1.35f, kMostPressed = 2.1f;

// A ball on its way through the step. Strands under it bend until their tips are below its surface, away from where it
// presses; and `grip` of them, 0..1, go along with it.
struct Contact {
  Vec3 from{0}, to{0};  // its centre, world space
  float radius = 0;     // 0: none
  float grip = 0.5f;
  float presses = kMostPressed;  // how far it bends them at most
  bool operator==(const Contact&) const = default;
};

// The same for one step, in model space.
class Press {
 public:
  Press() = default;
  Press(const Contact& contact, const Mat4& modelToWorld, float furLength);

  // Whether a strand that is rooted in the ball round `centre` may be reached.
  bool reaches(const Vec3& centre, float radius) const;
  // Bends the strands that it holds: those are the lanes of the mask. Under a ball that rests, strands that are low enough
  // stay as they were `before`. `lengths` in model units.
  LaneMask apply(Lanes3& bends, const Lanes3& before, const Lanes3& roots, const Lanes3& normals,
                 const Lanes& lengths) const;
  bool moves() const { return drag_ > 0; }
  bool operator==(const Press&) const = default;

 private:
  Vec3 from_{0}, way_{0}, along_{0};  // along_: unit, or 0
  float perWay_ = 0;                  // 1 / |way|^2, or 0
  float radius_ = 0, furLength_ = 0, most_ = 0;
  float drag_ = 0;                    // share of the strands that goes along within this step
};

}  // namespace fur::dynamics
