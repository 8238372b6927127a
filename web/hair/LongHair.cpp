// Programs with this file grow long hair: wet-fur-hair and wet-fur-editor.
#include "app/LongHair.h"

namespace {

const bool growsHair = (fur::app::growLongHair(), true);

}  // namespace
