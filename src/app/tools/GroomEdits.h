// What App::groomAll() does all over the model. GroomEdits.inc is the only place that lists it, with the meaning of values.
#pragma once

#include <cstddef>
#include <optional>
#include <string_view>

namespace fur::app {

enum class GroomEdit {
#define FUR_GROOM_EDIT(id, ...) id,
#include "app/tools/GroomEdits.inc"
#undef FUR_GROOM_EDIT
};
inline constexpr std::size_t kGroomEditCount = 0
#define FUR_GROOM_EDIT(...) +1
#include "app/tools/GroomEdits.inc"
#undef FUR_GROOM_EDIT
    ;

// Whether it leaves what the mask protects as it is.
bool keepsMasked(GroomEdit edit);
std::string_view nameOf(GroomEdit edit);
// "selectType"; one that is none of them gives none.
std::optional<GroomEdit> groomEditNamed(std::string_view name);

}  // namespace fur::app
