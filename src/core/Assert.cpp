#include "core/Assert.h"

#include <cstdio>
#include <cstdlib>

namespace fur {

void assertFailed(const char* where, const char* expected, const std::string& got) {
  const std::string line = std::string(where) + ": expected " + expected + ", got " + got + '\n';
  std::fputs(line.c_str(), stderr);
  std::abort();
}

}  // namespace fur
