// Text files of statements, one a line, as .obj and .fo are: a keyword and further words. Nothing in
// them is trusted. Lines end with LF, CR or both; `#` begins a comment where a word could begin; a
// backslash at the end of a line joins the next one to it. No line is ever copied, however long.
//
// Everything that fails throws ImportError with the file, the line and the reason.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "core/Math.h"
#include "scene/import/ImportError.h"

namespace fur::scene {

class StatementReader {
 public:
  // Refuses files over kMaxFileBytes. Holds on to `bytes` and `name`.
  StatementReader(Bytes bytes, const std::string& name);

  // Goes to the next statement, past what is left of this one; false at the end of the file.
  bool next();
  std::string_view keyword() const { return keyword_; }

  // The next word of the statement; empty: there is none.
  std::string_view word();
  // The next word as a finite number, or as a whole one in the range of int. `what` names it in errors:
  // "the x of a vertex".
  float number(const char* what);
  int whole(const char* what);
  // Three numbers of a size that differences of positions stay finite with.
  Vec3 position();
  void expectEnd();

  // Reads the digits of a number from the front of `word`, an optional sign first. False: there are none.
  // What does not fit 32 bits comes out as a number past every limit.
  static bool takeWhole(std::string_view& word, std::int64_t& out);
  // For an element that a face refers to by `number`, counted from 1: its index.
  std::uint32_t index(std::int64_t number, std::size_t count, const char* what) const;

  // Fails with bad-file and the reason, as std::printf has it.
  [[noreturn, gnu::format(printf, 2, 3)]] void bad(const char* format, ...) const;
  // Fails with bad-file: `what` is `word`, and why that will not do. Either may be whatever the file holds.
  [[noreturn]] void badWord(const char* what, std::string_view word, const char* why) const;
  // Fails with too-large when `count` elements leave no room for one more.
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
