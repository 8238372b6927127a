// wet-fur-make-assets IN OUT.glb: makes a model that can be shipped from bare positions and triangles.
//
// IN holds little-endian 32-bit words: vertex count V, triangle count T, 3 V floats (positions), 3 T
// vertex indices. OUT is the same surface in the unit sphere with smooth normals and its own uv atlas.
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <string>
#include <vector>

#include "geometry/Surface.h"
#include "scene/Model.h"

namespace {

bool readFile(const char* path, std::vector<std::uint32_t>& words) {
  std::FILE* file = std::fopen(path, "rb");
  if (!file) return false;
  std::uint32_t word;
  while (std::fread(&word, sizeof word, 1, file) == 1) words.push_back(word);
  std::fclose(file);
  return true;
}

bool meshFrom(const std::vector<std::uint32_t>& words, fur::geometry::Mesh& mesh) {
  if (words.size() < 2) return false;
  const std::uint64_t vertices = words[0], triangles = words[1];
  if (words.size() != 2 + 3 * (vertices + triangles)) return false;
  mesh.positions.resize(vertices);
  std::memcpy(mesh.positions.data(), &words[2], vertices * sizeof(fur::Vec3));
  mesh.indices.assign(words.begin() + static_cast<std::ptrdiff_t>(2 + 3 * vertices), words.end());
  for (const std::uint32_t index : mesh.indices) {
    if (index >= vertices) return false;
  }
  return true;
}

fur::geometry::Mesh withAtlas(const fur::geometry::Surface& surface) {
  fur::geometry::Mesh mesh;
  for (const fur::geometry::SurfaceVertex& vertex : surface.vertices) {
    mesh.positions.push_back(vertex.position);
    mesh.normals.push_back(vertex.normal);
    mesh.uv.push_back(vertex.atlas);
  }
  mesh.indices = surface.indices;
  return mesh;
}

int fail(const std::string& message) {
  std::fprintf(stderr, "wet-fur-make-assets: %s\n", message.c_str());
  return 1;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 3) return fail("expected two arguments, IN and OUT.glb");
  std::vector<std::uint32_t> words;
  fur::geometry::Mesh mesh;
  if (!readFile(argv[1], words)) return fail(std::string(argv[1]) + " cannot be read");
  if (!meshFrom(words, mesh)) return fail(std::string(argv[1]) + " does not hold what its counts say");
  fur::geometry::fitToUnitSphere(mesh);
  const auto surface = fur::geometry::buildSurface(mesh);
  if (!surface) return fail(surface.error().message);

  std::string name = argv[2];
  name = name.substr(name.find_last_of("/\\") + 1);
  name = name.substr(0, name.find_last_of('.'));
  const std::vector<std::uint8_t> glb = fur::scene::exportGlb(withAtlas(surface.value()), name);
  std::FILE* file = std::fopen(argv[2], "wb");
  if (!file) return fail(std::string(argv[2]) + " cannot be written");
  const bool whole = std::fwrite(glb.data(), 1, glb.size(), file) == glb.size();
  if (std::fclose(file) != 0 || !whole) return fail(std::string(argv[2]) + " cannot be written");
  std::printf("%s: %zu triangles, %u charts\n", argv[2], surface.value().triangleCount(), surface.value().chartCount);
  return 0;
}
