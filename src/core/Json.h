// JSON texts (RFC 8259), as files and states bring them: nothing in them is trusted. A text becomes one list of nodes
// that point into it, in its order; strings and numbers are decoded when somebody asks. A tenth of what a general
// library would add to the download, and twelve bytes a value.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace fur {

class Json {
 public:
  bool isObject() const { return *begin_ == '{'; }
  bool isArray() const { return *begin_ == '['; }
  bool isString() const { return *begin_ == '"'; }
  bool isTrue() const { return *begin_ == 't'; }
  bool isNumber() const { return *begin_ == '-' || (*begin_ >= '0' && *begin_ <= '9'); }

  // NaN when it is no number; infinite when it is too large for one.
  double number() const;
  // The decoded string; "" when it is none.
  std::string text() const;
  // Its piece of the text.
  std::string_view source() const { return {begin_, size_}; }

  // The value of a key; null when there is none, or this is no object. Of several of one name the last counts.
  const Json* find(std::string_view key) const;

  // The elements of an array; the keys of an object, each with its value().
  class Iterator {
   public:
    explicit Iterator(const Json* at) : at_(at) {}
    const Json& operator*() const { return *at_; }
    Iterator& operator++() { return at_ += at_->nodes_, *this; }
    bool operator==(const Iterator&) const = default;

   private:
    const Json* at_;
  };
  Iterator begin() const { return Iterator(this + 1); }
  Iterator end() const { return Iterator(this + nodes_); }
  const Json& value() const { return this[1]; }
  std::size_t count() const;  // elements or keys, by walking along them

 private:
  friend class JsonParser;
  const char* begin_;
  std::uint32_t size_ = 0;   // bytes
  std::uint32_t nodes_ = 1;  // it and all within it
};

// The nodes of a text, of which the first is the whole; none when it is not JSON. They point into the text. Bytes of
// strings beyond ASCII are taken as they are.
std::vector<Json> parseJson(std::string_view text);

// A string as JSON has it, in quotes.
std::string jsonString(std::string_view text);

}  // namespace fur
