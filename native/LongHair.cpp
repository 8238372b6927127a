// Native programs grow long hair.
#include "app/LongHair.h"

namespace {

const bool growsHair = (fur::app::growLongHair(), true);

}  // namespace
