// Apart from the table, so that only programs that call tooltipOf() carry them.
#include "settings/Settings.h"

namespace fur::settings {

const char* tooltipOf(const Field& field) {
  static constexpr const char* kTooltips[] = {
#define FUR_FIELDS "settings/Fields.inc"
#include "settings/fields/Tooltips.inc"
#undef FUR_FIELDS
  };
  return kTooltips[&field - fields().data()];
}

}  // namespace fur::settings
