// The numbers of one scalp's hair as plain values: HairFields.inc is the only place that lists them.
#pragma once

#include <cstdint>

namespace fur::hair {

struct HairValues {
#define FUR_FIELDS "hair/HairFields.inc"
#include "settings/fields/Members.inc"
#undef FUR_FIELDS
  bool operator==(const HairValues&) const = default;
};

}  // namespace fur::hair
