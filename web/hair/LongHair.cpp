// Programs with this file grow long hair and read all formats: wet-fur-hair and wet-fur-editor.
#include "app/LongHair.h"
#include "scene/Model.h"

namespace {

const bool growsHair = (fur::app::growLongHair(), fur::scene::readAllFormats(), true);

}  // namespace
