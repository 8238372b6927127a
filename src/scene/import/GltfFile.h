// A .glb or .gltf as JSON and bytes: nothing in it is trusted, every look-up is checked.
//
// JSON is read by nlohmann::json directly: a glTF library that fills structures first would read
// views and images before anybody has checked them.
// All members throw ImportError, which importGltf catches.
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "core/Result.h"
#include "scene/Model.h"
#include "scene/import/ImportError.h"

namespace fur::scene {

using Json = nlohmann::json;

class GltfFile {
 public:
  // Reads the container and the JSON, refuses versions and required extensions that we do not read.
  // Holds on to `bytes` and `others`.
  GltfFile(Bytes bytes, const std::string& name, const FileSet& others);

  const Json& json() const { return json_; }

  // The element of a top-level array; bad-file when there is none. The text calls it `key[index]`.
  const Json& element(const char* key, std::uint64_t index) const;
  // How many elements a top-level array has; 0 when it is absent.
  std::size_t count(const char* key) const;

  // A non-negative whole number. `where` names the object in the error's text.
  std::uint64_t whole(const Json& object, const char* key, const std::string& where) const;
  std::uint64_t whole(const Json& object, const char* key, std::uint64_t absent, const std::string& where) const;
  // `count` finite numbers, or false when the key is absent.
  bool numbers(const Json& object, const char* key, float* out, std::size_t count, const std::string& where) const;

  struct View {
    Bytes bytes;
    std::size_t stride;  // 0: packed
  };
  View bufferView(std::uint64_t index) const;
  // What a URI stands for: the data in it, or the file that came along; empty pointer when it did not.
  bool resolve(const std::string& uri, std::vector<std::uint8_t>& decoded, Bytes& bytes) const;

  [[noreturn]] void fail(ErrorId id, const std::string& what) const;
  [[noreturn]] void bad(const std::string& what) const { fail(ErrorId::BadFile, what); }

 private:
  Bytes splitContainer(Bytes bytes);
  void checkShape(Bytes text) const;
  void checkVersion() const;
  Bytes buffer(std::uint64_t index) const;

  std::string name_;
  const FileSet& others_;
  Json json_;
  Bytes binary_;
  bool hasBinary_ = false;
  mutable std::map<std::uint64_t, Bytes> buffers_;
  mutable std::vector<std::vector<std::uint8_t>> decoded_;  // what data: URIs held
};

}  // namespace fur::scene
