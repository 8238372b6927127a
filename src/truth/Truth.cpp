#include "truth/Truth.h"

#include <algorithm>
#include <optional>

#include "truth/Hair.h"
#include "truth/Raster.h"
#include "truth/Wetting.h"

namespace fur::truth {

Picture render(const Scene& scene, int width, int height, const Options& options) {
  FUR_ASSERT(width > 0 && height > 0 && options.samples > 0, "truth::render()", "a picture of some pixels", width);
  const float distance = std::max(glm::length(Vec3(scene.frame.eye)) - 1.3f, 0.3f);
  const float tolerance = 0.1f * distance / scene.frame.pixelsPerUnit;  // a tenth of a pixel
  Tubes tubes;
  if (scene.coat.furLength > 0) {
    const FurMap map(scene.surface, scene.bends, scene.coat.furLength, scene.coat.tilesPerUnit, scene.curve);
    std::optional<Wetting> wetting;
    if (scene.mask) wetting.emplace(map, *scene.mask, scene.coat);
    tubes = placeStrands(map, scene.strands, tolerance, wetting ? &*wetting : nullptr);
  }
  const Vec3 light(scene.frame.light);
  const DeepShadow coatShadow(scene.surface, tubes, light, options.shadowTexels);
  const Tubes hair = placeHair(scene);
  std::optional<DeepShadow> hairShadow;
  if (!hair.tubes.empty()) hairShadow.emplace(scene.surface, hair, light, options.shadowTexels);
  const Shadows shadows{coatShadow, hairShadow ? &*hairShadow : nullptr};
  std::vector<Vec3> lit = shadeNodes(scene, tubes, shadows, options.light);
  const std::vector<Vec3> hairLit = shadeHair(scene, hair, shadows, options.light);
  tubes.append(hair);
  lit.insert(lit.end(), hairLit.begin(), hairLit.end());
  return drawPicture(scene, tubes, lit, shadows, width, height, options);
}

}  // namespace fur::truth
