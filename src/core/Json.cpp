#include "core/Json.h"

#include <cmath>
#include <limits>

#include "core/NumberText.h"

namespace fur {

namespace {

// The four digits of a \u; they have been checked.
std::uint32_t codeAt(const char* digits) {
  std::uint32_t code = 0;
  for (int i = 0; i < 4; ++i) code = code << 4 | static_cast<std::uint32_t>(hexDigit(digits[i]));
  return code;
}

void appendUtf8(std::string& out, std::uint32_t code) {
  if (code < 0x80) {
    out += static_cast<char>(code);
    return;
  }
  constexpr std::uint32_t kLead[] = {0, 0xc0, 0xe0, 0xf0};
  const int more = code < 0x800 ? 1 : code < 0x10000 ? 2 : 3;
  out += static_cast<char>(kLead[more] | code >> (6 * more));
  for (int i = more - 1; i >= 0; --i) out += static_cast<char>(0x80 | (code >> (6 * i) & 0x3f));
}

constexpr std::string_view kEscapes = "\"\\/bfnrt", kEscaped = "\"\\/\b\f\n\r\t";

}  // namespace

class JsonParser {
 public:
  explicit JsonParser(std::string_view text) : at_(text.data()), end_(at_ + text.size()) {}

  // Without recursion: a file may nest as deep as it likes.
  bool parse() {
    while (value())
      for (bool ended = true; ended;) {
        if (open_.empty()) return skipSpace(), at_ == end_;
        if (nodes[open_.back()].isString()) close();
        const bool object = nodes[open_.back()].isObject();
        if (take(',')) {
          if (object && !key()) return false;
          ended = false;
        } else {
          if (!take(object ? '}' : ']')) return false;
          close();
        }
      }
    return false;
  }

  std::vector<Json> nodes;

 private:
  void skipSpace() {
    while (at_ < end_ && (*at_ == ' ' || *at_ == '\n' || *at_ == '\r' || *at_ == '\t')) ++at_;
  }
  bool takeHere(char c) {
    const bool taken = at_ < end_ && *at_ == c;
    at_ += taken;
    return taken;
  }
  bool take(char c) {
    skipSpace();
    return takeHere(c);
  }

  void open() {
    open_.push_back(static_cast<std::uint32_t>(nodes.size()));
    nodes.emplace_back().begin_ = at_;
  }
  // Ends the innermost node that is open.
  void close() {
    const std::uint32_t index = open_.back();
    open_.pop_back();
    Json& node = nodes[index];
    if (!node.size_) node.size_ = static_cast<std::uint32_t>(at_ - node.begin_);
    node.nodes_ = static_cast<std::uint32_t>(nodes.size()) - index;
  }

  // A key stays open until its value has ended, but its own text ends here.
  bool key() {
    skipSpace();
    open();
    if (!string()) return false;
    nodes.back().size_ = static_cast<std::uint32_t>(at_ - nodes.back().begin_);
    return take(':');
  }

  // A value without parts; of one with parts all that comes before the first that has none.
  bool value() {
    for (;;) {
      skipSpace();
      if (at_ == end_) return false;
      open();
      const char first = *at_;
      if (first != '{' && first != '[') {
        if (!scalar(first)) return false;
        break;
      }
      ++at_;
      const bool object = first == '{';
      if (take(object ? '}' : ']')) break;
      if (object && !key()) return false;
    }
    close();
    return true;
  }

  bool scalar(char first) {
    if (first == '"') return string();
    return first == 't' ? literal("true") : first == 'f' ? literal("false") : first == 'n' ? literal("null") : number();
  }
  bool literal(std::string_view name) {
    const bool same = std::string_view(at_, static_cast<std::size_t>(end_ - at_)).substr(0, name.size()) == name;
    if (same) at_ += name.size();
    return same;
  }

  bool digits() {
    const char* const first = at_;
    while (at_ < end_ && isDigit(*at_)) ++at_;
    return at_ > first;
  }
  bool number() {
    takeHere('-');
    if (!takeHere('0') && !digits()) return false;
    if (takeHere('.') && !digits()) return false;
    if (!takeHere('e') && !takeHere('E')) return true;
    if (!takeHere('+')) takeHere('-');
    return digits();
  }

  bool string() {
    if (!takeHere('"')) return false;
    while (at_ < end_ && static_cast<unsigned char>(*at_) >= 0x20) {
      const char c = *at_++;
      if (c == '"') return true;
      if (c == '\\' && !escape()) return false;
    }
    return false;
  }
  bool escape() {
    if (at_ == end_) return false;
    const char c = *at_++;
    if (c != 'u') return kEscapes.find(c) != std::string_view::npos;
    if (end_ - at_ < 4) return false;
    for (int i = 0; i < 4; ++i)
      if (hexDigit(*at_++) < 0) return false;
    return true;
  }

  const char *at_, *const end_;
  std::vector<std::uint32_t> open_;  // the innermost last
};

double Json::number() const {
  double out = std::numeric_limits<double>::quiet_NaN();
  if (isNumber()) readDecimal(source(), out);
  return out;
}

std::string Json::text() const {
  std::string out;
  if (!isString()) return out;
  const char* const last = begin_ + size_ - 1;
  for (const char* at = begin_ + 1; at < last; ++at) {
    if (*at != '\\') {
      out += *at;
    } else if (*++at != 'u') {
      out += kEscaped[kEscapes.find(*at)];
    } else {
      std::uint32_t code = codeAt(at + 1);
      at += 4;
      if (code >> 10 == 0x36 && last - at > 6 && at[1] == '\\' && at[2] == 'u' && codeAt(at + 3) >> 10 == 0x37) {
        code = 0x10000 + ((code & 0x3ff) << 10) + (codeAt(at + 3) & 0x3ff);
        at += 6;
      }
      appendUtf8(out, code >> 11 == 0x1b ? 0xfffd : code);  // half a pair stands for nothing
    }
  }
  return out;
}

const Json* Json::find(std::string_view key) const {
  const Json* found = nullptr;
  if (!isObject()) return found;
  for (const Json& own : *this) {
    const std::string_view name = own.source().substr(1, own.size_ - 2);
    if (name == key || (name.find('\\') != std::string_view::npos && own.text() == key)) found = &own.value();
  }
  return found;
}

std::size_t Json::count() const {
  std::size_t count = 0;
  for (auto it = begin(); it != end(); ++it) ++count;
  return count;
}

std::vector<Json> parseJson(std::string_view text) {
  JsonParser parser(text);
  if (!parser.parse()) parser.nodes.clear();
  return std::move(parser.nodes);
}

std::string jsonString(std::string_view text) {
  std::string out = "\"";
  for (const char c : text) {
    if (static_cast<unsigned char>(c) < 0x20) {
      out.append("\\u").append(hexadecimal(static_cast<std::uint64_t>(c), 4));
      continue;
    }
    if (c == '"' || c == '\\') out += '\\';
    out += c;
  }
  return out + '"';
}

}  // namespace fur
