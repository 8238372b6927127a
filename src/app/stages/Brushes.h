// What a dab works with, by the settings.
#pragma once

#include "app/tools/Tools.h"
#include "groom/GroomBrush.h"
#include "settings/Settings.h"

namespace fur::app {

inline groom::Brush brushAt(const settings::Settings& settings, const Vec3& centre, const Vec3& normal) {
  return {centre, normal, settings.brushRadius, settings.groomStrength, static_cast<groom::Falloff>(settings.brushFalloff)};
}

// A tool of guides works on a node so near to the pointer, model units.
inline float reachOf(Tool tool, const settings::Settings& settings) {
  constexpr float kGrip = 0.5f;
  return settings.brushRadius * (tool == Tool::HairMove ? kGrip : 1);
}

}  // namespace fur::app
