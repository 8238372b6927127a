#include "dynamics/WetTable.h"

#include <algorithm>
#include <cmath>

#include "core/Math.h"
#include "core/PortableMath.h"
#include "dynamics/RigidMotion.h"

namespace fur::dynamics {

namespace {

// Chosen by eye for fur of a tenth of the model's radius.
constexpr float kDryDamping = 0.4f;  // of critical: a quarter of overshoot, gone after one swing
constexpr float kWetDamping = 0.9f;
constexpr float kWaterMass = 1.5f;   // of soaked fur, in masses of dry fur
constexpr float kWetWind = 0.5f;     // share of the wind that a soaked coat no longer catches

// How long touched fur takes to forget: e-folding time.
constexpr float kSoftMemory = 1.0f, kStiffMemory = 0.25f;  // s
constexpr float kWetMemory = 20.0f;  // times as long again when soaked

}  // namespace

float powerOf(float base, float exponent) { return portableExp(exponent * portableLog(base)); }
float swingOf(float stiffness) { return 6.0f * powerOf(4.0f, stiffness); }  // 1 to 4 swings a second
float massOf(float weight) { return 0.6f + 0.8f * unitOr0(weight); }

WetTable wetTable(float givenStiffness, float weight, float dt) {
  WetTable table;
  const float stiffness = unitOr0(givenStiffness);
  const float omega = swingOf(stiffness);
  const float memory = kSoftMemory * powerOf(kStiffMemory / kSoftMemory, stiffness);
  for (int level = 0; level <= kWetLevels; ++level) {
    const float wet = static_cast<float>(level) / kWetLevels;
    const float mass = massOf(weight) * (1.0f + kWaterMass * wet);
    const float speed = omega / std::sqrt(mass), zeta = kDryDamping + (kWetDamping - kDryDamping) * wet;
    const float turning = speed * std::sqrt(1.0f - zeta * zeta);
    const float decay = portableExp(-std::min(zeta * speed * dt, 80.0f));
    const float c = portableCos(turning * dt), s = portableSin(turning * dt);
    const float lean = zeta * speed / turning * s;
    table[static_cast<std::size_t>(level)] = {decay * (c + lean),
                                              decay * s / turning,
                                              -decay * speed * speed / turning * s,
                                              decay * (c - lean),
                                              portableExp(-std::min(dt / (memory * (1.0f + kWetMemory * wet * wet)), 80.0f)),
                                              1.0f + kWaterMass * wet,
                                              1.0f - kWetWind * wet};
  }
  return table;
}

}  // namespace fur::dynamics
