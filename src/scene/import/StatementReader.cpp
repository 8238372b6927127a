#include "scene/import/StatementReader.h"

#include <algorithm>
#include <cmath>

#include "core/NumberText.h"
#include "scene/Model.h"

namespace fur::scene {

namespace {

bool isBreak(char c) { return c == '\n' || c == '\r'; }
bool isBlank(char c) { return c == ' ' || c == '\t' || c == '\v' || c == '\f'; }

}  // namespace

StatementReader::StatementReader(Bytes bytes, const std::string& name)
    : at_(reinterpret_cast<const char*>(bytes.data())), end_(at_ + bytes.size()), name_(name) {
  if (bytes.size() > kMaxFileBytes) {
    fail(ErrorId::TooLarge, formatted("the file has %zu bytes; the limit is %zu", bytes.size(), kMaxFileBytes));
  }
  if (std::string_view(at_, bytes.size()).substr(0, 3) == "\xef\xbb\xbf") at_ += 3;  // byte order mark
}

bool StatementReader::takeBreak() {
  if (at_ == end_ || !isBreak(*at_)) return false;
  const bool pair = *at_ == '\r' && end_ - at_ > 1 && at_[1] == '\n';
  at_ += pair ? 2 : 1;
  ++line_;
  return true;
}

// False: the line, with those joined to it, holds no more words.
bool StatementReader::skipToWord() {
  while (at_ < end_) {
    if (isBlank(*at_)) {
      ++at_;
    } else if (*at_ == '\\' && end_ - at_ > 1 && isBreak(at_[1])) {
      ++at_;
      takeBreak();
    } else if (*at_ == '#') {
      while (at_ < end_ && !isBreak(*at_)) ++at_;
    } else {
      return !isBreak(*at_);
    }
  }
  return false;
}

std::string_view StatementReader::word() {
  if (!skipToWord()) return {};
  const char* const start = at_;
  while (at_ < end_ && !isBlank(*at_) && !isBreak(*at_)) {
    if (*at_ == '\\' && end_ - at_ > 1 && isBreak(at_[1])) break;
    if (*at_ == '\0') bad("there is a zero byte: this is not a text file");
    ++at_;
  }
  return {start, static_cast<std::size_t>(at_ - start)};
}

bool StatementReader::next() {
  if (!keyword_.empty())
    while (skipToWord()) word();
  keyword_ = {};
  while (keyword_.empty() && at_ < end_) {
    takeBreak();
    keyword_ = word();
  }
  return !keyword_.empty();
}

float StatementReader::number(const char* what) {
  const std::string_view text = word();
  if (text.empty()) bad("%s is missing", what);
  double value;
  if (!readDecimal(text, value)) badWord(what, text, "is not a number");
  // Halfway from the largest float to what would come next: up to there a number is rounded to a float.
  if (!(std::abs(value) < 0x1.ffffffp127)) badWord(what, text, "is too large");
  return static_cast<float>(value);
}

int StatementReader::whole(const char* what) {
  const std::string_view text = word();
  if (text.empty()) bad("%s is missing", what);
  std::string_view rest = text;
  std::int64_t value;
  const bool fits = takeWhole(rest, value) && rest.empty() && value == static_cast<int>(value);
  if (!fits) badWord(what, text, "is not a whole number of 32 bits");
  return static_cast<int>(value);
}

Vec3 StatementReader::position() {
  Vec3 p;
  const char* const names[3] = {"the x of a vertex", "the y of a vertex", "the z of a vertex"};
  for (int axis = 0; axis < 3; ++axis) {
    p[axis] = number(names[axis]);
    // Half of what float holds, so that differences of positions are finite too.
    if (std::abs(p[axis]) >= 1e38f) bad("%s is too large", names[axis]);
  }
  return p;
}

void StatementReader::expectEnd() {
  if (const std::string_view more = word(); !more.empty()) badWord("the last word", more, "is one too many");
}

bool StatementReader::takeWhole(std::string_view& word, std::int64_t& out) {
  std::size_t at = 0;
  const bool negative = !word.empty() && word[0] == '-';
  if (!word.empty() && (word[0] == '-' || word[0] == '+')) ++at;
  const std::size_t first = at;
  constexpr std::int64_t kPast = std::int64_t{1} << 40;
  for (out = 0; at < word.size() && isDigit(word[at]); ++at) out = std::min(out * 10 + (word[at] - '0'), kPast);
  if (negative) out = -out;
  const bool any = at > first;
  word.remove_prefix(at);
  return any;
}

std::uint32_t StatementReader::index(std::int64_t number, std::size_t count, const char* what) const {
  if (number == 0) bad("a face refers to %s 0; they are counted from 1", what);
  if (number < 0 || number > static_cast<std::int64_t>(count))
    bad("a face refers to %s %lld, but only %zu are defined so far", what, static_cast<long long>(number), count);
  return static_cast<std::uint32_t>(number - 1);
}

void StatementReader::fail(ErrorId id, const std::string& what) const {
  throw ImportError({id, formatted("%.200s, line %zu: %s", name_.c_str(), line_, what.c_str())});
}

void StatementReader::bad(const char* format, ...) const {
  std::va_list arguments;
  va_start(arguments, format);
  const std::string what = formatted(format, arguments);
  va_end(arguments);
  fail(ErrorId::BadFile, what);
}

void StatementReader::badWord(const char* what, std::string_view word, const char* why) const {
  constexpr std::size_t kShown = 40;
  char shown[kShown + 1] = {};
  for (std::size_t i = 0; i < std::min(word.size(), kShown); ++i) shown[i] = word[i] > 0x20 && word[i] < 0x7f ? word[i] : '?';
  bad("%s is \"%s%s\", which %s", what, shown, word.size() > kShown ? "..." : "", why);
}

void StatementReader::checkRoom(std::size_t count, std::size_t limit, const char* what) const {
  if (count >= limit) fail(ErrorId::TooLarge, formatted("there are over %zu %s, which is the limit", limit, what));
}

}  // namespace fur::scene
