// How the spring of a strand answers: one time step of it for each of kWetLevels + 1 wetnesses.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "dynamics/Lanes.h"

namespace fur::dynamics {

inline constexpr int kWetLevels = 64;

// One step of x'' = -omega^2 x - 2 zeta omega x' as a matrix, exactly: any dt is stable, and n steps of dt lead where one step
// of n dt does.
struct WetRow {
  float xx, xv, vx, vv;
  float setLeft;           // of what touch has left
  float weight, catching;  // factors of gravity and of wind
  float yields = 1;        // factor of how far a force bends it
};
using WetTable = std::array<WetRow, kWetLevels + 1>;

// `stiffness` and `weight` as in BendForces, `dt` in seconds.
WetTable wetTable(float stiffness, float weight, float dt);

// Of dry fur: the spring's own frequency, rad/s; its mass; a power for numbers above 0.
float swingOf(float stiffness);
float massOf(float weight);
float powerOf(float base, float exponent);

struct WetLanes {
  Lanes xx, xv, vx, vv, setLeft, weight, catching, yields;
};
// Of four strands; `levels`: which of the rows is theirs.
inline WetLanes wetLanes(const std::vector<WetRow>& table, const std::uint16_t* levels) {
  const WetRow* rows[kLanes];
  for (std::size_t k = 0; k < kLanes; ++k) rows[k] = &table[levels[k]];
  const auto of = [&](float WetRow::*part) {
    return Lanes{rows[0]->*part, rows[1]->*part, rows[2]->*part, rows[3]->*part};
  };
  return {of(&WetRow::xx), of(&WetRow::xv), of(&WetRow::vx), of(&WetRow::vv),
          of(&WetRow::setLeft), of(&WetRow::weight), of(&WetRow::catching), of(&WetRow::yields)};
}

}  // namespace fur::dynamics
