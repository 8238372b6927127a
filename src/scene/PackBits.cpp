#include "scene/PackBits.h"

#include <algorithm>

namespace fur::scene {

namespace {
constexpr std::size_t kMost = 128;  // bytes that one header speaks of
}

std::vector<std::uint8_t> packBits(std::span<const std::uint8_t> bytes) {
  std::vector<std::uint8_t> out;
  const auto runAt = [&](std::size_t i) {
    std::size_t run = 1;
    while (run < kMost && i + run < bytes.size() && bytes[i + run] == bytes[i]) ++run;
    return run;
  };
  for (std::size_t i = 0; i < bytes.size();) {
    if (const std::size_t run = runAt(i); run > 2) {
      out.push_back(static_cast<std::uint8_t>(257 - run));
      out.push_back(bytes[i]);
      i += run;
      continue;
    }
    std::size_t end = i;
    while (end < bytes.size() && end - i < kMost && runAt(end) < 3) ++end;
    out.push_back(static_cast<std::uint8_t>(end - i - 1));
    out.insert(out.end(), bytes.begin() + static_cast<std::ptrdiff_t>(i), bytes.begin() + static_cast<std::ptrdiff_t>(end));
    i = end;
  }
  return out;
}

bool unpackBits(std::span<const std::uint8_t> packed, std::span<std::uint8_t> bytes) {
  std::size_t at = 0, to = 0;
  while (at < packed.size()) {
    const std::size_t head = packed[at++];
    if (head == 128) continue;
    const bool repeats = head > 128;
    const std::size_t count = repeats ? 257 - head : head + 1, given = repeats ? 1 : count;
    if (given > packed.size() - at || count > bytes.size() - to) return false;
    for (std::size_t i = 0; i < count; ++i) bytes[to++] = packed[at + (repeats ? 0 : i)];
    at += given;
  }
  return to == bytes.size();
}

}  // namespace fur::scene
