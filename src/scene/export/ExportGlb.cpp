#include <cmath>
#include <cstdio>
#include <cstring>

#include "scene/Model.h"

namespace fur::scene {

namespace {

constexpr std::uint32_t kFloat = 5126, kUnsignedInt = 5125;
constexpr std::uint32_t kVertexBuffer = 34962, kIndexBuffer = 34963;

void append32(std::vector<std::uint8_t>& bytes, std::uint32_t value) {
  for (unsigned shift = 0; shift < 32; shift += 8) bytes.push_back(static_cast<std::uint8_t>(value >> shift));
}

void padTo4(std::vector<std::uint8_t>& bytes, std::uint8_t with) {
  while (bytes.size() % 4 != 0) bytes.push_back(with);
}

std::string quoted(const std::string& text) {
  std::string out = "\"";
  for (const char c : text) {
    if (c == '"' || c == '\\') out += '\\';
    if (static_cast<unsigned char>(c) < 0x20) out += ' ';
    else out += c;
  }
  return out + "\"";
}

std::string numbers(const float* values, int count) {
  std::string out = "[";
  for (int i = 0; i < count; ++i) {
    char text[32];
    std::snprintf(text, sizeof text, "%s%.9g", i ? "," : "", static_cast<double>(values[i]));
    out += text;
  }
  return out + "]";
}

// The JSON and binary chunks while they are put together.
struct Writer {
  std::vector<std::uint8_t> binary;
  std::string accessors, views;
  int count = 0;

  // One accessor on a view of its own; `extra` is further accessor JSON. Returns its index.
  int add(const void* data, std::size_t bytes, std::size_t elements, const char* type, std::uint32_t component,
          std::uint32_t target, const std::string& extra) {
    const auto* from = static_cast<const std::uint8_t*>(data);
    const char* comma = count ? "," : "";
    views += comma + std::string("{\"buffer\":0,\"byteOffset\":") + std::to_string(binary.size()) +
             ",\"byteLength\":" + std::to_string(bytes) + ",\"target\":" + std::to_string(target) + "}";
    accessors += comma + std::string("{\"bufferView\":") + std::to_string(count) +
                 ",\"componentType\":" + std::to_string(component) + ",\"count\":" + std::to_string(elements) +
                 ",\"type\":\"" + type + "\"" + extra + "}";
    binary.insert(binary.end(), from, from + bytes);
    padTo4(binary, 0);
    return count++;
  }
};

static_assert(sizeof(Vec3) == 12 && sizeof(Vec2) == 8, "vectors are written as they lie in memory (little-endian)");

}  // namespace

std::vector<std::uint8_t> exportGlb(const geometry::Mesh& mesh, const std::string& name) {
  Writer writer;
  const std::size_t vertices = mesh.positions.size();
  const geometry::Bounds box = geometry::bounds(mesh);
  std::string attributes = "\"POSITION\":" + std::to_string(writer.add(
      mesh.positions.data(), vertices * sizeof(Vec3), vertices, "VEC3", kFloat, kVertexBuffer,
      ",\"min\":" + numbers(&box.low.x, 3) + ",\"max\":" + numbers(&box.high.x, 3)));
  if (mesh.normals.size() == vertices) {
    attributes += ",\"NORMAL\":" + std::to_string(writer.add(mesh.normals.data(), vertices * sizeof(Vec3), vertices,
                                                             "VEC3", kFloat, kVertexBuffer, ""));
  }
  if (mesh.uv.size() == vertices) {
    attributes += ",\"TEXCOORD_0\":" + std::to_string(writer.add(mesh.uv.data(), vertices * sizeof(Vec2), vertices,
                                                                 "VEC2", kFloat, kVertexBuffer, ""));
  }
  const int indices = writer.add(mesh.indices.data(), mesh.indices.size() * 4, mesh.indices.size(), "SCALAR",
                                 kUnsignedInt, kIndexBuffer, "");
  std::string json = "{\"asset\":{\"version\":\"2.0\",\"generator\":\"wet-fur\"},\"scene\":0,"
                     "\"scenes\":[{\"nodes\":[0]}],\"nodes\":[{\"mesh\":0,\"name\":" + quoted(name) + "}],"
                     "\"meshes\":[{\"name\":" + quoted(name) + ",\"primitives\":[{\"attributes\":{" + attributes +
                     "},\"indices\":" + std::to_string(indices) + "}]}],\"accessors\":[" + writer.accessors +
                     "],\"bufferViews\":[" + writer.views + "],\"buffers\":[{\"byteLength\":" +
                     std::to_string(writer.binary.size()) + "}]}";
  std::vector<std::uint8_t> jsonBytes(json.begin(), json.end());
  padTo4(jsonBytes, ' ');

  std::vector<std::uint8_t> file;
  append32(file, 0x46546c67);  // "glTF"
  append32(file, 2);
  append32(file, static_cast<std::uint32_t>(12 + 8 + jsonBytes.size() + 8 + writer.binary.size()));
  append32(file, static_cast<std::uint32_t>(jsonBytes.size()));
  append32(file, 0x4e4f534a);  // "JSON"
  file.insert(file.end(), jsonBytes.begin(), jsonBytes.end());
  append32(file, static_cast<std::uint32_t>(writer.binary.size()));
  append32(file, 0x004e4942);  // "BIN"
  file.insert(file.end(), writer.binary.begin(), writer.binary.end());
  return file;
}

}  // namespace fur::scene
