// A .glb or .gltf as JSON and bytes; every look-up is checked. (A glTF library that fills structs first would read views and
// images before they have been checked.) All members throw ImportError, which importGltf() catches.
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "core/Json.h"
#include "core/Result.h"
#include "scene/Model.h"
#include "scene/import/ImportError.h"

namespace fur::scene {

using Whole = unsigned long long;  // a number of the file, up to 2^53; %llu prints it

class GltfFile {
 public:
  // Reads the container and the JSON; rejects unknown versions and required extensions. `bytes` and `others` must outlive it.
  GltfFile(Bytes bytes, const std::string& name, const FileSet& others);

  const Json& json() const { return nodes_[0]; }

  // An element of a top-level array, `key[index]` in error texts; bad-file when there is none.
  const Json& element(const char* key, Whole index) const;
  // How many elements a top-level array has; 0 when it is absent.
  std::size_t count(const char* key) const;

  // Too-large when the object has far more keys than glTF defines: each look-up is linear in the number of keys.
  void expectFewKeys(const Json& object, const std::string& where) const;

  // A non-negative whole number. `where` names the object in the error's text.
  Whole whole(const Json& object, const char* key, const std::string& where) const;
  Whole whole(const Json& object, const char* key, Whole absent, const std::string& where) const;
  // `count` finite numbers, or false when the key is absent.
  bool numbers(const Json& object, const char* key, float* out, std::size_t count, const std::string& where) const;

  struct View {
    Bytes bytes;
    std::size_t stride;  // 0: packed
  };
  View bufferView(Whole index) const;
  Bytes buffer(Whole index) const;
  // The data of a URI: decoded from it, or from a file beside the model's. False when there is none.
  bool resolve(const std::string& uri, std::vector<std::uint8_t>& decoded, Bytes& bytes) const;

  // Throws, with a text as of std::printf; bad() throws bad-file.
  [[noreturn, gnu::format(printf, 3, 4)]] void fail(ErrorId id, const char* format, ...) const;
  [[noreturn, gnu::format(printf, 2, 3)]] void bad(const char* format, ...) const;

 private:
  Bytes splitContainer(Bytes bytes);
  void checkShape(Bytes text) const;
  void checkVersion() const;
  const std::vector<const Json*>& list(const char* key) const;
  [[noreturn]] void failWith(ErrorId id, const std::string& what) const;

  std::string name_;
  const FileSet& others_;
  std::vector<Json> nodes_;
  mutable std::map<std::string_view, std::vector<const Json*>> lists_;  // what top-level arrays hold
  Bytes binary_;
  bool hasBinary_ = false;
  mutable std::map<Whole, Bytes> buffers_;
  mutable std::vector<std::vector<std::uint8_t>> decoded_;  // what data: URIs held
};

}  // namespace fur::scene
