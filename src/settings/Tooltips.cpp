// Apart from the table, so that only programs that call tooltipOf() carry them.
#include "settings/Settings.h"

namespace fur::settings {

const char* tooltipOf(const Field& field) {
#define FUR_FLOAT(name, label, group, value, low, high, unit, tip, ...) tip,
#define FUR_INT(name, label, group, value, low, high, unit, tip, ...) tip,
#define FUR_BOOL(name, label, group, value, tip, ...) tip,
#define FUR_COLOR(name, label, group, value, tip, ...) tip,
#define FUR_CHOICE(name, label, group, value, options, tip, ...) tip,
  static constexpr const char* kTooltips[] = {
#include "settings/Fields.inc"
  };
#undef FUR_FLOAT
#undef FUR_INT
#undef FUR_BOOL
#undef FUR_COLOR
#undef FUR_CHOICE
  return kTooltips[&field - fields().data()];
}

}  // namespace fur::settings
