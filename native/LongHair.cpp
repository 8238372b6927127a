// Native programs grow long hair and read all formats.
#include "app/LongHair.h"
#include "scene/Model.h"

namespace {

const bool growsHair = (fur::app::growLongHair(), fur::scene::readAllFormats(), true);

}  // namespace
