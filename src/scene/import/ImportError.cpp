#include "scene/import/ImportError.h"

#include <cstdio>
#include <new>

namespace fur::scene {

std::string formatted(const char* format, std::va_list arguments) {
  char text[501];
  std::vsnprintf(text, sizeof text, format, arguments);
  return text;
}

std::string formatted(const char* format, ...) {
  std::va_list arguments;
  va_start(arguments, format);
  std::string text = formatted(format, arguments);
  va_end(arguments);
  return text;
}

Error caughtError(const std::string& name) {
  try {
    throw;
  } catch (const ImportError& failure) {
    return failure.error;
  } catch (const std::bad_alloc&) {
    return {ErrorId::OutOfMemory, name + ": there is not enough memory for it"};
  } catch (const std::exception& failure) {
    return {ErrorId::BadFile, name + ": " + failure.what()};
  }
}

}  // namespace fur::scene
