#include "app/tools/GroomEdits.h"

#include "app/tools/RowNamed.h"

namespace fur::app {

namespace {

enum class Masked { Kept, Changed };

struct Row {
  const char* name;
  Masked masked;
};
constexpr Row kRows[] = {
#define FUR_GROOM_EDIT(id, name, masked, doc) {name, Masked::masked},
#include "app/tools/GroomEdits.inc"
#undef FUR_GROOM_EDIT
};

}  // namespace

bool keepsMasked(GroomEdit edit) { return kRows[static_cast<std::size_t>(edit)].masked == Masked::Kept; }

std::string_view nameOf(GroomEdit edit) { return kRows[static_cast<std::size_t>(edit)].name; }

std::optional<GroomEdit> groomEditNamed(std::string_view name) { return rowNamed<GroomEdit>(kRows, name); }

}  // namespace fur::app
