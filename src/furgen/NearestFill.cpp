#include "furgen/NearestFill.h"

#include <algorithm>
#include <cstddef>

namespace fur::furgen {

namespace {
constexpr std::int32_t kFar = 1 << 14;
}

NearestFill::NearestFill(int size)
    : size_(size),
      distance_(static_cast<std::size_t>(size) * size),
      columnId_(static_cast<std::size_t>(size) * size),
      apex_(static_cast<std::size_t>(size) * 2),
      apexHeight_(static_cast<std::size_t>(size) * 2),
      from_(static_cast<std::size_t>(size) * 2 + 1) {}

void NearestFill::fill(std::uint32_t* ids) {
  const std::size_t texels = static_cast<std::size_t>(size_) * size_;
  if (std::all_of(ids, ids + texels, [](std::uint32_t id) { return id == 0; })) return;
  sweepColumns(ids);
  for (int y = 0; y < size_; ++y) joinRow(y, ids + static_cast<std::size_t>(y) * size_);
}

void NearestFill::sweepColumns(const std::uint32_t* ids) {
  const std::size_t texels = static_cast<std::size_t>(size_) * size_;
  for (std::size_t i = 0; i < texels; ++i) distance_[i] = ids[i] ? 0 : kFar;
  std::copy(ids, ids + texels, columnId_.begin());
  const auto take = [&](int to, int from) {
    std::int32_t* d = &distance_[static_cast<std::size_t>(to) * size_];
    std::uint32_t* id = &columnId_[static_cast<std::size_t>(to) * size_];
    const std::int32_t* dFrom = &distance_[static_cast<std::size_t>(from) * size_];
    const std::uint32_t* idFrom = &columnId_[static_cast<std::size_t>(from) * size_];
    for (int x = 0; x < size_; ++x) {
      const bool nearer = dFrom[x] + 1 < d[x];
      d[x] = nearer ? dFrom[x] + 1 : d[x];
      id[x] = nearer ? idFrom[x] : id[x];
    }
  };
  // One and a half rounds each way: what lies farther is nearer the other way round.
  const int mask = size_ - 1, end = size_ + size_ / 2;
  for (int y = 1; y < end; ++y) take(y & mask, (y - 1) & mask);
  for (int y = end - 2; y >= 0; --y) take(y & mask, (y + 1) & mask);
}

void NearestFill::joinRow(int y, std::uint32_t* row) {
  const std::int32_t* distance = &distance_[static_cast<std::size_t>(y) * size_];
  const std::uint32_t* id = &columnId_[static_cast<std::size_t>(y) * size_];
  const int mask = size_ - 1, half = size_ / 2;
  const auto height = [&](int q) { return distance[q & mask] * distance[q & mask] + q * q; };
  int top = -1;
  // No nearest texel is more than half a tile away, so this stretch holds every candidate.
  for (int q = -half; q < size_ + half; ++q) {
    if (distance[q & mask] >= kFar) continue;
    // Whole numbers below 2^24, so that single precision tells on which side of every texel they cross.
    const int h = height(q);
    float start = -1e30f;
    while (top >= 0) {
      const int v = apex_[top];
      start = static_cast<float>(h - apexHeight_[top]) / static_cast<float>(2 * (q - v));
      if (start > from_[top]) break;
      --top;
    }
    if (top < 0) start = -1e30f;
    apex_[++top] = q;
    apexHeight_[top] = h;
    from_[top] = start;
  }
  for (int x = 0, k = 0; x < size_; ++x) {
    while (k < top && from_[k + 1] <= static_cast<float>(x)) ++k;
    row[x] = id[apex_[k] & mask];
  }
}

bool fillRow(std::uint32_t* row, int columns) {
  const std::vector<std::uint32_t> drawn(row, row + columns);
  if (std::all_of(drawn.begin(), drawn.end(), [](std::uint32_t id) { return id == 0; })) return false;
  for (int x = 0; x < columns; ++x)
    for (int d = 1; row[x] == 0; ++d) {
      const std::uint32_t right = drawn[static_cast<std::size_t>((x + d) & (columns - 1))];
      row[x] = right ? right : drawn[static_cast<std::size_t>((x - d) & (columns - 1))];
    }
  return true;
}

}  // namespace fur::furgen
