#include "render/WetCells.h"

#include <algorithm>
#include <cmath>

namespace fur::render {

namespace {

// Dry fur beside wet fur lies down with it: by less water than that it is not seen.
constexpr float kLies = 1.0f / 16;
bool looksWet(const Vec4& texel) { return texel.w > 0 || wet::lyingOf(texel) >= kLies; }

}  // namespace

void WetCells::update(const wet::MaskTexels& mask) {
  if (mask.rect.empty()) return;
  if (size_ != mask.size) {
    size_ = mask.size;
    texels_.assign(static_cast<std::size_t>(size_) * static_cast<std::size_t>(size_), 0);
    wet_.assign(static_cast<std::size_t>(kAcross) * kAcross, 0);
    ++revision_;
  }
  const geometry::TexelRect& rect = mask.rect;
  const auto row = [&](int y) { return static_cast<std::size_t>(y) * static_cast<std::size_t>(size_); };
  const Vec4* from = mask.texels.data();
  for (int y = rect.y0; y < rect.y1; ++y)
    for (int x = rect.x0; x < rect.x1; ++x) texels_[row(y) + static_cast<std::size_t>(x)] = looksWet(*from++);
  // A mask may have fewer texels than there are cells: each cell has one at least.
  const auto first = [&](int cell) { return cell * size_ / kAcross; };
  const auto last = [&](int cell) { return std::max((cell + 1) * size_ / kAcross, first(cell) + 1); };
  const auto cellOf = [&](int texel) { return texel * kAcross / size_; };
  for (int cy = cellOf(rect.y0); cy <= std::min(cellOf(rect.y1 - 1) + kAcross / size_, kAcross - 1); ++cy)
    for (int cx = cellOf(rect.x0); cx <= std::min(cellOf(rect.x1 - 1) + kAcross / size_, kAcross - 1); ++cx) {
      std::uint8_t wet = 0;
      for (int y = first(cy); y < last(cy); ++y)
        for (int x = first(cx); x < last(cx); ++x) wet |= texels_[row(y) + static_cast<std::size_t>(x)];
      std::uint8_t& known = wet_[static_cast<std::size_t>(cy * kAcross + cx)];
      if (known != wet) ++revision_;
      known = wet;
    }
}

void addCells(const Vec2& low, const Vec2& high, std::vector<std::uint16_t>& cells) {
  constexpr int kAcross = WetCells::kAcross;
  const auto cell = [](float at) { return std::clamp(static_cast<int>(std::floor(at * kAcross)), 0, kAcross - 1); };
  for (int y = cell(low.y); y <= cell(high.y); ++y)
    for (int x = cell(low.x); x <= cell(high.x); ++x) cells.push_back(static_cast<std::uint16_t>(y * kAcross + x));
}

}  // namespace fur::render
