// How well pictures are drawn: moving ones as well as the frame budget allows, those that stay in full, and then from more samples
// (render/Samples.h) for as long as nothing changes.
#include <algorithm>
#include <utility>

#include "app/AppState.h"
#include "render/Samples.h"

namespace fur::app {

namespace {

// Of a picture that stays on a machine on which one of them takes long, and of one that is saved.
constexpr int kFewSamples = 16;

}  // namespace

int mostSamples() { return render::kMostSamples; }

int App::State::levelFor(Picture picture) const {
  if (!governed || picture == Picture::Best) return bestLevel;
  return picture == Picture::Moving ? governor.level() : governor.stillLevel();
}

// Of the best picture; one that is enlarged is not drawn bit by bit.
int App::State::bandsOfBest() const {
  const bool small = qualityLevels()[static_cast<std::size_t>(bestLevel)].pixelScale < 1;
  return small || !governed ? 1 : governor.bandsOfBest();
}

int App::State::samplesWanted() const {
  if (!settings.refine || !refines || coat.growing()) return 1;
  // While fur dries there is another picture every few seconds.
  return bandsOfBest() > 1 || water.active(waterInputs(0, 0)) ? kFewSamples : render::kMostSamples;
}

Status App::State::drawFrame(const Drawn& drawn) {
  FUR_ASSERT(renderer.has_value(), "App::draw()", "an attached context", "none");
  groom.update(groomInputs());
  hair->update(hairInputs(0));
  if (!coat.shown()) {
    finishCoat();
    groom.update(groomInputs());
  }
  water.readPuddles();
  upload();
  const bool gathered = drawn.gathers && !drawn.flows && (drawn.sample > 0 || samplesWanted() > 1);
  chooseShellCount(gathered);
  render::Frame f = frame(drawn.level);
  f.sample = drawn.sample;
  f.gathers = drawn.gathers;
  f.bands = drawn.bands;
  f.band = drawn.band;
  f.flows = drawn.flows;
  if (gathered) f.shellCount = std::max(f.shellCount, kSlenderShells);
  const Status status = renderer->draw(f);
  uploadedBytes = renderer->takeUploadedBytes();
  noticeChanges();
  return status;
}

Status App::State::drawSamples(int level, int samples) {
  for (int i = 0; i < samples; ++i)
    if (Status status = drawFrame({.level = level, .sample = i, .gathers = samples > 1}); !status) return status;
  ++framesDrawn;
  return Done{};
}

void App::State::forgetSamples() {
  samplesDone = bandsDrawn = 0;
  stale = false;
  flowsBeside = 0;
}

bool App::State::flows() const { return flowsBeside == revisionButWater() && settings.refine && refines && !coat.growing(); }

// The first picture is drawn as all that move. Samples of the best one follow, each in bands where it takes long, and the first of them takes the place
// of that picture. After each band the mean of those that are whole is shown.
Status App::State::drawFlowing() {
  const bool first = samplesDone == 0;
  if (first) drawnLevel = levelFor(Picture::Moving);
  if (bandsDrawn == 0) bands = first ? 1 : bandsOfBest();
  const int level = first ? drawnLevel : bestLevel, sample = level < drawnLevel ? 0 : samplesDone;
  if (Status status = drawFrame({level, sample, true, bands, bandsDrawn, true}); !status) return status;
  ++framesDrawn;
  if (++bandsDrawn < bands) return Done{};
  bandsDrawn = 0;
  drawnLevel = level;
  samplesDone = sample + 1;
  samplesShown = std::min(samplesDone, render::kFlowingSamples);
  return Done{};
}

Status App::draw(Picture picture, int samples) {
  State& s = *state_;
  if ((s.flowing = picture == Picture::Moving && s.flows())) return s.drawFlowing();
  s.drawnLevel = s.levelFor(picture);
  s.samplesShown = std::clamp(samples, 1, render::kMostSamples);
  s.forgetSamples();
  if (Status status = s.drawSamples(s.drawnLevel, s.samplesShown); !status) return status;
  if (s.samplesShown > 1) s.samplesDone = s.samplesShown;
  return Done{};
}

Status App::drawPart(const PicturePart& part) {
  State& s = *state_;
  const int width = std::exchange(s.view.width, part.width), height = std::exchange(s.view.height, part.height);
  const bool unseen = s.pictureRevision() != s.noticed;
  s.bottomRow = part.bottom;
  s.rows = part.rows;
  setSaved(true, part.transparent);
  const Status status = s.drawSamples(s.bestLevel, part.samples);
  setSaved(false);
  s.bottomRow = s.rows = 0;
  s.view.width = width;
  s.view.height = height;
  if (part.samples > 1) s.forgetSamples();  // of what is shown
  // A picture for a file shows nobody what has changed since the last frame.
  s.noticed = s.pictureRevision() - (unseen ? 1 : 0);
  return status;
}

void App::setQuality(int best, bool governed) {
  State& s = *state_;
  s.bestLevel = std::clamp(best, 0, kQualityLevels - 1);
  s.governed = governed;
  s.governor = {};
  s.governor.setBudget(s.frameBudget);
  s.governor.setBest(s.bestLevel);
  ++s.changed;
}

void App::setFrameBudget(float milliseconds) {
  state_->frameBudget = milliseconds;
  state_->governor.setBudget(milliseconds);
}

void App::frameShown(float milliseconds, float drawing) {
  // What a coat takes that grows meanwhile is not the picture's doing; while water moves it is the best one, or a band of it.
  if (state_->governed && !state_->flowing && !state_->coat.growing()) state_->governor.frame(milliseconds, drawing);
}

void App::setRefining(bool refines) { state_->refines = refines; }

int App::savedSamples() const { return state_->settings.refine && state_->refines ? kFewSamples : 1; }

bool App::improvable() const {
  const State& s = *state_;
  return s.bestLevel < s.drawnLevel || s.stale || s.samplesShown < s.samplesWanted();
}

Result<bool> App::improve() {
  State& s = *state_;
  if (!improvable()) return false;
  const int still = s.levelFor(Picture::Still);
  if (s.pictureRevision() != s.noticed || still < s.drawnLevel) {
    if (Status status = draw(Picture::Still); !status) return status.error();
    if (!improvable()) s.renderer->rest();
    return true;
  }
  const bool rests = s.flowsBeside != 0;  // the water does, or moves by what nobody sees
  if (rests || (s.bandsDrawn == 0 && s.stale && s.samplesDone >= s.samplesWanted())) {
    s.forgetSamples();
    s.samplesShown = std::min(s.samplesShown, kFewSamples) - 1;  // it makes room for as many
  }
  if (s.samplesDone == 1 && s.bandsDrawn == 0 && !s.renderer->ready()) return false;  // for what the next ones are drawn with
  // The best picture is the first of its samples.
  if (s.bandsDrawn == 0) s.bands = s.bandsOfBest();
  if (Status status = s.drawFrame({s.bestLevel, s.samplesDone, true, s.bands, s.bandsDrawn}); !status) return status.error();
  if (++s.bandsDrawn < s.bands) return false;
  s.bandsDrawn = 0;
  ++s.samplesDone;
  // One that was there before stays until there is more of it than there was.
  if (s.drawnLevel == s.bestLevel && s.samplesDone <= s.samplesShown) return false;
  s.drawnLevel = s.bestLevel;
  s.samplesShown = s.samplesDone;
  ++s.framesDrawn;
  if (!improvable()) s.renderer->rest();
  return true;
}

Result<bool> App::showAgain() {
  State& s = *state_;
  if (s.pictureRevision() != s.noticed || s.flowsBeside || s.samplesDone == 0 || s.samplesDone < s.samplesShown) return false;
  render::Frame f = s.frame(s.bestLevel);
  f.sample = s.samplesDone - 1;
  if (Status status = s.renderer->showGathered(f); !status) return status.error();
  return true;
}

}  // namespace fur::app
