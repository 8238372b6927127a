// FUR_ASSERT(condition, "Class::function()", "what was expected", what came): for bugs of this program. Prints
// `Class::function(): expected X, got Y` and aborts. Errors of files and GPUs are Results instead.
#pragma once

#include <string>

#include "core/NumberText.h"

namespace fur {

[[noreturn]] void assertFailed(const char* where, const char* expected, const std::string& got);

inline std::string assertText(const std::string& s) { return s; }
inline std::string assertText(const char* s) { return s; }
template <class T>
std::string assertText(T number) { return decimal(static_cast<std::int64_t>(number)); }

}  // namespace fur

#define FUR_ASSERT(condition, where, expected, got) \
  ((condition) ? void() : ::fur::assertFailed(where, expected, ::fur::assertText(got)))
