// Undo and redo of settings and strokes. Steps hold what they replace, bounded in bytes.
#pragma once

#include <optional>
#include <variant>
#include <vector>

#include "settings/Settings.h"
#include "wet/WetnessMask.h"

namespace fur::app {

struct SettingsStep {
  settings::Settings before, after;
};

// The changed rectangle only, row-major.
struct MaskStep {
  wet::TexelRect rect;
  std::vector<Vec4> before, after;
};

using Step = std::variant<SettingsStep, MaskStep>;

// The step that turns `before` into `after` (both size x size); none when they are equal.
std::optional<MaskStep> maskStep(int size, const std::vector<Vec4>& before, const std::vector<Vec4>& after);
// `texels` with the rectangle replaced by one side of the step.
std::vector<Vec4> withRect(int size, std::vector<Vec4> texels, const wet::TexelRect& rect,
                           const std::vector<Vec4>& part);

class History {
 public:
  static constexpr std::size_t kMaxBytes = 16u << 20;

  // Forgets what could be redone. `mergeable`: a settings step may join the last one (a slider drag).
  void push(Step step, bool mergeable = false);
  std::optional<Step> undo();
  std::optional<Step> redo();
  bool canUndo() const { return done_ > 0; }
  bool canRedo() const { return done_ < steps_.size(); }
  void clear();

 private:
  std::vector<Step> steps_;  // [0, done_) are in effect
  std::size_t done_ = 0;
};

}  // namespace fur::app
