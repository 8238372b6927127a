// A picture that stays is drawn again and again, each time from points of its pixels a little aside and with other noise, and the mean is
// shown: the samples of a picture. What the n-th of them is depends on n alone.
#pragma once

#include "core/Math.h"

namespace fur::render {

// Samples of a picture at most: what is better then nobody sees.
inline constexpr int kMostSamples = 64;

// The first is the picture that is drawn once: without either. Halton (1960), whose points are even for any number of them.
// Where it looks, beside the middle of each pixel: pixels, within a square of one, as the mean over that is as sharp as pixels are.
Vec2 sampleOffset(int sample);
// What is added to each of the four noises of a pixel (common_noise.glsl); 0..1.
Vec4 sampleChance(int sample);

}  // namespace fur::render
