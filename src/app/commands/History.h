// Undo and redo of settings and strokes. Steps hold what they replace, bounded in bytes.
// A ModelStep stands where another model took the place of the one before: whoever holds the models brings the other.
#pragma once

#include <algorithm>
#include <iterator>
#include <memory>
#include <optional>
#include <span>
#include <variant>
#include <vector>

#include "app/commands/Commands.h"
#include "core/Bytes.h"
#include "groom/Groom.h"
#include "settings/Settings.h"
#include "wet/WetnessMask.h"

namespace fur::app {

struct SettingsStep {
  struct Both {
    settings::Settings before, after;
  };
  // Apart: steps of every kind would be as large.
  std::unique_ptr<Both> both = std::make_unique<Both>();
};

// What a mask holds: its texels and the film on them, empty where there is none.
struct MaskImage {
  std::vector<Vec4> texels;
  std::vector<float> film;
};

// The changed rectangle only, row-major; `before.texels` are empty where all was dry. `wet`: which texels were wet before, 32 in a
// number. Water runs on after a stroke: taken back, nothing is wet that was not.
struct MaskStep {
  wet::TexelRect rect;
  MaskImage before, after;
  std::vector<std::uint32_t> wet;
  std::vector<float> hairBefore{}, hairAfter{};  // wet::WetHair::state(), where that has changed
  std::vector<float> groundBefore{}, groundAfter{};  // wet::Water::wetGround()
};

// Water on parts that lost their fur, and with it the water: texels of the mask, what each held, the film on it.
struct DriedParts {
  std::vector<std::uint32_t> texels;
  std::vector<Vec4> held;
  std::vector<float> film;
};

// The changed rectangle of each map (groom::kMaps), row-major, or all of them when their size has changed; and the points
// that were combed otherwise; and all whiskers, when any of them has changed.
struct GroomStep {
  int sizeBefore = 0, sizeAfter = 0;
  struct Map {
    geometry::TexelRect rect;
    std::vector<groom::GroomMap::Texel> before, after;
  };
  Map maps[std::size(groom::kMaps)];
  std::vector<std::uint32_t> points;
  std::vector<Vec3> combBefore, combAfter;
  std::vector<groom::Whisker> whiskersBefore{}, whiskersAfter{};
  std::vector<std::uint8_t> bareBefore{}, bareAfter{};
  DriedParts dried{};
};

// All hair before and after, as HairStage::save() has it.
struct HairStep {
  std::vector<std::uint8_t> before, after;
};

struct ModelStep {};

using Step = std::variant<SettingsStep, MaskStep, GroomStep, HairStep, ModelStep>;
// The name that a step has in bytes.
Command commandOf(const Step& step);

// The step that turns `before` into `after` (both size x size); none when they are equal, but for `always`.
std::optional<MaskStep> maskStep(const MaskImage& before, const wet::WetnessMask& after, bool always = false);
std::optional<GroomStep> groomStep(const groom::Groom& before, const groom::Groom& after);
// Puts one side of the step in place.
void apply(const MaskStep& step, bool undo, wet::WetnessMask& mask);
void apply(const GroomStep& step, bool undo, groom::Groom& groom);
// Puts what the parts held where the mask is dry.
void putBack(const DriedParts& parts, wet::WetnessMask& mask);
// `texels` with the rectangle replaced by one side of the step.
template <class Texel>
std::vector<Texel> withRect(int size, std::vector<Texel> texels, const geometry::TexelRect& rect,
                            const std::vector<Texel>& part) {
  const int width = rect.x1 - rect.x0;
  for (int y = rect.y0; y < rect.y1; ++y)
    std::copy_n(part.begin() + (y - rect.y0) * width, width, texels.begin() + y * size + rect.x0);
  return texels;
}

class History {
 public:
  static constexpr std::size_t kMaxBytes = 16u << 20;

  // Forgets what could be redone. `mergeable`: a settings step may join the last one (a slider drag).
  void push(Step step, bool mergeable = false);
  // The step to take back or to do again, nullptr when there is none; valid until the next call.
  const Step* undo();
  const Step* redo();
  bool canUndo() const { return done_ > 0; }
  bool canRedo() const { return done_ < steps_.size(); }
  void clear();
  // Bytes of this build, for the same model. `leaves`: another model comes now, and a redo will lead there.
  void save(ByteWriter& to, bool leaves) const;
  // Of none there is nothing to undo. False: they are not sound, and nothing has changed.
  bool restore(std::span<const std::uint8_t> bytes);
  unsigned revision() const { return revision_; }  // another one after each of these

 private:
  unsigned revision_ = 0;
  std::vector<Step> steps_;  // [0, done_) are in effect
  std::size_t done_ = 0;
};

}  // namespace fur::app
