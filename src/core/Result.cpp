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
    case ErrorId::LargerProgram: return "larger-program";
  }
  return "bad-file";
}

}  // namespace fur
