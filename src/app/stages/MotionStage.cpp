#include "app/stages/MotionStage.h"

#include <algorithm>

#include "core/NoteChange.h"
#include "core/PortableMath.h"
#include "settings/FurTypes.h"

namespace fur::app {

namespace {

// Idle fur breathes for so long after somebody was there, then calms down and sleeps.
constexpr float kBreathTime = 7, kCalming = 3;  // s
constexpr float kBreathWind = 0.1f;  // strength of the wind at a setting of 1
constexpr float kSeenSway = 0.02f;  // rad

}  // namespace

float MotionStage::breath(const Inputs& inputs) {
  if (inputs.reducedMotion || inputs.settings.wind > 0) return 0;
  return kBreathWind * inputs.settings.breath * saturate((kBreathTime - inputs.idleTime) / kCalming);
}

bool MotionStage::gusty(const Inputs& inputs) {
  return (wind(inputs) > 0 && (inputs.settings.gust > 0 || inputs.settings.turbulence > 0)) || breath(inputs) > 0;
}

// Each type is as heavy and as stiff as its own coat.
void MotionStage::addTypes(const Inputs& inputs, dynamics::BendForces& f) {
  // It has the direction of the others' as well.
  f.gravity.y = std::min(f.gravity.y, -1e-3f);
  for (std::size_t i = 0; i < f.others.size(); ++i) {
    const int type = static_cast<int>(i) + 1;
    const settings::Settings coat = settings::drawnCoat(inputs.settings, type);
    f.others[i] = {coat.gravity, coat.stiffness, inputs.coatWeights[settings::isOwn(inputs.settings, type) ? i + 1 : 0]};
  }
}

dynamics::BendForces MotionStage::forces(const Inputs& inputs) const {
  const settings::Settings& settings = inputs.settings;
  dynamics::BendForces f;
  f.gravity = Vec3(0, -settings.gravity, 0);
  const float idle = breath(inputs);
  f.wind.force = (wind(inputs) + idle) * Vec3(portableSin(settings.windYaw), 0.08f, portableCos(settings.windYaw)) + inputs.dryer;
  f.wind.gust = idle > 0 ? 1 : settings.gust;
  f.wind.turbulence = idle > 0 ? 1 : settings.turbulence;
  f.wind.time = windClock_;
  f.stiffness = settings.stiffness;
  f.inertia = settings.inertia;
  f.weight = inputs.coatWeights[0];
  if (inputs.groom.types() > 1) addTypes(inputs, f);
  f.furLength = inputs.coatLength;
  return f;
}

MotionStage::Felt MotionStage::felt(const Inputs& inputs) const {
  Felt felt{forces(inputs), inputs.shape.surfaceRevision(), inputs.shape.poseRevision(), inputs.groom.verticesRevision(),
            inputs.water.vertexRevision(inputs.shape), inputs.showForces};
  felt.forces.wind.time = 0;
  return felt;
}

void MotionStage::reset() {
  body_.reset();
  touch_ = {};
}

// The bends take over what shape and groom have changed.
void MotionStage::follow(const Inputs& inputs) {
  const ShapeStage& shape = inputs.shape;
  const bool otherSurface = noteChange(surfaceFor_, shape.surfaceRevision());
  if (otherSurface) {
    std::vector<Vec3> positions, normals;
    for (const geometry::SurfaceVertex& v : shape.surface().vertices) {
      positions.push_back(v.position);
      normals.push_back(v.normal);
    }
    bends_.reset(positions, normals, {shape.firstTangents().begin(), shape.firstTangents().end()});
  }
  if (noteChange(groomFor_, inputs.groom.verticesRevision()) || otherSurface) {
    bends_.setRest(inputs.groom.rests(), inputs.groom.vertexLengths());
    bends_.setTypes(inputs.groom.vertexTypes());
  }
  if (noteChange(poseFor_, shape.poseRevision()) && shape.skin())
    bends_.setPose(shape.skin()->positions, shape.skin()->normals, shape.skin()->tangents);
  bends_.showForces(inputs.showForces);
}

bool MotionStage::active(const Inputs& inputs) const {
  return body_.moving() || !bends_.atRest() || touch_.moving() || gusty(inputs) || !felt_ || felt(inputs) != *felt_;
}

bool MotionStage::swaysUnseen(const Inputs& inputs) const {
  return !body_.moving() && !touch_.moving() && !gusty(inputs) && bends_.left() < kSeenSway;
}

bool MotionStage::update(const Inputs& inputs) {
  const bool moved = body_.update(inputs.seconds);
  revision_ += moved;
  if (wind(inputs) > 0 || breath(inputs) > 0) windClock_ += inputs.seconds;
  wind_ = forces(inputs).wind;
  if (!(inputs.seconds > 0) || !(moved || active(inputs))) return moved;
  follow(inputs);
  touch_.update(inputs.seconds);
  const dynamics::BendForces forces = this->forces(inputs);
  bends_.step(inputs.seconds, worldFromModel(), forces, inputs.water.vertexWetness(inputs.shape), touch_.contacts());
  felt_ = felt(inputs);
  ++revision_;
  ++bendsRevision_;
  return true;
}

void MotionStage::settle(const Inputs& inputs) {
  follow(inputs);
  wind_ = forces(inputs).wind;
  bends_.settle(worldFromModel(), forces(inputs), inputs.water.vertexWetness(inputs.shape));
  felt_ = felt(inputs);
  ++revision_;
  ++bendsRevision_;
}

}  // namespace fur::app
