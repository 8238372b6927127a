// How importers fail inside: they throw, and guardedImport() makes a Result of it at their border.
#pragma once

#include <cstdint>
#include <exception>
#include <new>
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

// Whatever `work` returns or throws. `name` is the file's.
template <class T, class Work>
Result<T> guardedImport(const std::string& name, Work&& work) {
  try {
    return work();
  } catch (const ImportError& failure) {
    return failure.error;
  } catch (const std::bad_alloc&) {
    return Error{ErrorId::OutOfMemory, name + ": there is not enough memory for it"};
  } catch (const std::exception& failure) {
    return Error{ErrorId::BadFile, name + ": " + failure.what()};
  }
}

}  // namespace fur::scene
