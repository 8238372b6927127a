#include "core/Result.h"

namespace fur {

const char* errorCode(ErrorId id) {
  switch (id) {
    case ErrorId::WebglUnavailable: return "webgl-unavailable";
    case ErrorId::OutOfMemory: return "out-of-memory";
    case ErrorId::BadFile: return "bad-file";
    case ErrorId::TooLarge: return "too-large";
    case ErrorId::UnsupportedVersion: return "unsupported-version";
    case ErrorId::Network: return "network";
    case ErrorId::LongHair: return "long-hair";
  }
  return "bad-file";
}

}  // namespace fur
