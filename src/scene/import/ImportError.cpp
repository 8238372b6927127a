#include "scene/import/ImportError.h"
#include "core/NumberText.h"

#include <new>
#include <string_view>

namespace fur::scene {

std::string formatted(const char* format, std::va_list arguments) {
  std::string out;
  for (const char* c = format; *c; ++c) {
    if (*c != '%') {
      out += *c;
      continue;
    }
    std::size_t most = 0;
    if (*++c == '.')
      while (*++c >= '0' && *c <= '9') most = most * 10 + static_cast<std::size_t>(*c - '0');
    switch (*c) {
      case 's': {
        const std::string_view text = va_arg(arguments, const char*);
        out += most ? text.substr(0, most) : text;
        break;
      }
      case 'd': out += decimal(va_arg(arguments, int)); break;
      case 'u': out += decimal(va_arg(arguments, unsigned)); break;
      case 'z': out += decimal(va_arg(arguments, std::size_t)), ++c; break;
      case 'l': out += decimal(va_arg(arguments, long long)), c += 2; break;
      default: out += *c;
    }
  }
  return out;
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
