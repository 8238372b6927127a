// What goes from a groom into files and to other programs, and back.
#include <cstring>

#include "app/stages/GroomStage.h"
#include "core/Fnv1a.h"
#include "groom/GroomFilters.h"

namespace fur::app {

namespace {

// Of what save() gives, which browsers keep from visit to visit: another one whenever that changes. The second is that of models with
// several materials.
constexpr std::uint32_t kGroomLayout = 1, kMaterialsLayout = 2;

// Values of points as values of the surface's true vertices; none stay none.
template <class T>
std::vector<T> perVertex(const std::vector<T>& ofPoints, const groom::GroomSurface& skin) {
  std::vector<T> out;
  for (std::size_t i = 0; !ofPoints.empty() && i < skin.surface.trueVertexCount; ++i)
    out.push_back(ofPoints[skin.points.pointOf[i]]);
  return out;
}

std::array<std::uint32_t, groom::kWhiskerBytes / 4> wordsOf(const groom::Whisker& whisker) {
  std::array<std::uint32_t, groom::kWhiskerBytes / 4> words;
  std::memcpy(words.data(), &whisker, sizeof whisker);
  return words;
}

}  // namespace

void GroomStage::read(const ShapeStage& shape, const scene::FurData& fur, Warnings& warnings) {
  if (fur.map.empty() && fur.comb.empty() && fur.lengths.empty() && fur.types.empty() && fur.whiskers.empty()) return;
  if (!fur.map.empty()) groom::resize(groom_, fur.mapSize);
  const std::vector<groom::GroomMap::Texel>* maps[] = {&fur.map, &fur.paint, &fur.mask, &fur.shape};
  for (std::size_t i = 0; i < std::size(maps); ++i)
    if (!maps[i]->empty()) (groom_.*groom::kMaps[i]).restore(*maps[i]);
  const groom::GroomSurface at = groomSurface(shape);
  // Vertices that were inserted have what lies between their ends.
  std::vector<Vec3> places = shape.mesh().positions, combs = fur.comb;
  std::vector<float> meshLengths = fur.lengths;
  std::vector<int> meshTypes = fur.types;
  for (const geometry::InsertedVertex& vertex : shape.surface().inserted) {
    places.push_back(vertex.of(places));
    if (!combs.empty()) combs.push_back(vertex.of(combs));
    if (!meshLengths.empty()) meshLengths.push_back(vertex.of(meshLengths));
    if (!meshTypes.empty()) meshTypes.push_back(meshTypes[vertex.t < 0.5f ? vertex.a : vertex.b]);
  }
  const std::vector<std::uint32_t> pointOfMesh = at.points.at(places);
  std::vector<float> lengths(fur.lengths.empty() ? 0 : at.points.count());
  std::vector<int> types(fur.types.empty() ? 0 : at.points.count());
  for (std::size_t i = 0; i < pointOfMesh.size(); ++i) {
    const std::uint32_t point = pointOfMesh[i];
    if (point == groom::SurfacePoints::kNoPoint) continue;
    if (!combs.empty()) groom_.comb[point] = combs[i];
    if (!lengths.empty()) lengths[point] = meshLengths[i];
    if (!types.empty()) types[point] = meshTypes[i];
  }
  isLying_ = combs.empty() || fur.isLying;
  groom_.comb = groom::soundComb(std::move(groom_.comb), at.points);
  groom::paintFromVertices(groom_, at, perVertex(lengths, at), perVertex(types, at));
  groom_.whiskers = fur.whiskers;
  groom::keepSound(groom_.whiskers, shape.query());
  if (groom_.whiskers.size() < fur.whiskers.size()) warnings.push_back("whiskers off the surface are left out");
  touch();
}

std::uint64_t GroomStage::hash(const ShapeStage& shape) {
  needComb(shape);
  Fnv1a hash;
  for (const auto map : groom::kMaps) hash.add((groom_.*map).hash());
  for (const Vec3& comb : groom_.comb) hash.add(comb + 0.0f);  // -0 is 0
  for (const groom::Whisker& whisker : groom_.whiskers) hash.addAll(wordsOf(whisker));
  hash.addAll(groom_.bare);
  return hash.value();
}

// The layout, the maps' size, the number of whiskers and a bit for each map that is there; those, comb, whiskers; and a byte a material.
std::vector<std::uint8_t> GroomStage::save(const ShapeStage& shape) {
  needComb(shape);
  std::uint32_t counts[4] = {groom_.bare.empty() ? kGroomLayout : kMaterialsLayout, static_cast<std::uint32_t>(groom_.map.size()), static_cast<std::uint32_t>(groom_.whiskers.size()), 0};
  for (unsigned i = 0; i < std::size(groom::kMaps); ++i) counts[3] |= (groom_.*groom::kMaps[i]).isPlain() ? 0u : 1u << i;
  std::vector<std::uint8_t> bytes;
  const auto append = [&](const void* from, std::size_t count) {
    const auto* first = static_cast<const std::uint8_t*>(from);
    bytes.insert(bytes.end(), first, first + count);
  };
  append(counts, sizeof counts);
  for (unsigned i = 0; i < std::size(groom::kMaps); ++i)
    if (counts[3] & 1u << i) append((groom_.*groom::kMaps[i]).texels().data(), groom_.map.texels().size() * sizeof(groom::GroomMap::Texel));
  append(groom_.comb.data(), groom_.comb.size() * sizeof(Vec3));
  append(groom_.whiskers.data(), groom_.whiskers.size() * groom::kWhiskerBytes);
  append(groom_.bare.data(), groom_.bare.size());
  return bytes;
}

bool GroomStage::restore(const ShapeStage& shape, std::span<const std::uint8_t> bytes) {
  std::uint32_t counts[4] = {};
  if (bytes.size() >= sizeof counts) std::memcpy(counts, bytes.data(), sizeof counts);
  const std::uint32_t size = counts[1];
  const std::size_t texels = std::size_t{size} * size, mapBytes = texels * sizeof(groom::GroomMap::Texel);
  std::size_t at = sizeof counts, maps = 0;
  for (unsigned i = 0; i < std::size(groom::kMaps); ++i) maps += counts[3] >> i & 1u;
  const std::size_t combAt = at + maps * mapBytes, whiskersAt = combAt + shape.points().count() * sizeof(Vec3);
  const std::size_t bareAt = whiskersAt + counts[2] * groom::kWhiskerBytes, bareBytes = counts[0] == kMaterialsLayout ? groom_.bare.size() : 0;
  const bool sound = (counts[0] == kGroomLayout || bareBytes > 0) && size >= groom::GroomMap::kLeastSize && size <= groom::GroomMap::kMostSize &&
                     counts[2] <= groom::kMostWhiskers && bytes.size() == bareAt + bareBytes;
  if (!sound) return false;
  std::vector<std::uint8_t> bare = bareAtFirst_;
  for (std::size_t i = 0; i < bareBytes; ++i) bare[i] = bytes[bareAt + i] != 0;
  groom_ = groom::plainGroom(static_cast<int>(size), shape.points());
  groom_.bare = std::move(bare);
  for (unsigned i = 0; i < std::size(groom::kMaps); ++i) {
    if (!(counts[3] & 1u << i)) continue;
    std::vector<groom::GroomMap::Texel> map(texels);
    std::memcpy(map.data(), &bytes[at], mapBytes);
    at += mapBytes;
    (groom_.*groom::kMaps[i]).restore(std::move(map));
  }
  std::memcpy(groom_.comb.data(), &bytes[combAt], whiskersAt - combAt);
  groom_.whiskers = groom::readWhiskers(bytes.subspan(whiskersAt, bareAt - whiskersAt));
  if (!groom_.whiskers.empty()) groom::keepSound(groom_.whiskers, shape.query());
  touch();
  return true;
}

}  // namespace fur::app
