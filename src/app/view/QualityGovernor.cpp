#include "app/view/QualityGovernor.h"

#include <algorithm>
#include <utility>

namespace fur::app {

namespace {

// A frame of more than this is a pause, ms.
constexpr float kPause = 1000;
// The first frames at a level pay for its memory, and times of the drawing arrive late.
constexpr int kSettlingFrames = 4;
// What is judged: the newest frames of this time, ms, and at least so many; after a move sooner.
constexpr float kWindow = 500, kShortWindow = 250;
constexpr int kFewestFrames = 5;
// Of the budget: above, frames are too slow (refreshes jitter); what is expected of a level to be moved to.
constexpr float kTooSlow = 1.1f, kFits = 0.85f;
// Of a time that cheaper levels did not shorten.
constexpr float kNoLonger = 1.15f;
// A fall to less than kMuchLess of the cost that leaves more than kNothing of the time brought nothing. Half: a
// screen that waits for its next refresh cannot hide it.
constexpr float kMuchLess = 0.5f, kNothing = 0.9f;
// That is believed for so long, twice as long whenever it proves true again, and at most; ms.
constexpr float kFirstBelief = 60000, kLongestBelief = 960000;
// The drawing may be blamed for this much more than its own timer says (other passes of the browser).
constexpr float kBlame = 1.5f;
// Of the load under which a level was tried in vain: less, and it is worth another try at once.
constexpr float kGone = 0.8f;
// Each frame the quickest is forgotten by this much: 40 seconds for a screen of half the refreshes.
constexpr float kForgetting = 1.0003f;
// Share of the newest frame in the running average.
constexpr float kEvening = 0.1f;
// Of what is too slow: no frame counts for more, in that average and in the time of what is judged.
constexpr float kHiccup = 3;
// Between moves upwards; wait after the first try that failed and the longest; trusted again after; ms.
constexpr float kClimbWait = 1500, kFirstWait = 4000, kLongestWait = 120000, kTrusted = 30000;
// For a picture that stays, ms: as long as a person takes to notice that something answers late.
constexpr float kStillTime = 250;
// Of its bands, ms; each draws all vertices, so that more of them would take longer for no part to be shorter.
constexpr float kBandTime = 100, kMostBands = 64;

float median(std::array<float, kQualityWindow> values, int count) {
  for (int i = 1; i < count; ++i)
    for (int k = i; k > 0 && values[k - 1] > values[k]; --k) std::swap(values[k - 1], values[k]);
  return values[count / 2];
}

const QualityLevel& at(int level) { return qualityLevels()[static_cast<std::size_t>(level)]; }

}  // namespace

std::span<const QualityLevel, kQualityLevels> qualityLevels() {
  // Costs: the bunny on a software rasteriser, between 1280 x 960 without and 800 x 600 with multisampling (where
  // vertices and the resolve weigh more).
  static constexpr QualityLevel kLevels[kQualityLevels] = {
      // scale step hair fins shadows cost
      {1.00f, 1.00f, 1.0f, true, 2, 1.00f},
      {1.00f, 1.25f, 0.8f, true, 2, 0.92f},
      {0.85f, 1.25f, 0.7f, true, 2, 0.67f},
      {0.75f, 1.25f, 0.6f, true, 1, 0.53f},
      {0.65f, 1.50f, 0.5f, true, 1, 0.41f},
      {0.55f, 1.50f, 0.4f, true, 1, 0.31f},
      {0.50f, 1.75f, 0.35f, false, 1, 0.24f},
      {0.40f, 2.00f, 0.3f, false, 1, 0.17f},
  };
  return kLevels;
}

void QualityGovernor::setBudget(float milliseconds) {
  if (milliseconds == budget_) return;
  budget_ = std::max(milliseconds, 1.0f);
  forget();
}

void QualityGovernor::setBest(int level) {
  best_ = std::clamp(level, 0, kQualityLevels - 1);
  if (level_ < best_) moveTo(best_);
}

void QualityGovernor::forget() {
  known_ = {};
  unavoidable_ = believed_ = 0;
  quickest_ = 1e9f;
  loadBeforeFall_ = 0;
  frameTime_ = timeOfCost_ = 0;
  moveTo(level_);
}

void QualityGovernor::moveTo(int level) {
  level_ = level;
  sinceMove_ = 0;
  framesSinceMove_ = 0;
  window_.count = 0;
}

// Ms that the picture is to blame for.
float QualityGovernor::load() const {
  if (!timed_) return frameTime_;
  const float drawing = median(window_.drawing, window_.count);
  const bool late = frameTime_ > limit() && drawing <= limit();
  return late ? std::min(kBlame * drawing, frameTime_) : drawing;
}

float QualityGovernor::limit() const { return std::max(budget_ * kTooSlow, unavoidable_ * kNoLonger); }

void QualityGovernor::frame(float shown, float drawing) {
  if (!(shown > 0)) return;
  const bool pause = shown > kPause, again = std::exchange(pausedBefore_, pause);
  if (pause && !again) return;
  clock_ += shown;
  sinceMove_ += shown;
  evenTime_ += kEvening * (std::min(shown, kHiccup * limit()) - evenTime_);
  if (++framesSinceMove_ <= kSettlingFrames) return;
  timed_ = drawing > 0;
  if (!remember(shown, drawing)) return;
  frameTime_ = median(window_.shown, window_.count);
  timeOfCost_ = frameTime_ / at(level_).cost;
  const float load = this->load();
  quickest_ = std::min(quickest_ * kForgetting, load);
  forgetTheUnavoidable(load);
  judgeTheFall(load);
  if (sinceMove_ > kTrusted) known_[static_cast<std::size_t>(level_)] = {};
  if (load > limit()) fall(load);
  else climb(load);
}

void QualityGovernor::Window::add(float shownTime, float drawingTime) {
  if (count == kQualityWindow) dropOldest();
  shown[count] = shownTime;
  drawing[count++] = drawingTime;
}

void QualityGovernor::Window::dropOldest() {
  std::copy(shown.begin() + 1, shown.end(), shown.begin());
  std::copy(drawing.begin() + 1, drawing.end(), drawing.begin());
  --count;
}

// Keeps the newest frames of kWindow; whether they are enough to judge.
bool QualityGovernor::remember(float shown, float drawing) {
  window_.add(shown, drawing);
  const float most = kHiccup * limit();
  float time = 0;
  for (int i = 0; i < window_.count; ++i) time += std::min(window_.shown[i], most);
  for (; window_.count > kFewestFrames && time - window_.shown[0] >= kWindow; window_.dropOldest())
    time -= std::min(window_.shown[0], most);
  return window_.count == kQualityWindow || (window_.count >= kFewestFrames && time >= kShortWindow);
}

void QualityGovernor::judgeTheFall(float load) {
  if (loadBeforeFall_ <= 0) return;
  const bool useful = load < kNothing * loadBeforeFall_;
  const bool cheapest = level_ + 1 == kQualityLevels;
  if (!useful && !cheapest && at(level_).cost >= kMuchLess * costBeforeFall_) return;
  loadBeforeFall_ = 0;
  if (useful) return;
  unavoidable_ = load;
  believed_ = std::clamp(2 * believed_, kFirstBelief, kLongestBelief);
  believedUntil_ = clock_ + believed_;
}

void QualityGovernor::forgetTheUnavoidable(float load) {
  if (load < kNothing * unavoidable_ || clock_ > believedUntil_) unavoidable_ = 0;
}

void QualityGovernor::fall(float load) {
  if (level_ + 1 == kQualityLevels) return;
  Known& here = known_[static_cast<std::size_t>(level_)];
  here.wait = std::clamp(2 * here.wait, kFirstWait, kLongestWait);
  here.notBefore = clock_ + here.wait;
  if (loadBeforeFall_ <= 0) {
    loadBeforeFall_ = load;
    costBeforeFall_ = at(level_).cost;
  }
  int target = level_ + 1;
  // A try that failed goes back to where it came from; else as far as the costs say.
  const bool tried = here.loadBelow > 0 && sinceMove_ < kFirstWait;
  const float affordable = kFits * std::max(budget_, unavoidable_) / load * at(level_).cost;
  while (!tried && target + 1 < kQualityLevels && at(target).cost > affordable) ++target;
  moveTo(target);
}

bool QualityGovernor::expectedToFit(int level, float load) const {
  const Known& there = known_[static_cast<std::size_t>(level)];
  // It was too slow a short while ago, and what has come to hinder it has not clearly gone.
  if (clock_ < there.notBefore && !(timed_ && load < kGone * there.loadBelow)) return false;
  const float ratio = at(level).cost / at(level_).cost;
  if (load * ratio <= kFits * std::max(budget_, unavoidable_)) return true;
  if (timed_ && unavoidable_ <= 0) return false;
  // As quick as it has ever been: the screen's refresh, or what nothing undercuts, may hide that there is time left.
  return load <= kNoLonger * std::max(quickest_, unavoidable_);
}

void QualityGovernor::climb(float load) {
  if (!timed_) load = std::max(load, evenTime_);
  if (level_ <= best_ || sinceMove_ < kClimbWait || load > limit() || !expectedToFit(level_ - 1, load)) return;
  moveTo(level_ - 1);
  known_[static_cast<std::size_t>(level_)].loadBelow = load;
}

int QualityGovernor::bandsOfBest() const {
  return static_cast<int>(std::clamp(timeOfCost_ * at(best_).cost / kBandTime, 1.0f, kMostBands));
}

int QualityGovernor::stillLevel() const {
  int level = best_;
  while (level < level_ && timeOfCost_ * at(level).cost > kStillTime) ++level;
  return level;
}

}  // namespace fur::app
