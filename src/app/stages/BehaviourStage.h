// What an animal does by itself: a small state machine. It does one action at a time (Actions.inc), from which the next is faded
// in; gestures are played over that, and it looks at what moves, at who looks at it, or about. All chance comes from one seed, all
// arithmetic is the same on every platform: the same inputs give the same poses.
//
// Reads shape and pointer, and of the water where it has come down; the shape plays its mix(). Models whose file has no such
// animations, and those that are told to do nothing (setting `behaviour`), are left alone until somebody has them act().
#pragma once

#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "app/stages/Gaze.h"
#include "app/stages/Repertoire.h"
#include "app/stages/ShapeStage.h"
#include "core/Random.h"
#include "settings/Settings.h"

namespace fur::app {

class BehaviourStage {
 public:
  struct Inputs {
    const ShapeStage& shape;
    const settings::Settings& settings;
    Vec3 camera{0, 0, 3};           // model space, as all places here
    std::optional<Vec3> pointer{};  // where one points that has moved lately
    std::optional<Vec3> hand{};     // that pets it
    std::span<const std::uint32_t> landed{};  // triangles of the surface on which water has come down since the last update
    float wetness = 0;              // 0..1, of all of it
    float idleTime = 0;             // s since somebody was there
    bool reducedMotion = false;     // it only answers what a person does
    float seconds = 0;              // that have passed
  };

  // Whether the pose has changed.
  bool update(const Inputs& inputs);
  bool active(const Inputs& inputs) const;
  std::uint64_t revision() const { return revision_; }

  // What it plays in place of the setting `animation`; nullptr: nothing.
  const scene::PoseMix* mix() const { return inCharge_ ? &mix_ : nullptr; }
  // The animations of what it does now, first the one in which it stands; empty as above.
  std::span<const int> played() const { return inCharge_ ? std::span<const int>(played_) : std::span<const int>(); }

  // Has it do something, as soon as it can. False: it cannot.
  bool act(std::string_view name);
  bool can(Action action) const { return can_.behaves() && can_.of(action).there(); }
  bool behaves() const { return can_.behaves(); }
  std::string actions() const { return can_.names(); }
  Action action() const { return actions_.empty() ? Action::Stand : actions_.back().action; }
  // How hard it shakes itself, 0..1.
  float shaking() const;
  const Gaze& gaze() const { return gaze_; }

 private:
  // An action that plays; the last of actions_ is done now, the others fade.
  struct PlayedAction {
    Action action = Action::Stand;
    double seconds = 0;  // of its animation
    float level = 0;     // 0..1, whose smoothed value is its weight
    float stays = 0;     // s that are left of it
    float weight() const { return level * level * (3 - 2 * level); }
  };
  // A gesture: played once, or held where it is furthest, by a level as above.
  struct Play {
    float seconds = -1;  // below 0: it does not play
    float level = 0, wanted = 0;
  };
  // Seconds until chance has a say again.
  struct Waits {
    float action = 6, blink = 2, ear = 5, tail = 3, glance = 2, earAgain = 0;
  };

  void follow(const Inputs& inputs);
  bool lively(const Inputs& inputs) const;
  bool dozes(const Inputs& inputs) const;
  bool minds(const Inputs& inputs) const;
  void begin(Action action);
  Action chosen();
  void decide(const Inputs& inputs, float seconds);
  void decideToShake(const Inputs& inputs, float seconds);
  void decideToYawn(const Inputs& inputs);
  void advanceActions(float seconds);
  void feel(const Inputs& inputs, float seconds);
  void gesture(const Inputs& inputs, float seconds);
  void playOnce(Gesture gesture);
  void hold(Gesture gesture, float level, float seconds);
  bool passed(float& wait, float seconds, float least, float most);
  void look(const Inputs& inputs, float seconds);
  std::optional<Vec3> lookedAt(const Inputs& inputs, const Vec3& eyes, float seconds);
  void compose();
  Play& of(Gesture gesture) { return plays_[static_cast<std::size_t>(gesture)]; }
  bool gesturing() const;

  Repertoire can_;
  std::vector<int> played_;
  scene::PoseMix mix_;
  std::vector<PlayedAction> actions_;
  std::array<Play, kGestureCount> plays_{};
  Gaze gaze_;
  Random random_{1};
  Waits waits_;
  std::optional<Action> asked_;
  enum class Glance { Camera, Ahead, About } glance_ = Glance::Camera;
  Vec3 about_{0, 0, 1};      // a direction
  float fade_ = 1;           // s in which the actions before the last go
  float lively_ = 0;         // 0..1: how much it does by itself now
  float asleep_ = 0;
  float squints_ = 0;        // s for which it still does
  float soaked_ = 0;         // s for which it has been wet enough to shake itself
  float shakenAt_ = 0;       // how wet the last shake has left it
  int shakesLeft_ = 0;
  bool yawned_ = false;  // since somebody was there
  bool inCharge_ = false, quiet_ = true;
  std::uint64_t shapeFor_ = 0, revision_ = 0;
};

}  // namespace fur::app
