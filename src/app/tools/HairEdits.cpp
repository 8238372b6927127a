#include "app/tools/HairEdits.h"

#include "app/tools/RowNamed.h"

namespace fur::app {

namespace {

struct HairRow {
  const char* name;
};
constexpr HairRow kHairRows[] = {
#define FUR_HAIR_EDIT(id, name, doc) {name},
#include "app/tools/HairEdits.inc"
#undef FUR_HAIR_EDIT
};

}  // namespace

std::string_view nameOf(HairEdit edit) { return kHairRows[static_cast<std::size_t>(edit)].name; }

std::optional<HairEdit> hairEditNamed(std::string_view name) { return rowNamed<HairEdit>(kHairRows, name); }

}  // namespace fur::app
