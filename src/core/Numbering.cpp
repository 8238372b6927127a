#include "core/Numbering.h"

#include <utility>

namespace fur {

Numbering::Slot& Numbering::slotOf(std::uint64_t key) {
  // Fibonacci hashing (Knuth, TAOCP 3, 6.4), then slot by slot.
  std::size_t at = static_cast<std::size_t>((key * 0x9e3779b97f4a7c15ull) >> 32);
  for (;; ++at) {
    Slot& slot = slots_[at & (slots_.size() - 1)];
    if (slot.number == 0 || slot.key == key) return slot;
  }
}

std::uint32_t Numbering::of(std::uint64_t key) {
  Slot& found = slotOf(key);
  if (found.number) return found.number - 1;
  found = {key, ++count_};
  if (2 * std::size_t{count_} > slots_.size()) {
    const std::vector<Slot> before = std::exchange(slots_, std::vector<Slot>(2 * slots_.size()));
    for (const Slot& slot : before)
      if (slot.number) slotOf(slot.key) = slot;
  }
  return count_ - 1;
}

}  // namespace fur
