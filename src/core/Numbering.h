// Numbers keys in the order in which they are first seen. A hash table for this alone; it adds a tenth of what
// std::unordered_map would add to the download.
#pragma once

#include <cstdint>
#include <vector>

namespace fur {

class Numbering {
 public:
  // The key's number. A new key gets the next one, count().
  std::uint32_t of(std::uint64_t key);
  std::uint32_t count() const { return count_; }

 private:
  struct Slot {
    std::uint64_t key = 0;
    std::uint32_t number = 0;  // plus one; 0: a free slot
  };
  Slot& slotOf(std::uint64_t key);

  std::vector<Slot> slots_ = std::vector<Slot>(64);  // a power of two, at most half of them used
  std::uint32_t count_ = 0;
};

}  // namespace fur
