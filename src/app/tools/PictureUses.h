// What a picture can mean for the fur. PictureUses.inc is the only place that lists it.
#pragma once

#include <cstddef>
#include <optional>
#include <string_view>

namespace fur::app {

enum class PictureUse {
#define FUR_PICTURE_USE(id, ...) id,
#include "app/tools/PictureUses.inc"
#undef FUR_PICTURE_USE
};
inline constexpr std::size_t kPictureUseCount = 0
#define FUR_PICTURE_USE(...) +1
#include "app/tools/PictureUses.inc"
#undef FUR_PICTURE_USE
    ;

struct PictureUseRow {
  const char *name, *label, *tooltip;
};
const PictureUseRow& rowOf(PictureUse use);
// "length"; one that is none of them gives none.
std::optional<PictureUse> pictureUseNamed(std::string_view name);

}  // namespace fur::app
