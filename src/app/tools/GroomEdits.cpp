#include "app/tools/GroomEdits.h"

#include "app/tools/RowNamed.h"

namespace fur::app {

namespace {

enum class Masked { Kept, Changed };

struct GroomRow {
  const char* name;
  Masked masked;
};
constexpr GroomRow kGroomRows[] = {
#define FUR_GROOM_EDIT(id, name, masked, doc) {name, Masked::masked},
#include "app/tools/GroomEdits.inc"
#undef FUR_GROOM_EDIT
};

}  // namespace

bool keepsMasked(GroomEdit edit) { return kGroomRows[static_cast<std::size_t>(edit)].masked == Masked::Kept; }

std::string_view nameOf(GroomEdit edit) { return kGroomRows[static_cast<std::size_t>(edit)].name; }

std::optional<GroomEdit> groomEditNamed(std::string_view name) { return rowNamed<GroomEdit>(kGroomRows, name); }

}  // namespace fur::app
