#include "app/stages/Mirror.h"

namespace fur::app {

namespace {

// So far apart the two sides of a model may be that one mirrors, model units.
constexpr float kUneven = 0.1f;

}  // namespace

Vec3 mirrored(const settings::Settings& settings, Vec3 way) {
  if (settings.mirror > 0) way[settings.mirror - 1] *= -1;
  return way;
}

std::optional<geometry::SurfacePoint> mirrored(const settings::Settings& settings, const ShapeStage& shape,
                                               const geometry::SurfacePoint& at) {
  if (settings.mirror == 0) return std::nullopt;
  const Vec3 place = positionAt(shape.surface(), at), there = mirrored(settings, place);
  // In the middle it is the same place.
  if (glm::distance(place, there) < 0.2f * settings.brushRadius) return std::nullopt;
  return nearestPoint(shape.surface(), shape.query(), there, settings.brushRadius + kUneven,
                      mirrored(settings, normalAt(shape.surface(), at)));
}

}  // namespace fur::app
