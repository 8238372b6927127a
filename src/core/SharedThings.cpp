#include "core/SharedThings.h"

namespace fur {

std::shared_ptr<void> SharedThings::find(std::uint64_t number) const {
  for (const auto& [of, thing] : things_)
    if (of == number && !thing.expired()) return thing.lock();
  return nullptr;
}

// In the place of one that has gone.
void SharedThings::add(std::uint64_t number, const std::shared_ptr<void>& thing) {
  for (auto& one : things_)
    if (one.second.expired()) return void(one = {number, thing});
  things_.emplace_back(number, thing);
}

}  // namespace fur
