// Draws the surface: bare, or what is left to see of it behind fur. Where it is no view, bare parts are drawn as themselves.
#pragma once

#include "render/passes/Drawing.h"

namespace fur::render {

bool drawSkin(const Drawing& drawing, VariantBits variant);

}  // namespace fur::render
