// Draws what the tool Ball presses into the fur (Frame::ball), made of vertex numbers alone.
#pragma once

#include "render/passes/Drawing.h"
#include "shared/Blocks.h"

namespace fur::render {

void fillBall(const Frame& frame, shared::FrameBlock& block);
// Where there is one.
bool drawBall(const Drawing& drawing);
// Its triangles with the program and state that are set: it is in both shadow maps, too.
void drawBallTriangles();

}  // namespace fur::render
