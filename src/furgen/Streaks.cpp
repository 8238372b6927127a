#include "furgen/Streaks.h"

#include <cmath>

#include "core/Assert.h"
#include "core/Math.h"

namespace fur::furgen {

std::vector<std::uint8_t> streaks(std::span<const std::uint8_t> level, int size, float turn) {
  const auto side = static_cast<std::size_t>(size);
  FUR_ASSERT(level.size() == side * side * 4, "streaks()", "4 bytes a texel", level.size());
  std::vector<std::uint32_t> sums(level.size(), kStreakTexels / 2);
  for (int k = -(kStreakTexels / 2); k <= kStreakTexels / 2; ++k) {
    const auto offset = [&](float way) { return static_cast<std::size_t>((std::lround(static_cast<float>(k) * way) % size + size) % size); };
    const std::size_t right = offset(std::cos(turn * kPi)), down = offset(std::sin(turn * kPi));
    // Rows of bytes, of which the last come round to the first ones.
    for (std::size_t y = 0; y < side; ++y) {
      const std::uint8_t* from = &level[(y + down) % side * side * 4];
      std::uint32_t* to = &sums[y * side * 4];
      for (std::size_t i = 4 * right; i < 4 * side; ++i) *to++ += from[i];
      for (std::size_t i = 0; i < 4 * right; ++i) *to++ += from[i];
    }
  }
  std::vector<std::uint8_t> means(sums.size());
  for (std::size_t i = 0; i < means.size(); ++i) means[i] = static_cast<std::uint8_t>(sums[i] / kStreakTexels);
  return means;
}

}  // namespace fur::furgen
