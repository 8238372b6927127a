#include "wet/ChangedTiles.h"

#include <algorithm>
#include <utility>

namespace fur::wet {

using geometry::TexelRect;

void ChangedTiles::note(const TexelRect& changed) {
  if (changed.empty()) return;
  all_ = unite(all_, changed);
  const int first = changed.x0 / tile(), last = (changed.x1 - 1) / tile();
  const auto bits = static_cast<std::uint16_t>((2u << last) - (1u << first));
  for (int row = changed.y0 / tile(); row <= (changed.y1 - 1) / tile(); ++row) rows_[static_cast<std::size_t>(row)] |= bits;
}

TexelRect ChangedTiles::take() {
  rows_ = {};
  return std::exchange(all_, TexelRect{});
}

std::vector<TexelRect> ChangedTiles::takeParts() {
  const std::array<std::uint16_t, kTiles> rows = rows_;
  const TexelRect all = take();
  if (all.empty()) return {};
  std::vector<TexelRect> parts;
  long area = 0;
  for (int row = 0; row < kTiles; ++row) {
    const std::uint16_t bits = rows[static_cast<std::size_t>(row)];
    // Rows with the same tiles are one part.
    int count = 1;
    while (bits && row + count < kTiles && rows[static_cast<std::size_t>(row + count)] == bits) ++count;
    for (int x = 0; x < kTiles; ++x) {
      if (!(bits >> x & 1)) continue;
      int end = x + 1;
      while (end < kTiles && (bits >> end & 1)) ++end;
      parts.push_back({std::max(x * tile(), all.x0), std::max(row * tile(), all.y0), std::min(end * tile(), all.x1),
                       std::min((row + count) * tile(), all.y1)});
      area += long{parts.back().x1 - parts.back().x0} * (parts.back().y1 - parts.back().y0);
      x = end;
    }
    if (bits) row += count - 1;
  }
  // Many calls cost more than a few texels.
  const long whole = long{all.x1 - all.x0} * (all.y1 - all.y0);
  if (parts.size() > 12 || 3 * area > 2 * whole) return {all};
  return parts;
}

}  // namespace fur::wet
