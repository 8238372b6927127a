// What every C export of this folder shares. A function returns 0 when it failed; fur_errorCode()
// and fur_errorMessage() then say why. Text and number pointers that a function returns point to
// buffers of this module which the next call overwrites: the caller copies at once.
// Nothing of 64 bits crosses (hashes go as hexadecimal text), and no C++ exception does.
#pragma once

#include <emscripten/emscripten.h>

#include <cstdint>
#include <exception>
#include <initializer_list>
#include <new>
#include <string>
#include <vector>

#include "core/Result.h"
#include "scene/Model.h"

#define FUR_EXPORT extern "C" EMSCRIPTEN_KEEPALIVE

namespace fur::web {

void setError(Error error);
void setCaughtError();       // of the exception that is being handled; once, as every export has a handler
int fail(Error error);       // sets the error; 0
int report(Status status);   // 1, or sets the error and 0
const char* text(std::string value);
double* numbers(std::initializer_list<double> values);
const char* hexadecimal(std::uint64_t value);
scene::FileSet takeStagedFiles();
// Keeps what was saved for JavaScript to copy; returns how many bytes.
std::uint32_t keepSaved(std::vector<std::uint8_t> bytes);
const std::vector<std::uint8_t>& savedBytes();

// Runs `work` (returning int or a pointer); what it throws becomes an error and 0.
template <class Work>
auto guarded(Work&& work) -> decltype(work()) {
  try {
    return work();
  } catch (...) {
    setCaughtError();
  }
  return {};
}

}  // namespace fur::web
