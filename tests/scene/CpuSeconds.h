// Files that mean harm must be refused soon. Time is this process's own, so that a busy machine fails nothing.
#pragma once

#include <ctime>

namespace fur::scene {

// Well-formed files of such sizes take some tenths of a second, what a reader must not do takes minutes; under the
// sanitizers in debug all takes ten times as long.
inline constexpr double kSoon = 10.0;

class CpuSeconds {
 public:
  double count() const { return static_cast<double>(std::clock() - start_) / CLOCKS_PER_SEC; }

 private:
  std::clock_t start_ = std::clock();
};

}  // namespace fur::scene
