// What App::editHair() does to long hair. HairEdits.inc is the only place that lists it, with the meaning of values.
#pragma once

#include <cstddef>
#include <optional>
#include <string_view>

namespace fur::app {

enum class HairEdit {
#define FUR_HAIR_EDIT(id, ...) id,
#include "app/tools/HairEdits.inc"
#undef FUR_HAIR_EDIT
};
inline constexpr std::size_t kHairEditCount = 0
#define FUR_HAIR_EDIT(...) +1
#include "app/tools/HairEdits.inc"
#undef FUR_HAIR_EDIT
    ;

std::string_view nameOf(HairEdit edit);
// "addScalp"; one that is none of them gives none.
std::optional<HairEdit> hairEditNamed(std::string_view name);

}  // namespace fur::app
