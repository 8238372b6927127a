// The brush that a dab works with, by the settings.
#pragma once

#include "groom/GroomBrush.h"
#include "settings/Settings.h"

namespace fur::app {

inline groom::Brush brushAt(const settings::Settings& settings, const Vec3& centre, const Vec3& normal) {
  return {centre, normal, settings.brushRadius, settings.groomStrength, static_cast<groom::Falloff>(settings.brushFalloff)};
}

}  // namespace fur::app
