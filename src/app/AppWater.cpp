// What programs do with the water.
#include <algorithm>

#include "app/AppState.h"
#include "core/NumberText.h"

namespace fur::app {

namespace {

// Of a recorded text: steps of waiting at most, ten minutes. A broken text must not hold the program up.
constexpr double kMostWaitingSteps = 36000;

// Of the texels that are covered in a square of a picture the middle; none where they are few, as squares beside it have more of them.
std::optional<Vec2> middleOfCovered(std::span<const std::uint8_t> coverage, glm::ivec2 size, Vec2 corner, float side) {
  const glm::ivec2 first(corner), end = glm::min(glm::ivec2(corner + side), size);
  Vec2 sum(0);
  float count = 0;
  for (int y = first.y; y < end.y; ++y)
    for (int x = first.x; x < end.x; ++x)
      if (coverage[static_cast<std::size_t>(y) * static_cast<std::size_t>(size.x) + static_cast<std::size_t>(x)] >= 128) {
        sum += Vec2(x, y) + 0.5f;
        ++count;
      }
  if (count < 0.3f * side * side) return std::nullopt;
  return sum / count;
}

}  // namespace

void App::State::beginWaterStroke(Command what, float radius, float flow) {
  endStroke();
  const Vec3 eye(glm::inverse(worldFromModel()) * Vec4(view.pose().eye, 1));
  water.beginStroke({what, radius, flow, settings.clumpSize, eye});
}

void App::State::strokeOnce(Command what, float radius, float flow, const geometry::SurfacePoint& at, float height) {
  hair->update(hairInputs(0));  // no time may have gone by since it came
  beginWaterStroke(what, radius, flow);
  water.strokeAt(shape, at, 1, height);
  endStroke();
}

void App::splashAt(float u, float v, float radius, float amount) {
  state_->strokeOnce(Command::SplashAtlas, radius, amount, {0, Vec3(0, u, v), 0});
}

bool App::splashPixel(Vec2 pixel, float radius, float amount) {
  const auto hit = state_->pick(pixel);
  if (const auto met = state_->hairAt(pixel, hit)) return state_->strokeOnce(Command::Splash, radius, amount, met->root, met->height), true;
  if (hit) state_->strokeOnce(Command::Splash, radius, amount, *hit);
  return hit.has_value();
}

void App::setWetness(float amount) { state_->strokeOnce(Command::Soak, 0, amount); }

void App::dry(float seconds) { state_->strokeOnce(Command::DryOff, std::max(state_->settings.dryRate, 0.02f), seconds); }

void App::shake() {
  state_->endStroke();
  state_->note(Command::Shake);
  if (!state_->behaviour.act(traitsOf(Action::Shake).name)) state_->motion.body().shake();
}

void App::sprinkle(int drops) { state_->water.sprinkle(state_->shape, state_->worldFromModel(), drops); }

void App::stamp(std::span<const std::uint8_t> coverage, int width, int height, Vec2 centre, float across, float amount) {
  FUR_ASSERT(width > 0 && height > 0 && coverage.size() == static_cast<std::size_t>(width) * static_cast<std::size_t>(height),
             "App::stamp()", "width * height texels", coverage.size());
  State& s = *state_;
  // Clumps as fine as the letters need, and as the picture and the work allow.
  const float perTexel = across / static_cast<float>(width);
  const float step = std::max({static_cast<float>(height) / 18, static_cast<float>(width) / 120, 2 / std::max(perTexel, 1e-3f)});
  // Neighbours meet; what they wet hangs out of the letters by a strand's length as it is.
  const float radius = 0.55f * step * perTexel * s.view.unitsPerPixel(std::max(0.2f, s.view.distance()));
  s.beginWaterStroke(Command::Splash, radius, amount);
  for (float y = 0; y < static_cast<float>(height); y += step)
    for (float x = 0; x < static_cast<float>(width); x += step) {
      const auto texel = middleOfCovered(coverage, {width, height}, {x, y}, step);
      if (!texel) continue;
      const auto hit = s.pick(centre + perTexel * (*texel - 0.5f * Vec2(width, height)));
      if (hit) s.water.strokeAt(s.shape, *hit);
    }
  s.endStroke();
}

// --- doing it again ---

std::string App::recordedStrokes() const { return writeStrokes(state_->water.strokes()); }

Status App::replay(std::string_view json) {
  State& s = *state_;
  // Nothing is done of a text that is not sound all through.
  auto strokes = readStrokes(json, s.shape.surface().triangleCount());
  if (!strokes) return strokes.error();
  s.endStroke();
  if (strokes->empty()) return Done{};
  s.hand.drag = Drag::None;
  // The first begins now.
  const double begun = s.water.steps(), first = (*strokes)[0].points[0].step;
  s.water.alignClock();
  const float clumpSize = s.settings.clumpSize;
  for (const WaterStroke& stroke : *strokes) {
    s.settings.clumpSize = stroke.clump;
    for (const WaterStroke::Point& point : stroke.points) {
      // Not where the water rests: its clock stands.
      const double until = begun + std::min(point.step - first, kMostWaitingSteps);
      for (double before = -1; s.water.steps() < until && s.water.steps() != before;) {
        before = s.water.steps();
        tick(wet::Water::kStep);
      }
      if (stroke.what == Command::Shake) shake();
      else if (stroke.what == Command::Undo) undo();
      else if (stroke.what == Command::Redo) redo();
      else s.strokeAgain(stroke, point);
    }
    s.endStroke();
  }
  s.settings.clumpSize = clumpSize;
  return Done{};
}

void App::State::strokeAgain(const WaterStroke& stroke, const WaterStroke::Point& point) {
  if (&point == stroke.points.data()) water.beginStroke({stroke.what, stroke.radius, stroke.flow, stroke.clump, stroke.eye});
  if (goesOn(toolOf(stroke.what))) water.hold(point.at, point.pressure, point.height);
  else water.strokeAt(shape, point.at, point.pressure, point.height);
}

// --- what there is ---

std::span<const wet::Drop> App::drops() const { return state_->water.water().drops(); }
const wet::Water& App::water() const { return state_->water.water(); }
float App::wetnessAt(float u, float v) const { return state_->water.mask().at(u, v).w; }
float App::meanWetness() const { return state_->water.meanWetness(state_->shape); }
std::uint64_t App::wetnessHash() const { return state_->water.mask().hash(); }
const wet::WetnessMask& App::wetnessMask() const { return state_->water.mask(); }

wet::MaskTexels App::shownMask() const { return state_->water.texels(state_->shape); }

void App::restoreWetness(std::vector<Vec4> texels, std::vector<float> film) {
  state_->water.restoreMask(std::move(texels), std::move(film));
}

std::vector<std::uint8_t> App::saveWater() const { return state_->water.save(); }

Status App::restoreWater(std::span<const std::uint8_t> bytes) {
  state_->endStroke();
  if (state_->water.restore(bytes)) return Done{};
  return Error{ErrorId::BadFile, "water of " + decimal(bytes.size()) + " bytes is not of this model"};
}

}  // namespace fur::app
