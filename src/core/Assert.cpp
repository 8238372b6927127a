#include "core/Assert.h"

#include <cstdio>
#include <cstdlib>

namespace fur {

void assertFailed(const char* where, const char* expected, const std::string& got) {
  std::fprintf(stderr, "%s: expected %s, got %s\n", where, expected, got.c_str());
  std::abort();
}

}  // namespace fur
