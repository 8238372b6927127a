// A loop over independent pieces of work, on all processors.
#pragma once

#include <atomic>
#include <cstddef>
#include <thread>
#include <vector>

namespace fur::truth {

// Calls work(i) once for each i below `count`, in any order.
template <class Work>
void inParallel(std::size_t count, const Work& work) {
  std::atomic<std::size_t> next{0};
  const auto run = [&] {
    for (std::size_t i = next++; i < count; i = next++) work(i);
  };
  std::vector<std::thread> others;
  for (unsigned k = 1; k < std::thread::hardware_concurrency(); ++k) others.emplace_back(run);
  run();
  for (std::thread& other : others) other.join();
}

}  // namespace fur::truth
