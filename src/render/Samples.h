// A picture that stays is drawn again and again, each time from points of its pixels a little aside and with other noise, and the mean is
// shown: the samples of a picture. What the n-th of them is depends on n alone.
#pragma once

#include "core/Math.h"

namespace fur::render {

// Samples of a picture at most: what is better then nobody sees.
inline constexpr int kMostSamples = 64;

// Of a picture in which water moves, the mean follows it by so many: a seventh of a second, in which grain becomes less by three quarters.
inline constexpr int kFlowingSamples = 8;

// Samples after the first need not hide the grain and the blur of a single picture: they read the coat from a finer mip level, go through
// it in shorter steps (kSampleStep in shell_dry.glsl and shell_wet.glsl), half a step earlier, as a strand that is found between two is
// half a step back, give strands edges a quarter as wide, and count the strands that shade what they see. On dry fur each takes 1.4 to 1.5 times as long as the first. On wet
// fur locks run on across the borders of charts (shell_border.glsl). Sixteen are nearer to
// the reference (npm run compare) by a tenth near and a seventh at the middle. Two levels, as many as sixteen points along a pixel's
// sides would have, are nearer still to the reference far off, but darker than the moving picture, which would be seen each time.
inline constexpr float kSampleLevels = 1.5f;

// The first is the picture that is drawn once: without either. Halton (1960), whose points are even for any number of them.
// Where it looks, beside the middle of each pixel: pixels, within a square of one, as the mean over that is as sharp as pixels are.
Vec2 sampleOffset(int sample);
// What is added to each of the four noises of a pixel (common_noise.glsl); 0..1.
Vec4 sampleChance(int sample);

}  // namespace fur::render
