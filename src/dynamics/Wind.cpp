#include "dynamics/Wind.h"

#include <cmath>

#include "dynamics/RigidMotion.h"

namespace fur::dynamics {

namespace {

constexpr float kShelter = 0.4f;  // share of the wind on the lee side

// By the wind's own axes: along it, to its side, up. Cycles a model unit, cycles a second, share of the wind's force at
// the crest. Every wave runs along with the wind; the push of an eddy is across its wave, as in air that is not
// squeezed. Frequencies are such that the sum stays far from what it was for 20 s.
struct WaveShape {
  Vec3 cycles;
  double frequency;
  Vec3 force;
};
// Slow ones, and so long that one end of the body leans while the other has not been reached.
constexpr WaveShape kGustShapes[] = {
    {Vec3(0.31f, 0.05f, 0), 0.27, Vec3(0.3f, 0, 0)},
    {Vec3(0.75f, -0.2f, 0.1f), 0.68, Vec3(0.2f, 0, 0)},
};
constexpr WaveShape kEddyShapes[] = {
    {Vec3(0.5f, 0.6f, 0.2f), 0.498, Vec3(0.36f, -0.3f, 0)},  {Vec3(0.8f, -0.5f, 0.4f), 0.792, Vec3(0.25f, 0.4f, 0)},
    {Vec3(0.9f, 0.3f, -0.9f), 1.07, Vec3(0, 0.36f, 0.12f)},  {Vec3(1.3f, -0.9f, -0.3f), 1.364, Vec3(0.18f, 0.26f, 0)},
    {Vec3(1.5f, 1.1f, 0.8f), 1.87, Vec3(0, 0.16f, -0.22f)},
};

}  // namespace

WindField::WindField(const Wind& wind, const Mat4& modelToWorld) {
  const Vec3 force = finiteOr0(wind.force);
  const float strength = glm::length(force), gust = unitOr0(wind.gust), turbulence = unitOr0(wind.turbulence);
  const Mat3 toModel = glm::transpose(rotationOf(modelToWorld));
  const Vec3 along = normalizeOr(force, Vec3(0)), side = normalizeOr(glm::cross(along, Vec3(0, 1, 0)), Vec3(1, 0, 0));
  const Mat3 axes(along, side, glm::cross(side, along)), axesInModel = toModel * axes;
  direction_ = axesInModel[0];
  steady_ = toModel * force * (1.0f - 0.5f * gust);
  if (!wind.varies()) return;
  const auto add = [&](const WaveShape& shape, float share) {
    const Vec3 cycles = axes * shape.cycles;
    const double turns = static_cast<double>(glm::dot(cycles, Vec3(modelToWorld[3]))) - shape.frequency * wind.time;
    waves_[waveCount_++] = {axesInModel * shape.cycles, static_cast<float>(turns - std::floor(turns)),
                            axesInModel * shape.force * (strength * share)};
  };
  if (gust > 0)
    for (const WaveShape& shape : kGustShapes) add(shape, gust);
  if (turbulence > 0)
    for (const WaveShape& shape : kEddyShapes) add(shape, turbulence);
}

Lanes WindField::exposure(const Lanes3& outward) const {
  const Lanes facing = min(max(0.5f - 0.5f * dot(outward, splat(direction_)), splat(0.0f)), splat(1.0f));
  return kShelter + (1.0f - kShelter) * facing;
}

Lanes3 WindField::at(const Lanes3& point) const {
  Lanes3 sum = splat(steady_);
  for (int i = 0; i < waveCount_; ++i)
    sum = sum + splat(waves_[i].force) * waveAt(dot(point, splat(waves_[i].cycles)) + waves_[i].phase);
  return sum;
}

}  // namespace fur::dynamics
