// Numbers for things in the order in which they are first seen: a hash table that is asked for nothing else is a tenth of
// the download that std::unordered_map is.
#pragma once

#include <cstdint>
#include <vector>

namespace fur {

class Numbering {
 public:
  // The key's number. A key that was not seen before has the next one, which is count() until then.
  std::uint32_t of(std::uint64_t key);
  std::uint32_t count() const { return count_; }

 private:
  struct Slot {
    std::uint64_t key = 0;
    std::uint32_t number = 0;  // and one more; 0: free
  };
  Slot& slotOf(std::uint64_t key);

  std::vector<Slot> slots_ = std::vector<Slot>(64);  // a power of two, at most half of them taken
  std::uint32_t count_ = 0;
};

}  // namespace fur
