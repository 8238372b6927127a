// Brushes that work on both sides of the model at once, by the setting `mirror` (0: none, else 1 + the axis across).
#pragma once

#include "app/stages/ShapeStage.h"
#include "settings/Settings.h"

namespace fur::app {

// A place or direction, model space, on the other side.
Vec3 mirrored(const settings::Settings& settings, Vec3 way);
// The place on the other side of a point of the surface; none where the settings ask for none, where it is the same place,
// or where the model has no other side there.
std::optional<geometry::SurfacePoint> mirrored(const settings::Settings& settings, const ShapeStage& shape,
                                               const geometry::SurfacePoint& at);

}  // namespace fur::app
