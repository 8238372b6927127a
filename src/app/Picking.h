// What is under a pixel: the fur as it is drawn, or the skin.
#pragma once

#include <optional>

#include "app/stages/CoatStage.h"
#include "app/stages/GroomStage.h"
#include "app/stages/MotionStage.h"
#include "app/stages/ShapeStage.h"
#include "app/stages/WaterStage.h"
#include "app/view/View.h"
#include "settings/Settings.h"

namespace fur::app {

struct Picking {
  const ShapeStage& shape;
  const GroomStage& groom;
  const DrawnCoat& coat;
  const wet::WetnessMask& mask;
  std::span<const Vec4> bends;
  const settings::Settings& settings;
  float coatLength;  // of the longest strand, model units

  // The root of the fur that a ray (model space) meets, or bare skin.
  std::optional<geometry::SurfacePoint> at(const Ray& ray) const;
  // Where the fur is seen that is rooted there; model space.
  Vec3 seenAt(const geometry::SurfacePoint& root) const;

 private:
  float coatHeight() const;
};

}  // namespace fur::app
