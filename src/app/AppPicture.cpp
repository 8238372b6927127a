// Pictures that are saved, beside what is shown.
#include <algorithm>
#include <cmath>
#include <utility>

#include "app/AppState.h"

namespace fur::app {

Status App::drawPart(const PicturePart& part) {
  State& s = *state_;
  const int width = std::exchange(s.width, part.width), height = std::exchange(s.height, part.height);
  const int level = s.drawnLevel;
  const bool changed = s.pictureChanged;
  s.bottomRow = part.bottom;
  setSaved(true, part.transparent);
  const Status status = s.drawBand(s.bestLevel, 0, 1);
  setSaved(false);
  s.bottomRow = 0;
  s.width = width;
  s.height = height;
  s.drawnLevel = level;
  s.pictureChanged = changed;
  return status;
}

void advance(App& app, float seconds) {
  constexpr float kStep = 1.0f / 60;
  const int steps = std::max(1, static_cast<int>(std::ceil(seconds / kStep - 1e-3f)));
  for (int i = 0; i < steps; ++i) app.tick(seconds / static_cast<float>(steps));
}

void App::setStanding(bool stands) { state_->stands = stands; }

}  // namespace fur::app
