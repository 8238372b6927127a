// The half of App that saves, and takes a groom over.
#include <algorithm>
#include <cmath>
#include <cstring>

#include "app/AppState.h"
#include "core/Srgb.h"
#include "scene/FoModel.h"
#include "scene/Png.h"

namespace fur::app {

namespace {

// Texels along the picture of what is painted.
constexpr int kPaintedSize = 512, kPaintedPictureSize = 1024;

// Those of some vertices; none stay none.
template <class T>
std::vector<T> ofVertices(const std::vector<T>& values, const std::vector<std::uint32_t>& vertices) {
  std::vector<T> out;
  for (std::size_t i = 0; !values.empty() && i < vertices.size(); ++i) out.push_back(values[vertices[i]]);
  return out;
}

// Half-way up a strand; linear.
Vec3 coatColor(const settings::Settings& settings) {
  return 0.35f * linearColor(settings.rootColor) + 0.65f * linearColor(settings.tipColor);
}

std::uint8_t toByte(float share) { return static_cast<std::uint8_t>(saturate(share) * 255 + 0.5f); }

}  // namespace

// The texel of the model's picture, 0..1; white where there is none.
Vec3 App::State::pictureAt(const geometry::SurfacePoint& at) const {
  if (image.empty()) return Vec3(1);
  Vec2 uv(0);
  for (int k = 0; k < 3; ++k)
    uv += at.weights[k] * surface.vertices[surface.indices[std::size_t{3} * at.triangle + static_cast<std::size_t>(k)]].uv;
  const auto along = [](float c, int size) { return std::min(static_cast<int>((c - std::floor(c)) * static_cast<float>(size)), size - 1); };
  const std::uint8_t* texel = &image[4 * static_cast<std::size_t>(along(uv.y, imageHeight) * imageWidth + along(uv.x, imageWidth))];
  return Vec3(texel[0], texel[1], texel[2]) / 255.0f;
}

std::optional<std::uint32_t> App::colorAt(Vec2 pixel) const {
  const State& s = *state_;
  const auto hit = state_->pick(pixel);
  if (!hit) return std::nullopt;
  // As the shaders have it.
  const Vec3 coat = coatColor(s.settings) * Vec3(s.baseColorFactor) * glm::mix(Vec3(1), s.pictureAt(*hit), s.settings.textureAmount);
  const Vec4 paint = s.groom.paint.at(atlasAt(s.surface, *hit));
  const Vec3 color = glm::mix(encodeSrgb(coat), Vec3(paint), paint.w);
  std::uint32_t rgb = 0;
  for (int k = 0; k < 3; ++k) rgb = rgb << 8 | toByte(color[k]);
  return rgb;
}

// What programs without fur show of a painted model: a PNG over the atlas, or nothing.
std::vector<std::uint8_t> App::State::paintedPicture() const {
  if (groom.paint.isPlain()) return {};
  const int size = image.empty() ? kPaintedSize : kPaintedPictureSize;
  const geometry::AtlasTexels atlas(surface, size);
  // A model's own picture as others show it; without one the coat's colour.
  const Vec3 coat = encodeSrgb((image.empty() ? coatColor(settings) : Vec3(1)) * Vec3(baseColorFactor));
  std::vector<std::uint8_t> pixels(std::size_t{3} * static_cast<std::size_t>(size) * static_cast<std::size_t>(size));
  for (std::size_t i = 0; i < pixels.size(); ++i) pixels[i] = toByte(coat[static_cast<int>(i % 3)]);
  for (std::uint32_t t = 0; t < surface.triangleCount(); ++t)
    atlas.forTexelsOf(surface, t, [&](std::uint32_t texel, const Vec3& weights) {
      const geometry::SurfacePoint point{t, weights, 0};
      const Vec4 paint = groom.paint.at(atlasAt(surface, point));
      const Vec3 color = glm::mix(coat * pictureAt(point), Vec3(paint), paint.w);
      for (int k = 0; k < 3; ++k) pixels[std::size_t{3} * texel + static_cast<std::size_t>(k)] = toByte(color[k]);
    });
  for (const auto& [texel, source] : atlas.gutter()) std::copy_n(&pixels[std::size_t{3} * source], 3, &pixels[std::size_t{3} * texel]);
  return scene::writePng(size, size, 3, pixels);
}

std::vector<std::uint8_t> App::saveFo() const {
  State& s = *state_;
  std::vector<int> types;
  std::vector<float> lengths;
  for (const auto& vertex : s.surface.vertices) {
    if (!s.groomed) break;
    lengths.push_back(s.groom.map.lengthAt(vertex.atlas));
    types.push_back(s.groom.map.typeAt(vertex.atlas) - 1);
  }
  if (!s.surface.turned) return scene::writeFo(scene::foFromSurface(s.surface, s.settings.repeat, lengths, types));
  const geometry::OwnSurface own = geometry::ownSurface(s.surface, s.mesh);
  return scene::writeFo(scene::foFromSurface(own.surface, s.settings.repeat, ofVertices(lengths, own.vertexOf), ofVertices(types, own.vertexOf)));
}

Warnings App::lostBySaving() const {
  const State& s = *state_;
  Warnings lost = s.lostOfFile;
  if (s.given) lost.push_back("the coat that was read from a .fts file");
  return lost;
}

std::vector<std::uint8_t> App::saveScene() const {
  State& s = *state_;
  s.refreshGroom();
  const geometry::OwnSurface own = geometry::ownSurface(s.surface, s.mesh);
  geometry::Mesh mesh;
  mesh.indices = own.surface.indices;
  for (const geometry::SurfaceVertex& v : own.surface.vertices) {
    mesh.positions.push_back(v.position);
    mesh.normals.push_back(v.normal);
    if (!s.mesh.uv.empty()) mesh.uv.push_back(v.uv);
    mesh.atlas.push_back(v.atlas);
    if (!s.mesh.furUv.empty()) mesh.furUv.push_back(v.fur);
  }
  scene::FurData fur;
  fur.state = state();
  fur.mapSize = s.groom.map.size();
  if (!s.groom.map.isPlain()) fur.map = s.groom.map.texels();
  if (!s.groom.paint.isPlain()) fur.paint = s.groom.paint.texels();
  if (!s.groom.shape.isPlain()) fur.shape = s.groom.shape.texels();
  if (!s.groom.mask.isPlain()) fur.mask = s.groom.mask.texels();
  if (!s.upright()) {
    fur.comb = ofVertices(groom::restBends(s.groom, s.surface, s.groomSurface().points), own.vertexOf);
  }
  fur.whiskers = s.groom.whiskers;
  fur.wetnessSize = s.mask.size();
  if (!s.mask.isDry()) fur.wetness = s.mask.texels();
  return scene::exportScene(mesh, s.modelName, fur, {s.sourceImage.bytes.empty() ? s.pendingImage : s.sourceImage, s.baseColorFactor, s.paintedPicture()});
}

// The layout, the maps' size, the number of whiskers and a bit for each map that is there; those, comb, whiskers.
std::vector<std::uint8_t> App::saveGroom() const {
  State& s = *state_;
  s.groomSurface();
  std::uint32_t counts[4] = {kSavedLayout, static_cast<std::uint32_t>(s.groom.map.size()), static_cast<std::uint32_t>(s.groom.whiskers.size()), 0};
  for (unsigned i = 0; i < std::size(groom::kMaps); ++i) counts[3] |= (s.groom.*groom::kMaps[i]).isPlain() ? 0u : 1u << i;
  std::vector<std::uint8_t> bytes;
  const auto append = [&](const void* from, std::size_t count) {
    const auto* first = static_cast<const std::uint8_t*>(from);
    bytes.insert(bytes.end(), first, first + count);
  };
  append(counts, sizeof counts);
  for (unsigned i = 0; i < std::size(groom::kMaps); ++i)
    if (counts[3] & 1u << i) append((s.groom.*groom::kMaps[i]).texels().data(), s.groom.map.texels().size() * sizeof(groom::GroomMap::Texel));
  append(s.groom.comb.data(), s.groom.comb.size() * sizeof(Vec3));
  append(s.groom.whiskers.data(), s.groom.whiskers.size() * groom::kWhiskerBytes);
  return bytes;
}

Status App::restoreGroom(std::span<const std::uint8_t> bytes, bool undoable) {
  State& s = *state_;
  const groom::GroomSurface skin = s.groomSurface();
  std::uint32_t counts[4] = {};
  if (bytes.size() >= sizeof counts) std::memcpy(counts, bytes.data(), sizeof counts);
  const std::uint32_t size = counts[1];
  const std::size_t texels = std::size_t{size} * size, mapBytes = texels * sizeof(groom::GroomMap::Texel);
  std::size_t at = sizeof counts, maps = 0;
  for (unsigned i = 0; i < std::size(groom::kMaps); ++i) maps += counts[3] >> i & 1u;
  const std::size_t combAt = at + maps * mapBytes, whiskersAt = combAt + skin.points.count() * sizeof(Vec3);
  const bool sound = counts[0] == kSavedLayout && size >= groom::GroomMap::kLeastSize && size <= groom::GroomMap::kMostSize &&
                     counts[2] <= groom::kMostWhiskers && bytes.size() == whiskersAt + counts[2] * groom::kWhiskerBytes;
  if (!sound) return Error{ErrorId::BadFile, "a groom of " + std::to_string(bytes.size()) + " bytes is not of this model"};
  if (undoable) s.beginGroomStroke();
  s.groom = groom::plainGroom(static_cast<int>(size), skin.points);
  for (unsigned i = 0; i < std::size(groom::kMaps); ++i) {
    if (!(counts[3] & 1u << i)) continue;
    std::vector<groom::GroomMap::Texel> map(texels);
    std::memcpy(map.data(), &bytes[at], mapBytes);
    at += mapBytes;
    (s.groom.*groom::kMaps[i]).restore(std::move(map));
  }
  std::memcpy(s.groom.comb.data(), &bytes[combAt], whiskersAt - combAt);
  s.groom.whiskers = groom::readWhiskers(bytes.subspan(whiskersAt));
  groom::keepSound(s.groom.whiskers, s.query);
  s.groomTouched();
  s.endGroomStroke();
  return Done{};
}

}  // namespace fur::app
