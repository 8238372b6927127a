// Long hair as water meets it (Water.h, Accounts). Hair is a part that only some programs have: who grows it derives from this.
// Amounts are Water's; world space.
#pragma once

#include <vector>

#include "core/Math.h"
#include "wet/Drop.h"

namespace fur::wet {

struct Climate;

class WetHair {
 public:
  virtual ~WetHair() = default;

  virtual double water() const = 0;  // that it holds
  // Whether a step would change anything.
  virtual bool active(const Climate& climate) const = 0;
  // What it takes of a drop of so much water that goes `way` in a step.
  virtual float take(const Vec3& from, const Vec3& way, float water) = 0;
  // A step of Water::kStep: what leaves it is added to the drops, up to Water::kMostDrops of them. Returns what has dried.
  virtual double step(const Climate& climate, std::vector<Drop>& drops) = 0;
};

}  // namespace fur::wet
