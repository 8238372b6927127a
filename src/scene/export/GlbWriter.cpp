#include "scene/export/GlbWriter.h"
#include "core/NumberText.h"

#include <cstdio>

namespace fur::scene {

namespace {

void append32(std::vector<std::uint8_t>& bytes, std::size_t value) {
  for (unsigned shift = 0; shift < 32; shift += 8) bytes.push_back(static_cast<std::uint8_t>(value >> shift));
}

void appendChunk(std::vector<std::uint8_t>& file, std::size_t type, std::span<const std::uint8_t> bytes, std::uint8_t padding) {
  append32(file, (bytes.size() + 3) / 4 * 4);
  append32(file, type);
  file.insert(file.end(), bytes.begin(), bytes.end());
  padTo4(file, padding);
}

}  // namespace

int GlbWriter::addView(std::span<const std::uint8_t> bytes, const std::string& extra) {
  padTo4(binary, 0);
  views += (views.empty() ? "{\"buffer\":" : ",{\"buffer\":") + decimal(buffer) + ",\"byteOffset\":" + decimal(binary.size()) +
           ",\"byteLength\":" + decimal(bytes.size()) + extra + viewExtra + "}";
  binary.insert(binary.end(), bytes.begin(), bytes.end());
  padTo4(binary, 0);
  return viewCount++;
}

void padTo4(std::vector<std::uint8_t>& bytes, std::uint8_t with) {
  while (bytes.size() % 4 != 0) bytes.push_back(with);
}

std::string jsonNumbers(const float* values, int count) {
  std::string out = "[";
  for (int i = 0; i < count; ++i) {
    char text[32];
    std::snprintf(text, sizeof text, "%s%.9g", i ? "," : "", static_cast<double>(values[i]));
    out += text;
  }
  return out + "]";
}

std::vector<std::uint8_t> glbContainer(const std::string& json, std::span<const std::uint8_t> binary, std::span<const std::uint8_t> furtherChunks) {
  const auto padded = [](std::size_t bytes) { return (bytes + 3) / 4 * 4; };
  const std::size_t whole = 20 + padded(json.size()) + (binary.empty() ? 0 : 8 + padded(binary.size())) + furtherChunks.size();
  std::vector<std::uint8_t> file;
  file.reserve(whole);
  append32(file, 0x46546c67);  // "glTF"
  append32(file, 2);
  append32(file, whole);
  appendChunk(file, 0x4e4f534a, {reinterpret_cast<const std::uint8_t*>(json.data()), json.size()}, ' ');  // "JSON"
  if (!binary.empty()) appendChunk(file, 0x004e4942, binary, 0);                                          // "BIN"
  file.insert(file.end(), furtherChunks.begin(), furtherChunks.end());
  return file;
}

}  // namespace fur::scene
