// How importers fail inside: they throw, and guardedImport() makes a Result of it at their border.
// Texts are put together by one function instead of many small strings: with all that takes to free those
// when something throws they would be a good part of what a page downloads.
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

// As std::printf has it, of %s, %.<number>s, %d, %u, %zu, and %lld and %llu below 2^63 alone: that is what makes it small.
[[gnu::format(printf, 1, 2)]] std::string formatted(const char* format, ...);
std::string formatted(const char* format, std::va_list arguments);

// The error that the exception being handled stands for. `name` is the file's.
Error caughtError(const std::string& name);

// Whatever `work` returns or throws.
template <class T, class Work>
Result<T> guardedImport(const std::string& name, Work&& work) {
  try {
    return work();
  } catch (...) {
    return caughtError(name);
  }
}

}  // namespace fur::scene
