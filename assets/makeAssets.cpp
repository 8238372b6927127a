// wet-fur-make-assets IN OUT.glb [WATER | --hair HAIR]: makes a model that can be shipped from bare positions and triangles.
//
// IN holds little-endian 32-bit words: vertex count V, triangle count T, 3 V floats (positions), 3 T
// vertex indices, and 3 V floats (normals) or nothing. OUT is the same surface in the unit sphere with smooth normals and its own
// uv atlas.
//
// HAIR makes a scene of it that has long hair: lines of text, the scene's state as JSON and steps as Dress.h has them.
//
// WATER makes a wet scene of it: drop count D; 8 D floats, a drop each: where its way begins, in which direction it goes, its
// radius and wetness; then the scene's state as JSON. A drop wets the surface where its way first meets it.
#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <string>
#include <vector>

#include "assets/Dress.h"
#include "geometry/Surface.h"
#include "geometry/SurfaceQuery.h"
#include "scene/Model.h"
#include "wet/SurfaceWetting.h"

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
  const std::uint64_t vertices = words[0], triangles = words[1], bare = 2 + 3 * (vertices + triangles);
  if (words.size() != bare && words.size() != bare + 3 * vertices) return false;
  mesh.positions.resize(vertices);
  std::memcpy(mesh.positions.data(), &words[2], vertices * sizeof(fur::Vec3));
  mesh.indices.assign(words.begin() + static_cast<std::ptrdiff_t>(2 + 3 * vertices), words.begin() + static_cast<std::ptrdiff_t>(bare));
  if (words.size() > bare) {
    mesh.normals.resize(vertices);
    std::memcpy(mesh.normals.data(), &words[bare], vertices * sizeof(fur::Vec3));
  }
  for (const std::uint32_t index : mesh.indices) {
    if (index >= vertices) return false;
  }
  return true;
}

// `asUv`: the atlas is the model's own uv, else coordinates of the maps of its fur.
fur::geometry::Mesh withAtlas(const fur::geometry::Surface& surface, bool asUv) {
  fur::geometry::Mesh mesh;
  for (std::size_t i = 0; i < (asUv ? surface.vertices.size() : surface.trueVertexCount); ++i) {
    const fur::geometry::SurfaceVertex& vertex = surface.vertices[i];
    mesh.positions.push_back(vertex.position);
    mesh.normals.push_back(vertex.normal);
    (asUv ? mesh.uv : mesh.atlas).push_back(vertex.atlas);
  }
  mesh.indices = surface.indices;
  return mesh;
}

constexpr int kMaskSize = 256;

bool wetBy(const std::vector<std::uint32_t>& words, const fur::geometry::Surface& surface, fur::scene::FurData& fur) {
  const std::size_t drops = words.empty() ? 0 : words[0];
  if (words.size() < 1 + 8 * drops) return false;
  const fur::geometry::SurfaceQuery query(surface);
  const fur::wet::SurfaceWetting wetting(surface, kMaskSize);
  fur::wet::WetnessMask mask(kMaskSize);
  float most = 0;
  for (std::size_t i = 0; i < drops; ++i) {
    float d[8];
    std::memcpy(d, &words[1 + 8 * i], sizeof d);
    most = std::max(most, d[7]);
    if (const auto hit = query.castRay({d[0], d[1], d[2]}, fur::normalizeOr({d[3], d[4], d[5]}, {0, -1, 0})))
      wetting.addDroplet(mask, surface, query, positionAt(surface, *hit), normalAt(surface, *hit), d[6], d[7]);
  }
  fur.wetnessSize = kMaskSize;
  fur.wetness = mask.texels();
  // Where drops overlap no spot gets wetter than the wettest of them.
  for (fur::Vec4& texel : fur.wetness) texel.w = std::min(texel.w, most);
  fur.state.assign(reinterpret_cast<const char*>(words.data() + 1 + 8 * drops), 4 * (words.size() - 1 - 8 * drops));
  return true;
}

bool readLines(const char* path, std::vector<std::string>& lines) {
  std::FILE* file = std::fopen(path, "rb");
  if (!file) return false;
  lines.assign(1, "");
  for (int c = std::fgetc(file); c != EOF; c = std::fgetc(file)) c == '\n' ? lines.emplace_back() : lines.back() += static_cast<char>(c);
  std::fclose(file);
  return true;
}

int fail(const std::string& message) {
  std::fprintf(stderr, "wet-fur-make-assets: %s\n", message.c_str());
  return 1;
}

}  // namespace

int main(int argc, char** argv) {
  const bool haired = argc == 5 && argv[3] == std::string("--hair");
  if (argc != 3 && argc != 4 && !haired) return fail("expected IN and OUT.glb, and WATER for a wet one or --hair HAIR");
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
  fur::scene::FurData data;
  std::vector<std::uint32_t> water;
  if (argc == 4 && (!readFile(argv[3], water) || !wetBy(water, surface.value(), data))) return fail(std::string(argv[3]) + " cannot be read");
  std::vector<std::string> lines;
  if (haired) {
    if (!readLines(argv[4], lines)) return fail(std::string(argv[4]) + " cannot be read");
    data.state = lines[0];
    lines.erase(lines.begin());
    if (const auto status = dress(mesh, surface.value(), lines, data); !status) return fail(status.error().message);
  }
  // What is dressed keeps its own triangles, in their order: whoever made them finds each in the atlas.
  const fur::geometry::Mesh made = haired ? withAtlas(fur::geometry::ownSurface(surface.value(), mesh).surface, false) : withAtlas(surface.value(), argc == 3);
  const std::vector<std::uint8_t> glb = fur::scene::exportScene(made, name, data, {{}, fur::Vec4(1)});
  std::FILE* file = std::fopen(argv[2], "wb");
  if (!file) return fail(std::string(argv[2]) + " cannot be written");
  const bool whole = std::fwrite(glb.data(), 1, glb.size(), file) == glb.size();
  if (std::fclose(file) != 0 || !whole) return fail(std::string(argv[2]) + " cannot be written");
  std::printf("%s: %zu triangles, %u charts\n", argv[2], surface.value().triangleCount(), surface.value().chartCount);
  return 0;
}
