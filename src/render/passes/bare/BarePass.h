// Draws parts on which no fur grows, by their own materials. They cost no shells, no fins and no fur in shadow maps.
#pragma once

#include "render/passes/Drawing.h"

namespace fur::render {

// What hides what lies behind it; in place of the skin.
bool drawBare(const Drawing& drawing);
// What one sees through, after all that lies behind it.
bool drawBlended(const Drawing& drawing);

}  // namespace fur::render
