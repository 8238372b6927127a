// The wind over a body: a steady share, gusts that run over it as waves, and eddies; and what of it reaches which side.
#pragma once

#include <algorithm>

#include "dynamics/Lanes.h"

namespace fur::dynamics {

struct Wind {
  Vec3 force{0};         // world space, 0..1: where it blows to, and its strength
  float gust = 0;        // 0..1: the share that comes and goes, in waves that travel with the wind
  float turbulence = 0;  // 0..1: strength of eddies, as a share of the wind's
  double time = 0;       // s
  bool varies() const { return force != Vec3(0) && (gust > 0 || turbulence > 0); }
  Wind mean() const { return {force * (1.0f - 0.5f * (gust > 0 ? std::min(gust, 1.0f) : 0.0f))}; }
  bool operator==(const Wind&) const = default;
};

// The wind at one moment in the space of a model: the same numbers on every machine.
class WindField {
 public:
  WindField(const Wind& wind, const Mat4& modelToWorld);

  // 1 on the side that it comes from, down to what reaches the lee side.
  Lanes exposure(const Lanes3& outward) const;
  // On a side that is fully exposed, at a point.
  Lanes3 at(const Lanes3& point) const;

 private:
  static constexpr int kGusts = 2, kEddies = 5;
  struct Wave {
    Vec3 cycles;  // per model unit, along the axes
    float phase;
    Vec3 force;   // of its crest
  };
  Vec3 direction_, steady_;
  Wave waves_[kGusts + kEddies];
  int waveCount_ = 0;
};

}  // namespace fur::dynamics
