// Things that several have in common, by a number that stands for what they are made of; each is there for as long as anyone has it.
#pragma once

#include <cstdint>
#include <memory>
#include <utility>
#include <vector>

namespace fur {

class SharedThings {
 public:
  // Nothing: nobody has one.
  std::shared_ptr<void> find(std::uint64_t number) const;
  void add(std::uint64_t number, const std::shared_ptr<void>& thing);

 private:
  std::vector<std::pair<std::uint64_t, std::weak_ptr<void>>> things_;
};

}  // namespace fur
