// Writes the extension WETFUR_fur.
#pragma once

#include <string>

#include "scene/FurData.h"
#include "scene/export/GlbWriter.h"

namespace fur::scene {

// Where the maps lie: the members that groom, wetness and hair have beside their own, such as ,"texCoord":1, and those of the root.
struct FurPlace {
  bool hasAtlas = false;
  std::string ofMaps, ofRoot;
  int version = 1;
};

// Whether any fur type has files.
bool hasCoats(const FurData& fur);

// The extension's value; its views are added.
std::string furExtension(GlbWriter& writer, const FurData& fur, const FurPlace& place);

}  // namespace fur::scene
