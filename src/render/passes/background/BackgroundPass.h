// Draws the background, a gradient, where nothing else is; of a transparent picture it takes away what was cleared there.
#pragma once

#include "render/passes/Drawing.h"
#include "shared/Blocks.h"

namespace fur::render {

void fillBackground(const Frame& frame, shared::FrameBlock& block);
bool drawBackground(const Drawing& drawing);

}  // namespace fur::render
