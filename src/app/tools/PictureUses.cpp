#include "app/tools/PictureUses.h"

#include "app/tools/RowNamed.h"

namespace fur::app {

namespace {

constexpr PictureUseRow kPictureRows[] = {
#define FUR_PICTURE_USE(id, name, label, doc) {name, label, doc},
#include "app/tools/PictureUses.inc"
#undef FUR_PICTURE_USE
};

}  // namespace

const PictureUseRow& rowOf(PictureUse use) { return kPictureRows[static_cast<std::size_t>(use)]; }

std::optional<PictureUse> pictureUseNamed(std::string_view name) { return rowNamed<PictureUse>(kPictureRows, name); }

}  // namespace fur::app
