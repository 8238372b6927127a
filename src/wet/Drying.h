// How fast water goes into the air. `dryRate`, per second: the wetness that half-wet fur loses in a second, in still air;
// wetness counts what soaks a square model unit of fur. `drying`, everywhere: dryRate times seconds.
//
// Wet fur: d rho / dt = -dryRate (1.4 - 0.8 rho). Damp fur is dry at the tips, where air takes the most. Soaked fur is dry
// after 1.06 / dryRate seconds. What lies on the fur as a film loses as much as the fur below it.
#pragma once

#include <algorithm>

namespace fur::wet {

// What fur of that wetness loses in a short step.
inline float dryingLoss(float wetness, float drying) { return drying * (1.4f - 0.8f * wetness); }

// The `drying` of one step that has the result of a long time in short steps: (e^(0.8 drying) - 1) / 0.8. By series and
// doubling: the same bits on every platform.
inline float longDrying(float drying) {
  if (drying > 0.05f) {
    const float half = longDrying(0.5f * std::min(drying, 64.0f));
    return half * (2.0f + 0.8f * half);
  }
  const float x = 0.8f * drying;
  return drying * (1.0f + x / 2 * (1.0f + x / 3 * (1.0f + x / 4)));
}

// Puddles, as if they were wet fur that dries at half the pace: amount lost by each square unit.
inline constexpr float kPuddleDrying = 0.5f;
// A hanging drop: square model units of half-wet fur that lose as much.
inline constexpr float kDropDrying = 2e-3f;
// Wind of one model radius a second makes all but drops and puddles dry faster by this share of the pace in still air.
inline constexpr float kWindDrying = 1.5f;

}  // namespace fur::wet
