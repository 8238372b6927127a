// Apart from the table, so that only programs that call tooltipOf() carry them.
#include "hair/HairFields.h"

namespace fur::hair {

const char* tooltipOf(const HairField& field) {
#define FUR_FLOAT(name, label, group, value, low, high, unit, tip, ...) tip,
#define FUR_INT(name, label, group, value, low, high, unit, tip, ...) tip,
#define FUR_BOOL(name, label, group, value, tip, ...) tip,
#define FUR_COLOR(name, label, group, value, tip, ...) tip,
#define FUR_CHOICE(name, label, group, value, options, tip, ...) tip,
  static constexpr const char* kTooltips[] = {
#include "hair/HairFields.inc"
  };
#undef FUR_FLOAT
#undef FUR_INT
#undef FUR_BOOL
#undef FUR_COLOR
#undef FUR_CHOICE
  return kTooltips[&field - hairFields().data()];
}

}  // namespace fur::hair
