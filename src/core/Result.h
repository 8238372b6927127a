// A value, or an error that comes from outside (a file, a GPU, a limit). Our own bugs are
// FUR_ASSERT's. Tests check the id; people read the text, which names the thing and the limit.
#pragma once

#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "core/Assert.h"

namespace fur {

enum class ErrorId {
  WebglUnavailable,    // no OpenGL ES 3.0 / WebGL2 context, or a shader the driver refuses
  OutOfMemory,
  BadFile,             // the bytes are not what they claim to be
  TooLarge,            // well-formed, but over a stated limit
  UnsupportedVersion,  // well-formed, but of a version or extension that we do not read
  Network,             // a file could not be fetched or opened
  LargerProgram,       // only larger programs read it: long hair, and formats beside glTF (scene/Model.h)
};

// The spelling that JavaScript and the command line see: "bad-file".
const char* errorCode(ErrorId id);

struct Error {
  ErrorId id;
  std::string message;
};

// What was corrected without stopping the work: a clamped value, an unknown key.
using Warnings = std::vector<std::string>;

template <class T>
class [[nodiscard]] Result {
 public:
  Result(T value) : state_(std::move(value)) {}
  Result(Error error) : state_(std::move(error)) {}

  explicit operator bool() const { return state_.index() == 0; }
  T& value() { FUR_ASSERT(*this, "Result::value()", "a value", error().message); return std::get<0>(state_); }
  const T& value() const { FUR_ASSERT(*this, "Result::value()", "a value", error().message); return std::get<0>(state_); }
  const Error& error() const { return std::get<1>(state_); }
  T* operator->() { return &value(); }
  T& operator*() { return value(); }

 private:
  std::variant<T, Error> state_;
};

struct Done {};
using Status = Result<Done>;

}  // namespace fur
