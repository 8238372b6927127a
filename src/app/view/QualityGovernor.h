// Holds a frame budget by taking work out of the picture: from measured frame times to one of a few levels.
// Pure logic without a clock: the same times give the same levels.
//
// Falls within about half a second of too slow frames, at once as far as the table's costs say. Climbs a step at a
// time, and only to a level that is expected to fit: where the machine tells how long the drawing alone takes,
// by that; elsewhere a screen that waits for its next refresh hides how much time is left, so the better level is
// tried, and after each try that failed it waits twice as long for the next. A time that cheaper levels do not
// shorten is not the picture's doing (a screen that shows 30 pictures a second, a page that is busy), and
// the best level that takes no longer is kept.
#pragma once

#include <array>
#include <span>

namespace fur::app {

// What is left out; the columns are render::Frame's. `fins` allows them where the settings ask for them, `shadows` is
// the most of the settings' choice (0 none, 1 by depth, 2 by layers).
struct QualityLevel {
  float pixelScale, stepLength, hairShare;
  bool fins;
  int shadows;
  float cost;  // of a frame, as a share of the first level's: a first guess (measured, see the table)
};

// From the best to the cheapest.
inline constexpr int kQualityLevels = 8;
std::span<const QualityLevel, kQualityLevels> qualityLevels();
// Frames at most that are looked at together.
inline constexpr int kQualityWindow = 64;

class QualityGovernor {
 public:
  // Milliseconds from one picture to the next, at first those of 60 a second. A change forgets what was learned.
  void setBudget(float milliseconds);
  // No better level than this one.
  void setBest(int level);
  // A frame of many that are drawn one after another. `shown`: milliseconds from the picture before to this one;
  // `drawing`: of the graphics processor for a recent frame, 0 where that cannot be known. A single frame of more
  // than a second is a pause (a tab that slept) and counts for nothing.
  void frame(float shown, float drawing = 0);
  // Another model, another size, another coat: what levels cost is to be learned anew. The level stays until then.
  void forget();

  int level() const { return level_; }
  // For a picture that is drawn once and then stays: the best that is not unbearably slow.
  int stillLevel() const;
  // For the best picture where that takes longer: in how many parts it is drawn so that none takes longer than a tenth of a
  // second.
  int bandsOfBest() const;
  // The median of the newest frames, shown one to shown one, in milliseconds; 0: none yet.
  float frameTime() const { return frameTime_; }

 private:
  // The newest frames, newest last; no heap, the page downloads this.
  struct Window {
    std::array<float, kQualityWindow> shown, drawing;
    int count = 0;

    void add(float shownTime, float drawingTime);
    void dropOldest();
  };
  // What is remembered of a level that was too slow.
  struct Known {
    float loadBelow = 0;   // ms: of the level below when it was last tried; 0: it was not
    float wait = 0;        // ms: from the last time that it was too slow to the next try
    double notBefore = 0;  // ms of clock_: that try
  };

  float load() const;
  bool remember(float shown, float drawing);
  void judgeTheFall(float load);
  void forgetTheUnavoidable(float load);
  void fall(float load);
  void climb(float load);
  bool expectedToFit(int level, float load) const;
  float limit() const;  // ms: more is too slow
  void moveTo(int level);

  float budget_ = 1000.0f / 60;
  int best_ = 0, level_ = 0;
  std::array<Known, kQualityLevels> known_{};
  Window window_;
  double clock_ = 0;           // ms of all frames
  float sinceMove_ = 0;  // ms at this level
  int framesSinceMove_ = 0;
  // Of the level where falling began, until it is clear what that brought; 0: it is, or there was none.
  float loadBeforeFall_ = 0, costBeforeFall_ = 1;
  float unavoidable_ = 0;      // ms that cheaper levels did not shorten; 0: none known
  float believed_ = 0;         // ms: how long that is believed
  double believedUntil_ = 0;   // ms of clock_
  float quickest_ = 1e9f;      // ms: median of the quickest frames so far
  float frameTime_ = 0, evenTime_ = 0;  // ms of shown: median; running average, since bursts deceive a median
  float timeOfCost_ = 0;  // ms: frameTime_ by the cost of the level that it was measured at
  bool timed_ = false, pausedBefore_ = false;
};

}  // namespace fur::app
