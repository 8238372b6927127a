// How the fur leans and how the model is moved as a whole: what wind, gravity, the hand, touch and the pose do to it over
// time. Reads shape, groom and water; its bends go to the picture.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "app/stages/GroomStage.h"
#include "app/stages/ModelMotion.h"
#include "app/stages/ShapeStage.h"
#include "app/stages/Touch.h"
#include "app/stages/WaterStage.h"
#include "dynamics/BendField.h"
#include "settings/Settings.h"

namespace fur::app {

class MotionStage {
 public:
  struct Inputs {
    const ShapeStage& shape;
    const GroomStage& groom;
    WaterStage& water;            // for its wetness at the vertices
    std::array<float, settings::kFurTypes> coatWeights{0.5f, 0.5f, 0.5f, 0.5f};  // of the coat that is shown
    const settings::Settings& settings;
    float coatLength = 0.12f;     // of the longest strand, model units
    float seconds = 0;            // that have passed
    float idleTime = 0;           // seconds since somebody was there: idle fur breathes, then sleeps
    bool reducedMotion = false;   // no wind, no breathing
    Vec3 dryer{0};                // wind of a hair dryer, world space
    bool showForces = false;      // forces() are asked for
  };

  void reset();  // of another model
  // Whether anything that can be seen has moved.
  bool update(const Inputs& inputs);
  // Takes the lean that the steady forces give it at once, as after a load.
  void settle(const Inputs& inputs);
  // Whether the next update() changes anything.
  bool active(const Inputs& inputs) const;
  std::uint64_t revision() const { return revision_; }
  // Whether what moves is nothing but fur that settles by less than one sees, as it dries.
  bool swaysUnseen(const Inputs& inputs) const;

  ModelMotion& body() { return body_; }  // the model under the hand
  const ModelMotion& body() const { return body_; }
  Touch& touch() { return touch_; }
  const Touch& touch() const { return touch_; }
  Mat4 worldFromModel() const { return body_.worldFromModel(); }

  // The wind at the last update, world space.
  const dynamics::Wind& windNow() const { return wind_; }
  std::span<const Vec4> bends() const { return bends_.bends(); }
  // What the picture takes: the forces where those are shown, else the bends.
  std::span<const Vec4> shown() const { return bends_.forces().empty() ? bends_.bends() : bends_.forces(); }
  std::uint64_t bendsRevision() const { return bendsRevision_; }

  // Strength of the settings' wind, unless less motion is asked for.
  static float wind(const Inputs& inputs) { return inputs.reducedMotion ? 0 : inputs.settings.wind; }

 private:
  // All that bends are made of, but time.
  struct Felt {
    dynamics::BendForces forces;
    std::uint64_t surface = 0, pose = 0, groom = 0, water = 0;
    bool showForces = false;
    bool operator==(const Felt&) const = default;
  };
  static float breath(const Inputs& inputs);
  static bool gusty(const Inputs& inputs);
  static void addTypes(const Inputs& inputs, dynamics::BendForces& forces);
  dynamics::BendForces forces(const Inputs& inputs) const;
  Felt felt(const Inputs& inputs) const;
  void follow(const Inputs& inputs);

  dynamics::BendField bends_;
  Touch touch_;
  ModelMotion body_;
  double windClock_ = 0;
  dynamics::Wind wind_;
  std::optional<Felt> felt_;  // by the last step
  std::uint64_t surfaceFor_ = 0, poseFor_ = 0, groomFor_ = 0;  // that bends_ follows
  std::uint64_t revision_ = 0, bendsRevision_ = 0;
};

}  // namespace fur::app
