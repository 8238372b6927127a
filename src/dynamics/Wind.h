// The wind over a body: a steady part, gusts that travel over it as waves, eddies, and shelter on the lee side.
#pragma once

#include <algorithm>

#include "dynamics/Lanes.h"

namespace fur::dynamics {

struct Wind {
  Vec3 force{0};         // world space: direction and strength, 0..1
  float gust = 0;        // 0..1: the share that varies in waves that travel with the wind
  float turbulence = 0;  // 0..1: strength of eddies, as a share of the wind's
  double time = 0;       // s
  bool varies() const { return force != Vec3(0) && (gust > 0 || turbulence > 0); }
  Wind mean() const { return {force * (1.0f - 0.5f * (gust > 0 ? std::min(gust, 1.0f) : 0.0f))}; }
  bool operator==(const Wind&) const = default;
};

// The wind at one moment in model space; the same bits on every platform.
class WindField {
 public:
  WindField(const Wind& wind, const Mat4& modelToWorld);

  // 1 on the windward side, down to a rest on the lee side.
  Lanes exposure(const Lanes3& outward) const;
  // The wind at a point that is fully exposed.
  Lanes3 at(const Lanes3& point) const;

 private:
  static constexpr int kGusts = 2, kEddies = 5;
  struct Wave {
    Vec3 cycles;  // per model unit, along the axes
    float phase;
    Vec3 force;   // at its crest
  };
  Vec3 direction_, steady_;
  Wave waves_[kGusts + kEddies];
  int waveCount_ = 0;
};

}  // namespace fur::dynamics
