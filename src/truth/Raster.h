// Rasterises tubes and skin: a z-buffer with many samples a pixel, one small square of the picture at a time.
#pragma once

#include <vector>

#include "truth/Shading.h"

namespace fur::truth {

// `light`: of each node, linear light, interpolated along the axis. What is nearer to the eye than 0.02 model units is left out.
Picture drawPicture(const Scene& scene, const Tubes& tubes, const std::vector<Vec3>& light, const Shadows& shadows,
                    int width, int height, const Options& options);

}  // namespace fur::truth
