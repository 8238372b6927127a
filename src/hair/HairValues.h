// The numbers of one scalp's hair as plain values: HairFields.inc is the only place that lists them.
#pragma once

#include <cstdint>

namespace fur::hair {

struct HairValues {
#define FUR_FLOAT(name, label, group, value, low, high, unit, tip, ...) float name = value;
#define FUR_INT(name, label, group, value, low, high, unit, tip, ...) int name = value;
#define FUR_BOOL(name, label, group, value, tip, ...) bool name = value;
#define FUR_COLOR(name, label, group, value, tip, ...) std::uint32_t name = value;  // 0xRRGGBB, sRGB
#define FUR_CHOICE(name, label, group, value, options, tip, ...) int name = value;
#include "hair/HairFields.inc"
#undef FUR_FLOAT
#undef FUR_INT
#undef FUR_BOOL
#undef FUR_COLOR
#undef FUR_CHOICE
  bool operator==(const HairValues&) const = default;
};

}  // namespace fur::hair
