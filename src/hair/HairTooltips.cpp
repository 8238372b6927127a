// Apart from the table, so that only programs that call tooltipOf() carry them.
#include "hair/HairFields.h"

namespace fur::hair {

const char* tooltipOf(const HairField& field) {
  static constexpr const char* kTooltips[] = {
#define FUR_FIELDS "hair/HairFields.inc"
#include "settings/fields/Tooltips.inc"
#undef FUR_FIELDS
  };
  return kTooltips[&field - hairFields().data()];
}

}  // namespace fur::hair
