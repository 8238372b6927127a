// Small glTF files for tests, put together from JSON text and bytes.
#pragma once

#include <cstdint>
#include <cstring>
#include <string>
#include <vector>

namespace fur::scene {

using FileBytes = std::vector<std::uint8_t>;

inline void append32(FileBytes& bytes, std::uint32_t value) {
  for (unsigned shift = 0; shift < 32; shift += 8) bytes.push_back(static_cast<std::uint8_t>(value >> shift));
}

template <class T>
void appendValues(FileBytes& bytes, const std::vector<T>& values) {
  const auto* from = reinterpret_cast<const std::uint8_t*>(values.data());
  bytes.insert(bytes.end(), from, from + values.size() * sizeof(T));
}

inline FileBytes glb(std::string json, FileBytes binary) {
  while (json.size() % 4 != 0) json += ' ';
  while (binary.size() % 4 != 0) binary.push_back(0);
  FileBytes file;
  append32(file, 0x46546c67);
  append32(file, 2);
  append32(file, static_cast<std::uint32_t>(28 + json.size() + binary.size()));
  append32(file, static_cast<std::uint32_t>(json.size()));
  append32(file, 0x4e4f534a);
  file.insert(file.end(), json.begin(), json.end());
  append32(file, static_cast<std::uint32_t>(binary.size()));
  append32(file, 0x004e4942);
  file.insert(file.end(), binary.begin(), binary.end());
  return file;
}

// One triangle (0,0,0) (1,0,0) (0,1,0) with 16-bit indices 0 1 2: 36 bytes of positions, 8 of indices.
// Any part of the JSON can be replaced before it is built.
struct TriangleFile {
  std::vector<float> positions{0, 0, 0, 1, 0, 0, 0, 1, 0};
  std::vector<std::uint16_t> indices{0, 1, 2, 0};
  FileBytes more;  // after the two
  std::string asset = R"({"version":"2.0"})";
  std::string top;  // further members, each followed by a comma
  std::string scene = R"("scene":0,"scenes":[{"nodes":[0]}],)";
  std::string nodes = R"([{"mesh":0}])";
  std::string primitive = R"({"attributes":{"POSITION":0},"indices":1})";
  std::string position = R"({"bufferView":0,"componentType":5126,"count":3,"type":"VEC3"})";
  std::string index = R"({"bufferView":1,"componentType":5123,"count":3,"type":"SCALAR"})";
  std::string moreAccessors, moreViews;  // each begins with a comma
  std::string buffer;  // instead of the binary chunk's

  std::string json() const {
    const std::size_t size = positions.size() * 4 + indices.size() * 2 + more.size();
    return "{\"asset\":" + asset + "," + top + scene + "\"nodes\":" + nodes + ",\"meshes\":[{\"primitives\":[" +
           primitive + "]}],\"accessors\":[" + position + "," + index + moreAccessors +
           "],\"bufferViews\":[{\"buffer\":0,\"byteOffset\":0,\"byteLength\":" + std::to_string(positions.size() * 4) +
           "},{\"buffer\":0,\"byteOffset\":" + std::to_string(positions.size() * 4) + ",\"byteLength\":" +
           std::to_string(indices.size() * 2) + "}" + moreViews + "],\"buffers\":[" +
           (buffer.empty() ? "{\"byteLength\":" + std::to_string(size) + "}" : buffer) + "]}";
  }

  FileBytes binary() const {
    FileBytes bytes;
    appendValues(bytes, positions);
    appendValues(bytes, indices);
    bytes.insert(bytes.end(), more.begin(), more.end());
    return bytes;
  }

  FileBytes build() const { return glb(json(), binary()); }
};

inline FileBytes textBytes(const std::string& text) { return {text.begin(), text.end()}; }

}  // namespace fur::scene
