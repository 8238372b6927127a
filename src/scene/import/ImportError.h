// Importers throw inside, and guardedImport() makes a Result of it. Texts are made by one printf-like function instead of
// concatenated strings, as the code that frees these when something throws would be a large part of the download.
#pragma once

#include <cstdint>
#include <cstdarg>
#include <exception>
#include <span>
#include <string>
#include <utility>

#include "core/Result.h"

namespace fur::scene {

using Bytes = std::span<const std::uint8_t>;

struct ImportError : std::exception {
  explicit ImportError(Error e) : error(std::move(e)) {}
  const char* what() const noexcept override { return error.message.c_str(); }
  Error error;
};

// std::printf for %s, %.<number>s, %d, %u, %zu, and %lld and %llu below 2^63 only, which makes it small.
[[gnu::format(printf, 1, 2)]] std::string formatted(const char* format, ...);
std::string formatted(const char* format, std::va_list arguments);

// The error of the exception being handled. `name`: of the file.
Error caughtError(const std::string& name);

// The result of `work`, or the error that it throws.
template <class T, class Work>
Result<T> guardedImport(const std::string& name, Work&& work) {
  try {
    return work();
  } catch (...) {
    return caughtError(name);
  }
}

}  // namespace fur::scene
