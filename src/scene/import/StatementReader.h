// Reads text files with one statement a line, such as .obj and .fo: a keyword and further words. Lines end with LF, CR or
// both; `#` begins a comment where a word could begin; a backslash at the end of a line joins the next one to it. Lines are not
// copied, however long.
//
// Errors throw ImportError with the file, the line and the reason.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "core/Math.h"
#include "scene/import/ImportError.h"

namespace fur::scene {

class StatementReader {
 public:
  // Rejects files over kMaxFileBytes. `bytes` and `name` must outlive it.
  StatementReader(Bytes bytes, const std::string& name);

  // Goes to the next statement; false at the end of the file.
  bool next();
  std::string_view keyword() const { return keyword_; }

  // The next word of the statement; empty at its end.
  std::string_view word();
  // The next word as a finite number, or as an int. `what` names it in errors: "the x of a vertex".
  float number(const char* what);
  int whole(const char* what);
  // Three numbers, so limited that differences of positions are finite.
  Vec3 position();
  void expectEnd();

  // Removes an optional sign and digits from the front of `word`; false when there are no digits. A number that does not fit
  // 32 bits becomes one beyond all limits.
  static bool takeWhole(std::string_view& word, std::int64_t& out);
  // The index of an element that a face refers to by `number`, counted from 1; it must be defined already.
  std::uint32_t index(std::int64_t number, std::size_t count, const char* what) const;

  // Throws bad-file with a text as of std::printf.
  [[noreturn, gnu::format(printf, 2, 3)]] void bad(const char* format, ...) const;
  // Throws bad-file: `what` is `word`, and why that is wrong. `word` may have any bytes.
  [[noreturn]] void badWord(const char* what, std::string_view word, const char* why) const;
  // Throws too-large when `count` has reached the limit.
  void checkRoom(std::size_t count, std::size_t limit, const char* what) const;

 private:
  [[noreturn]] void fail(ErrorId id, const std::string& what) const;
  bool takeBreak();
  bool skipToWord();

  const char* at_;
  const char* end_;
  const std::string& name_;
  std::size_t line_ = 1;
  std::string_view keyword_;
};

}  // namespace fur::scene
