// FNV-1a, 64 bits (Fowler, Noll and Vo): whether two states are the same, as one number. Not for hostile input.
#pragma once

#include <cstdint>
#include <span>
#include <type_traits>

namespace fur {

class Fnv1a {
 public:
  void addBytes(const void* data, std::size_t count) {
    const auto* bytes = static_cast<const std::uint8_t*>(data);
    for (std::size_t i = 0; i < count; ++i) hash_ = (hash_ ^ bytes[i]) * 0x100000001b3u;
  }
  // Of a struct with padding the result is not defined.
  template <class T>
    requires std::is_trivially_copyable_v<T>
  void add(const T& value) {
    addBytes(&value, sizeof value);
  }
  template <class Values>
  void addAll(const Values& values) {
    const std::span all(values);
    addBytes(all.data(), all.size_bytes());
  }
  std::uint64_t value() const { return hash_; }

 private:
  std::uint64_t hash_ = 0xcbf29ce484222325u;
};

}  // namespace fur
