// How good a picture may be, and how quick it must be.
#include <algorithm>

#include "app/AppState.h"

namespace fur::app {

int App::State::levelFor(Picture picture) const {
  if (!governed || picture == Picture::Best) return bestLevel;
  return picture == Picture::Moving ? governor.level() : governor.stillLevel();
}

void App::setQuality(int best, bool governed) {
  State& s = *state_;
  s.bestLevel = std::clamp(best, 0, kQualityLevels - 1);
  s.governed = governed;
  s.governor = {};
  s.governor.setBudget(s.frameBudget);
  s.governor.setBest(s.bestLevel);
  s.pictureChanged = true;
}

void App::setFrameBudget(float milliseconds) {
  state_->frameBudget = milliseconds;
  state_->governor.setBudget(milliseconds);
}

void App::frameShown(float milliseconds, float drawing) {
  // What a coat takes that grows meanwhile is not the picture's doing.
  if (state_->governed && !state_->coatWork) state_->governor.frame(milliseconds, drawing);
}

bool App::improvable() const { return state_->bestLevel < state_->drawnLevel; }

Result<bool> App::improve() {
  State& s = *state_;
  if (!improvable()) return false;
  const int still = s.levelFor(Picture::Still);
  if (s.pictureChanged || still < s.drawnLevel) {
    if (Status status = draw(Picture::Still); !status) return status.error();
    return true;
  }
  if (s.bandsDrawn == 0) s.bands = s.governor.bandsOfBest();
  const int bands = s.bands, band = s.bandsDrawn;
  if (Status status = s.drawBand(s.bestLevel, band, bands); !status) return status.error();
  if (s.bandsDrawn > 0) return false;
  s.drawnLevel = s.bestLevel;
  return true;
}

}  // namespace fur::app
