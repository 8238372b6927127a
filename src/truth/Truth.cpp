#include "truth/Truth.h"

#include <algorithm>

#include "truth/Raster.h"

namespace fur::truth {

Picture render(const Scene& scene, int width, int height, const Options& options) {
  FUR_ASSERT(width > 0 && height > 0 && options.samples > 0, "truth::render()", "a picture of some pixels", width);
  const float distance = std::max(glm::length(Vec3(scene.frame.eye)) - 1.3f, 0.3f);
  const float tolerance = 0.1f * distance / scene.frame.pixelsPerUnit;  // a tenth of a pixel
  Tubes tubes;
  if (scene.coat.furLength > 0)
    tubes = placeStrands(FurMap(scene.surface, scene.bends, scene.coat.furLength, scene.coat.tilesPerUnit, scene.curve), scene.strands,
                         tolerance);
  const DeepShadow shadow(scene.surface, tubes, Vec3(scene.frame.light), options.shadowTexels);
  return drawPicture(scene, tubes, shadeNodes(scene, tubes, shadow, options.light), shadow, width, height, options);
}

}  // namespace fur::truth
