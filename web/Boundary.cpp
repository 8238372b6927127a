#include "Boundary.h"

#include <cstdlib>
#include <utility>

#include "core/NumberText.h"

namespace fur::web {

namespace {

Error lastError{ErrorId::BadFile, ""};
scene::FileSet stagedFiles;
std::vector<std::uint8_t> saved;

}  // namespace

void setError(Error error) { lastError = std::move(error); }

void setCaughtError() {
  try {
    throw;
  } catch (const std::bad_alloc&) {
    setError({ErrorId::OutOfMemory, "the browser gives no more memory"});
  } catch (const std::exception& error) {
    setError({ErrorId::BadFile, error.what()});
  }
}

int fail(Error error) {
  setError(std::move(error));
  return 0;
}

int report(Status status) { return status ? 1 : fail(status.error()); }

const char* text(std::string value) {
  static std::string buffer;
  buffer = std::move(value);
  return buffer.c_str();
}

double* numbers(std::initializer_list<double> values) {
  static double buffer[16];
  FUR_ASSERT(values.size() <= 16, "web::numbers()", "at most 16 values", values.size());
  double* out = buffer;
  for (const double value : values) *out++ = value;
  return buffer;
}

const char* hexadecimal(std::uint64_t value) {
  return text(fur::hexadecimal(value, 16));
}

scene::FileSet takeStagedFiles() { return std::exchange(stagedFiles, {}); }

std::uint32_t keepSaved(std::vector<std::uint8_t> bytes) {
  saved = std::move(bytes);
  return static_cast<std::uint32_t>(saved.size());
}
const std::vector<std::uint8_t>& savedBytes() { return saved; }

}  // namespace fur::web

using namespace fur;

FUR_EXPORT void* fur_alloc(std::uint32_t bytes) {
  void* memory = std::malloc(bytes > 0 ? bytes : 1);
  if (!memory) web::setError({ErrorId::OutOfMemory, "the browser gives no more memory"});
  return memory;
}
FUR_EXPORT void fur_free(void* memory) { std::free(memory); }

FUR_EXPORT const char* fur_errorCode() { return errorCode(web::lastError.id); }
FUR_EXPORT const char* fur_errorMessage() { return web::lastError.message.c_str(); }

// One file that came along with a .gltf; the next load or import uses and forgets the staged files.
FUR_EXPORT int fur_stageFile(const char* name, const std::uint8_t* bytes, std::uint32_t size) {
  return web::guarded([&] {
    web::stagedFiles[name].assign(bytes, bytes + size);
    return 1;
  });
}
FUR_EXPORT void fur_clearStagedFiles() { web::stagedFiles.clear(); }
