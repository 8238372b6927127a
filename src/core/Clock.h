// This machine's clock: for how long work may go on, never for what comes out of it.
#pragma once

#include <ctime>

namespace fur {

// Not std::chrono: its clocks can throw, and the texts of what they throw bring all of printf to the download.
inline double secondsNow() {
  timespec now;
  clock_gettime(CLOCK_MONOTONIC, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

}  // namespace fur
