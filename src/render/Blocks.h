// The numbers that the shaders are given, worked out of a frame: the one place for whoever draws the same picture.
#pragma once

#include "render/Frame.h"
#include "shared/Blocks.h"

namespace fur::render {

shared::FrameBlock frameBlock(const Frame& frame);
// A tile of that many texels along a side and that many layers; `density` is the share of its densest layer that
// strands cover.
shared::FurBlock furBlock(const Frame& frame, int tileSize, int storedLayers, float density, int maskSize);

}  // namespace fur::render
