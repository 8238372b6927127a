// Settings of which each field has a random value.
#pragma once

#include "core/Random.h"
#include "settings/Settings.h"

namespace fur::settings {

inline Settings randomSettings(std::uint64_t seed) {
  Random random(seed);
  Settings out;
  Warnings warnings;
  for (const Field& field : fields()) setField(out, field, field.low + (field.high - field.low) * random.uniform(), warnings);
  return out;
}

}  // namespace fur::settings
