#include "app/History.h"

#include <algorithm>

namespace fur::app {

namespace {

std::size_t bytesOf(const Step& step) {
  const auto* mask = std::get_if<MaskStep>(&step);
  return sizeof(Step) + (mask ? (mask->before.size() + mask->after.size()) * sizeof(Vec4) : 0);
}

std::vector<Vec4> cut(int size, const std::vector<Vec4>& texels, const wet::TexelRect& rect) {
  std::vector<Vec4> part;
  for (int y = rect.y0; y < rect.y1; ++y)
    part.insert(part.end(), texels.begin() + y * size + rect.x0, texels.begin() + y * size + rect.x1);
  return part;
}

}  // namespace

std::optional<MaskStep> maskStep(int size, const std::vector<Vec4>& before, const std::vector<Vec4>& after) {
  wet::TexelRect rect{size, size, 0, 0};
  for (int y = 0; y < size; ++y)
    for (int x = 0; x < size; ++x)
      if (before[static_cast<std::size_t>(y) * size + x] != after[static_cast<std::size_t>(y) * size + x])
        rect = {std::min(rect.x0, x), std::min(rect.y0, y), std::max(rect.x1, x + 1), std::max(rect.y1, y + 1)};
  if (rect.empty()) return std::nullopt;
  return MaskStep{rect, cut(size, before, rect), cut(size, after, rect)};
}

std::vector<Vec4> withRect(int size, std::vector<Vec4> texels, const wet::TexelRect& rect,
                           const std::vector<Vec4>& part) {
  const int width = rect.x1 - rect.x0;
  for (int y = rect.y0; y < rect.y1; ++y)
    std::copy_n(part.begin() + (y - rect.y0) * width, width, texels.begin() + y * size + rect.x0);
  return texels;
}

void History::push(Step step, bool mergeable) {
  steps_.resize(done_);
  auto* last = steps_.empty() ? nullptr : std::get_if<SettingsStep>(&steps_.back());
  auto* now = std::get_if<SettingsStep>(&step);
  if (mergeable && last && now) {
    last->after = now->after;
    return;
  }
  steps_.push_back(std::move(step));
  std::size_t bytes = 0, keep = steps_.size();
  while (keep > 0 && (bytes += bytesOf(steps_[keep - 1])) <= kMaxBytes) --keep;
  // The newest step always stays, however large.
  steps_.erase(steps_.begin(), steps_.begin() + static_cast<std::ptrdiff_t>(std::min(keep, steps_.size() - 1)));
  done_ = steps_.size();
}

std::optional<Step> History::undo() {
  if (!canUndo()) return std::nullopt;
  return steps_[--done_];
}

std::optional<Step> History::redo() {
  if (!canRedo()) return std::nullopt;
  return steps_[done_++];
}

void History::clear() {
  steps_.clear();
  done_ = 0;
}

}  // namespace fur::app
