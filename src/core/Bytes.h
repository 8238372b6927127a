// State as bytes, which the same build reads again elsewhere: what belongs to it is named once for both ways. Numbers,
// plain structures, vectors of them, and texts.
#pragma once

#include <cstdint>
#include <cstring>
#include <span>
#include <string_view>
#include <type_traits>
#include <vector>

namespace fur {

class ByteWriter {
 public:
  template <class... T>
  void operator()(const T&... values) {
    (put(values), ...);
  }
  std::vector<std::uint8_t> bytes;

 private:
  void put(std::string_view text) {
    put(static_cast<std::uint32_t>(text.size()));
    append(text.data(), text.size());
  }
  [[gnu::noinline]] void append(const void* from, std::size_t count) {
    const auto* first = static_cast<const std::uint8_t*>(from);
    bytes.insert(bytes.end(), first, first + count);
  }
  template <class T>
  void put(const T& value) {
    static_assert(std::is_trivially_copyable_v<T>);
    append(&value, sizeof value);
  }
  template <class T>
  void put(const std::vector<T>& values) {
    static_assert(std::is_trivially_copyable_v<T>);
    put(static_cast<std::uint32_t>(values.size()));
    append(values.data(), values.size() * sizeof(T));
  }
};

// Of bytes that end too early the rest stays as it was, vectors empty, and they are not sound.
class ByteReader {
 public:
  explicit ByteReader(std::span<const std::uint8_t> bytes) : bytes_(bytes) {}
  template <class... T>
  void operator()(T&... values) {
    (take(values), ...);
  }
  // Of a text that was written; a view into the bytes.
  std::string_view text() {
    std::uint32_t count = 0;
    take(count);
    sound_ &= count <= bytes_.size();
    const std::string_view out(reinterpret_cast<const char*>(bytes_.data()), sound_ ? count : 0);
    bytes_ = bytes_.subspan(out.size());
    return out;
  }
  // What was read is not sound.
  void fail() { sound_ = false; }
  // So far; and whether nothing is left.
  bool sound() const { return sound_; }
  bool atEnd() const { return bytes_.empty(); }

 private:
  [[gnu::noinline]] void copy(void* to, std::size_t count) {
    sound_ &= count <= bytes_.size();
    if (!sound_ || count == 0) return;
    std::memcpy(to, bytes_.data(), count);
    bytes_ = bytes_.subspan(count);
  }
  template <class T>
  void take(T& value) {
    copy(&value, sizeof value);
  }
  template <class T>
  void take(std::vector<T>& values) {
    std::uint32_t count = 0;
    take(count);
    sound_ &= count <= bytes_.size() / sizeof(T);
    values.resize(sound_ ? count : 0);
    copy(values.data(), values.size() * sizeof(T));
  }

  std::span<const std::uint8_t> bytes_;
  bool sound_ = true;
};

}  // namespace fur
