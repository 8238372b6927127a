#include "app/stages/BehaviourStage.h"

#include <algorithm>
#include <cmath>

#include "core/NoteChange.h"
#include "core/PortableMath.h"

namespace fur::app {

namespace {

constexpr std::size_t kMostActions = 4;
constexpr float kCalms = 0.8f;             // s until it does nothing by itself any more, or does again
constexpr float kYawnsAfter = 54, kDozesAfter = 60, kFallsAsleep = 3;  // s without anybody there
constexpr float kNothing = 3;              // chance of no other action, as in Actions.inc
constexpr float kMinded = 2;               // s without another action after somebody minded it
// Of the mean wetness: from here on it shakes itself, and again when it is so much wetter than a shake has left it; s that it bears it,
// also after a shake.
constexpr float kShakesFrom = 0.16f, kWetterBy = 0.06f, kBears = 2.2f, kBearsAfter = 5;
constexpr int kShakesInARow = 2;
constexpr float kSquints = 0.7f, kSquintIn = 0.1f, kSquintOut = 0.35f, kLeans = 0.45f, kSways = 1.2f;  // s

float approached(float from, float to, float most) { return from + std::clamp(to - from, -most, most); }
float smoothed(float level) { return level * level * (3 - 2 * level); }

}  // namespace

// --- another model, or another setting ---

void BehaviourStage::follow(const Inputs& inputs) {
  if (!noteChange(shapeFor_, inputs.shape.surfaceRevision())) return;
  can_ = repertoireOf(inputs.shape.rig());
  played_.clear();
  actions_.clear();
  actions_.reserve(kMostActions + 1);
  plays_ = {};
  gaze_.reset();
  waits_ = {};
  asked_.reset();
  random_ = Random(static_cast<std::uint64_t>(inputs.settings.seed), 17);
  asleep_ = squints_ = soaked_ = shakenAt_ = 0;
  shakesLeft_ = 0;
  yawned_ = false;
  lively_ = lively(inputs) ? 1.0f : 0.0f;
  if (!can_.behaves()) return;
  actions_.push_back({Action::Stand, 0, 1, 0});
  of(Gesture::Breathe).seconds = of(Gesture::TailSway).seconds = 0;
}

bool BehaviourStage::dozes(const Inputs& inputs) const { return inputs.idleTime > kDozesAfter && action() == Action::Stand && !asked_; }
bool BehaviourStage::lively(const Inputs& inputs) const { return inputs.settings.behaviour == 0 && !inputs.reducedMotion && !dozes(inputs); }

// What a person points at who has just done something, where it does nothing by itself.
bool BehaviourStage::minds(const Inputs& inputs) const {
  return inputs.settings.behaviour == 0 && inputs.pointer && asleep_ == 0 && inputs.idleTime < kMinded;
}

bool BehaviourStage::act(std::string_view name) {
  const auto action = actionNamed(name);
  if (!action || !can(*action)) return false;
  asked_ = action;
  return true;
}

float BehaviourStage::shaking() const {
  float most = 0;
  for (const PlayedAction& one : actions_)
    if (one.action == Action::Shake) most = std::max(most, one.weight());
  return most;
}

// --- actions ---

void BehaviourStage::begin(Action action) {
  const ActionTraits& traits = traitsOf(action);
  const float stays = traits.manner == Manner::Once ? 0 : random_.uniform(traits.least, traits.most);
  if (actions_.back().action == action && traits.manner != Manner::Once) {
    actions_.back().stays = stays;
    return;
  }
  // What is done once ends nearly as it stands.
  const ActionTraits& before = traitsOf(actions_.back().action);
  fade_ = traits.manner == Manner::Rests && before.manner == Manner::Once ? before.fade : traits.fade;
  actions_.push_back({action, 0, 0, stays});
}

Action BehaviourStage::chosen() {
  float sum = kNothing;
  const auto chanceOf = [&](std::size_t i) { return can_.actions[i].there() ? traitsOf(static_cast<Action>(i)).chance : 0; };
  for (std::size_t i = 0; i < kActionCount; ++i) sum += chanceOf(i);
  float at = random_.uniform(0, sum);
  for (std::size_t i = 0; i < kActionCount; ++i)
    if ((at -= chanceOf(i)) < 0) return static_cast<Action>(i);
  return Action::Stand;
}

// Wet fur is shaken out, and once more, until water comes anew.
void BehaviourStage::decideToShake(const Inputs& inputs, float seconds) {
  if (shaking() > 0) {
    shakenAt_ = inputs.wetness;
    soaked_ = 0;
    return;
  }
  shakenAt_ = std::min(shakenAt_, inputs.wetness);
  if (inputs.wetness > shakenAt_ + kWetterBy) shakesLeft_ = kShakesInARow;
  const bool wet = inputs.wetness > kShakesFrom && shakesLeft_ > 0;
  soaked_ = wet ? soaked_ + seconds : 0;
  if (!wet || soaked_ < (shakesLeft_ == kShakesInARow ? kBears : kBearsAfter) || asked_ || !can(Action::Shake)) return;
  --shakesLeft_;
  asked_ = Action::Shake;
}

// Once, as it becomes sleepy.
void BehaviourStage::decideToYawn(const Inputs& inputs) {
  if (inputs.idleTime < kYawnsAfter) yawned_ = false;
  else if (!yawned_ && action() == Action::Stand && !asked_ && can(Action::Yawn)) {
    yawned_ = true;
    asked_ = Action::Yawn;
  }
}

void BehaviourStage::decide(const Inputs& inputs, float seconds) {
  PlayedAction& now = actions_.back();
  const ActionTraits& traits = traitsOf(now.action);
  if (lively(inputs)) {
    decideToShake(inputs, seconds);
    decideToYawn(inputs);
  }
  now.stays -= seconds;
  if (asked_ && actions_.size() < kMostActions) {
    const Action action = *asked_;
    asked_.reset();
    return begin(action);
  }
  const float end = can_.of(now.action).duration - traits.fade;
  const bool over = traits.manner == Manner::Once ? now.seconds >= static_cast<double>(end) : now.stays <= 0;
  if (traits.manner != Manner::Rests && over && actions_.size() < kMostActions) return begin(Action::Stand);
  if (now.action != Action::Stand || !lively(inputs)) return;
  if (inputs.hand || inputs.pointer || squints_ > 0) waits_.action = std::max(waits_.action, kMinded);
  if (passed(waits_.action, seconds, traits.least, traits.most))
    if (const Action next = chosen(); next != Action::Stand) begin(next);
}

void BehaviourStage::advanceActions(float seconds) {
  for (PlayedAction& one : actions_) {
    const double duration = can_.of(one.action).duration;
    const bool rests = traitsOf(one.action).manner == Manner::Rests;
    one.seconds += static_cast<double>(rests ? seconds * lively_ : seconds);
    if (traitsOf(one.action).manner == Manner::Once) one.seconds = std::min(one.seconds, duration);
    else one.seconds -= duration * std::floor(one.seconds / duration);
  }
  const float step = seconds / fade_;
  for (PlayedAction& one : actions_) one.level = approached(one.level, &one == &actions_.back() ? 1.0f : 0.0f, step);
  actions_.erase(std::remove_if(actions_.begin(), actions_.end() - 1, [](const PlayedAction& one) { return one.level <= 0; }), actions_.end() - 1);
}

// --- gestures ---

bool BehaviourStage::passed(float& wait, float seconds, float least, float most) {
  if ((wait -= seconds) > 0) return false;
  wait = random_.uniform(least, most);
  return true;
}

void BehaviourStage::playOnce(Gesture gesture) {
  if (of(gesture).seconds < 0) of(gesture).seconds = 0;
}

void BehaviourStage::hold(Gesture gesture, float level, float seconds) {
  of(gesture).wanted = level;
  of(gesture).level = approached(of(gesture).level, level, seconds);
}

// Water on its head.
void BehaviourStage::feel(const Inputs& inputs, float seconds) {
  squints_ = std::max(squints_ - seconds, 0.0f);
  waits_.earAgain -= seconds;
  const geometry::Surface& surface = inputs.shape.surface();
  for (const std::uint32_t triangle : inputs.landed) {
    const std::size_t source = surface.vertices[surface.indices[3 * std::size_t{triangle}]].source;
    const Repertoire::Part part = source < can_.parts.size() ? can_.parts[source] : Repertoire::Part::Body;
    if (part == Repertoire::Part::Body) continue;
    squints_ = kSquints;
    if (waits_.earAgain > 0) continue;
    playOnce(part == Repertoire::Part::HeadLeft ? Gesture::EarFlickL : Gesture::EarFlickR);
    waits_.earAgain = random_.uniform(0.5f, 1.4f);
  }
}

void BehaviourStage::gesture(const Inputs& inputs, float seconds) {
  if (lively(inputs)) {
    if (passed(waits_.blink, seconds, 1.6f, 5.5f)) playOnce(Gesture::Blink);
    if (passed(waits_.ear, seconds, 3.5f, 10)) playOnce(random_.uniform() < 0.5f ? Gesture::EarFlickL : Gesture::EarFlickR);
    if (passed(waits_.tail, seconds, 2.5f, 6)) of(Gesture::TailSway).wanted = random_.uniform() < 0.55f ? 1.0f : 0.0f;
  } else {
    of(Gesture::TailSway).wanted = 0;
  }
  hold(Gesture::TailSway, of(Gesture::TailSway).wanted, seconds / kSways);
  of(Gesture::Breathe).level = lively_;
  const float squint = squints_ > 0 ? 1.0f : inputs.hand ? 0.5f : 0.0f;
  hold(Gesture::Squint, squint, seconds / (squint > of(Gesture::Squint).level ? kSquintIn : kSquintOut));
  const float side = inputs.hand ? inputs.hand->x : 0;
  hold(Gesture::LeanL, side > 0 ? 1.0f : 0.0f, seconds / kLeans);
  hold(Gesture::LeanR, side < 0 ? 1.0f : 0.0f, seconds / kLeans);
  for (std::size_t i = 0; i < kGestureCount; ++i) {
    if (plays_[i].seconds < 0) continue;
    const float duration = can_.gestures[i].duration;
    const bool loops = i == static_cast<std::size_t>(Gesture::Breathe) || i == static_cast<std::size_t>(Gesture::TailSway);
    plays_[i].seconds += seconds;
    if (plays_[i].seconds >= duration) plays_[i].seconds = loops && duration > 0 ? plays_[i].seconds - duration * std::floor(plays_[i].seconds / duration) : -1;
  }
}

bool BehaviourStage::gesturing() const {
  for (std::size_t i = 0; i < kGestureCount; ++i) {
    const auto gesture = static_cast<Gesture>(i);
    const bool loops = gesture == Gesture::Breathe || gesture == Gesture::TailSway;
    if ((!loops && plays_[i].seconds >= 0) || plays_[i].level != plays_[i].wanted * (gesture == Gesture::Breathe ? 0 : 1)) return true;
  }
  return false;
}

// --- looking ---

std::optional<Vec3> BehaviourStage::lookedAt(const Inputs& inputs, const Vec3& eyes, float seconds) {
  if (inputs.hand) return inputs.hand;
  if (quiet_ ? minds(inputs) : inputs.pointer.has_value()) return inputs.pointer;
  if (quiet_) return std::nullopt;
  if (passed(waits_.glance, seconds, 1.8f, 5)) {
    const float chance = random_.uniform(), yaw = random_.uniform(-0.9f, 0.9f), up = random_.uniform(-0.2f, 0.25f);
    glance_ = chance < 0.5f ? Glance::Camera : chance < 0.65f ? Glance::Ahead : Glance::About;
    about_ = Vec3(portableSin(yaw), portableSin(up), portableCos(yaw));
  }
  if (glance_ == Glance::Camera) return inputs.camera;
  return glance_ == Glance::About ? std::optional(eyes + 3.0f * about_) : std::nullopt;
}

void BehaviourStage::look(const Inputs& inputs, float seconds) {
  const scene::Pose& pose = *inputs.shape.pose();
  const auto rotation = [&](int node) {
    Mat3 m(pose.transform(static_cast<std::size_t>(node)));
    for (int c = 0; c < 3; ++c) m[c] = normalizeOr(m[c], Vec3(c == 0, c == 1, c == 2));
    return m;
  };
  const auto place = [&](int node) { return Vec3(pose.transform(static_cast<std::size_t>(node))[3]); };
  Gaze::Frame frame;
  frame.head = rotation(can_.head);
  frame.hasNeck = can_.neck >= 0;
  if (frame.hasNeck) frame.neck = rotation(can_.neck);
  const bool eyed = can_.eyes[0] >= 0 && can_.eyes[1] >= 0;
  frame.eyes = eyed ? 0.5f * (place(can_.eyes[0]) + place(can_.eyes[1])) : place(can_.head);
  float sum = 0, looks = 0;
  for (const PlayedAction& one : actions_) {
    sum += one.weight();
    looks += one.weight() * traitsOf(one.action).looks;
  }
  gaze_.update(seconds, lookedAt(inputs, frame.eyes, seconds), sum > 0 ? looks / sum : 0, frame);
}

// --- all of it ---

void BehaviourStage::compose() {
  mix_.clear();
  played_.assign(1, can_.of(Action::Stand).animation);
  for (const PlayedAction& one : actions_)
    if (const int animation = can_.of(one.action).animation; std::find(played_.begin(), played_.end(), animation) == played_.end()) played_.push_back(animation);
  for (const PlayedAction& one : actions_) mix_.bodies.push_back({can_.of(one.action).animation, static_cast<float>(one.seconds), one.weight()});
  for (std::size_t i = 0; i < kGestureCount; ++i) {
    const Repertoire::Clip& clip = can_.gestures[i];
    if (!clip.there()) continue;
    const auto gesture = static_cast<Gesture>(i);
    const Play& play = plays_[i];
    const bool loops = gesture == Gesture::Breathe || gesture == Gesture::TailSway;
    if (loops) mix_.layers.push_back({clip.animation, play.seconds, smoothed(play.level)});
    else if (play.seconds >= 0) mix_.layers.push_back({clip.animation, play.seconds, gesture == Gesture::Blink ? 1 - smoothed(asleep_) : 1});
    else if (play.level > 0) mix_.layers.push_back({clip.animation, clip.peak, smoothed(play.level)});
    if (gesture == Gesture::Blink && asleep_ > 0) mix_.layers.push_back({clip.animation, clip.peak, smoothed(asleep_)});
  }
  const auto turn = [&](int node, const Quat& by) {
    if (node >= 0) mix_.turns.push_back({static_cast<std::uint32_t>(node), by});
  };
  turn(can_.neck, gaze_.neckTurn());
  turn(can_.head, gaze_.headTurn());
  for (const int eye : can_.eyes) turn(eye, gaze_.eyeTurn());
}

bool BehaviourStage::active(const Inputs& inputs) const {
  if (shapeFor_ != inputs.shape.surfaceRevision()) return true;
  if (!can_.behaves() || inputs.settings.animationSpeed == 0) return false;
  const float sleeps = inputs.settings.behaviour == 0 && dozes(inputs) ? 1 : 0;
  return lively(inputs) || lively_ > 0 || asleep_ != sleeps || actions_.size() > 1 || action() != Action::Stand || asked_ || gesturing() || gaze_.moving() ||
         minds(inputs) || inputs.hand || !inputs.landed.empty() || squints_ > 0;
}

bool BehaviourStage::update(const Inputs& inputs) {
  follow(inputs);
  const bool stands = inputs.shape.animationOf(inputs.settings.animation) == can_.of(Action::Stand).animation;
  const bool before = inCharge_, acts = !actions_.empty() && (action() != Action::Stand || actions_.size() > 1 || asked_);
  inCharge_ = can_.behaves() && (inputs.settings.behaviour == 0 || stands || acts);
  if (!inCharge_) {
    revision_ += before;
    return before;
  }
  const float seconds = inputs.seconds * inputs.settings.animationSpeed;
  const bool first = !before || mix_.bodies.empty();
  if (!first && (!(seconds > 0) || !active(inputs))) return false;
  quiet_ = !lively(inputs);
  lively_ = approached(lively_, quiet_ ? 0.0f : 1.0f, seconds / kCalms);
  asleep_ = approached(asleep_, inputs.settings.behaviour == 0 && dozes(inputs) ? 1.0f : 0.0f, seconds / kFallsAsleep);
  if (seconds > 0) {
    feel(inputs, seconds);
    decide(inputs, seconds);
    advanceActions(seconds);
    gesture(inputs, seconds);
    look(inputs, seconds);
  }
  compose();
  ++revision_;
  return true;
}

}  // namespace fur::app
