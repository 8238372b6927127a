// Reads JSON (RFC 8259) from files and saved states; hostile input is expected. A text becomes one list of nodes in its order,
// which point into the text; strings and numbers are decoded on demand. It adds a tenth of what a general library would add
// to the download, and takes twelve bytes a value.
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

  // NaN when it is not a number, infinite when it is too large for a double.
  double number() const;
  // The decoded string; "" when it is not a string.
  std::string text() const;
  // The part of the text that it was read from.
  std::string_view source() const { return {begin_, size_}; }

  // The value of a key; null when there is none or this is not an object. If a key occurs twice, the last one counts.
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
  std::uint32_t nodes_ = 1;  // this node and all inside it
};

// The nodes of a text; the first one is the whole. Empty when the text is not JSON. The nodes point into the text. Bytes of
// strings that are not ASCII are not checked.
std::vector<Json> parseJson(std::string_view text);

// The text as a JSON string, in quotes.
std::string jsonString(std::string_view text);

}  // namespace fur
