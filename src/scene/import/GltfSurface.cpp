#include "scene/import/GltfSurface.h"

#include <algorithm>
#include <cstring>

#include "geometry/AtlasUv.h"

namespace fur::scene {

namespace {

constexpr const char* kWhere = "WETFUR_fur.surface";

// A view full of such values; they lie there little-endian.
template <class T>
std::vector<T> values(const GltfFile& file, const Json& surface, const char* key) {
  const Bytes bytes = file.bufferView(file.whole(surface, key, kWhere)).bytes;
  if (bytes.size() % sizeof(T) != 0) file.bad("%s.%s has %zu bytes, which is not a whole number of values", kWhere, key, bytes.size());
  std::vector<T> out(bytes.size() / sizeof(T));
  if (!out.empty()) std::memcpy(out.data(), bytes.data(), bytes.size());
  return out;
}

}  // namespace

bool readSurface(const GltfFile& file, const Json& surface, Model& model) {
  if (!surface.isObject()) file.bad("%s is not an object", kWhere);
  geometry::Mesh& mesh = model.mesh;
  const auto indices = values<std::uint32_t>(file, surface, "indices");
  const auto charts = values<std::uint32_t>(file, surface, "charts");
  geometry::Mesh flat;
  flat.uv = values<Vec2>(file, surface, "atlas");
  std::vector<Vec3> comb;
  if (surface.find("comb")) comb = values<Vec3>(file, surface, "comb");
  if (charts.size() != flat.uv.size()) file.bad("%s.charts has %zu values; there are %zu of the atlas", kWhere, charts.size(), flat.uv.size());
  const bool same = file.whole(surface, "vertices", kWhere) == mesh.positions.size() && indices.size() == mesh.indices.size();
  if (!same) return false;
  if (!comb.empty() && comb.size() != mesh.positions.size()) file.bad("%s.comb has %zu values; there are %zu vertices", kWhere, comb.size(), mesh.positions.size());

  geometry::AtlasLayout layout;
  flat.positions.resize(flat.uv.size());
  for (std::size_t i = 0; i < indices.size(); ++i) {
    const std::uint32_t at = indices[i];
    if (at >= flat.uv.size()) file.bad("%s.indices has %u; there are %zu of the atlas", kWhere, at, flat.uv.size());
    flat.positions[at] = mesh.positions[mesh.indices[i]];
    layout.corners.push_back(flat.uv[at]);
    if (i % 3 != 0) continue;
    if (charts[at] >= mesh.triangleCount()) file.bad("%s.charts has %u; there are %zu triangles", kWhere, charts[at], mesh.triangleCount());
    layout.chartOf.push_back(charts[at]);
    layout.chartCount = std::max(layout.chartCount, charts[at] + 1);
  }
  std::vector<std::uint32_t> laid;  // those without an area are nowhere
  for (std::size_t i = 0; i < indices.size(); ++i)
    if (geometry::hasArea(mesh, i / 3)) laid.push_back(indices[i]);
  if (!geometry::isUniqueAtlas(flat, laid)) return false;
  mesh.layout = std::move(layout);
  model.fur.comb = std::move(comb);
  return true;
}

}  // namespace fur::scene
