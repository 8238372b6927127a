// What programs save of a model.
#include <algorithm>
#include <cmath>

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
  if (document.image.empty()) return Vec3(1);
  const geometry::Surface& surface = shape.surface();
  Vec2 uv(0);
  for (int k = 0; k < 3; ++k)
    uv += at.weights[k] * surface.vertices[surface.indices[std::size_t{3} * at.triangle + static_cast<std::size_t>(k)]].uv;
  const auto along = [](float c, int size) { return std::min(static_cast<int>((c - std::floor(c)) * static_cast<float>(size)), size - 1); };
  const std::uint8_t* texel = &document.image[4 * static_cast<std::size_t>(along(uv.y, document.imageHeight) * document.imageWidth + along(uv.x, document.imageWidth))];
  return Vec3(texel[0], texel[1], texel[2]) / 255.0f;
}

std::optional<std::uint32_t> App::colorAt(Vec2 pixel) const {
  const State& s = *state_;
  const auto hit = state_->pick(pixel);
  if (!hit) return std::nullopt;
  // As the shaders have it.
  const Vec3 coat = coatColor(s.settings) * Vec3(s.document.baseColorFactor) * glm::mix(Vec3(1), s.pictureAt(*hit), s.settings.textureAmount);
  const Vec4 paint = s.groom.groom().paint.at(atlasAt(s.shape.surface(), *hit));
  const Vec3 color = glm::mix(encodeSrgb(coat), Vec3(paint), paint.w);
  std::uint32_t rgb = 0;
  for (int k = 0; k < 3; ++k) rgb = rgb << 8 | toByte(color[k]);
  return rgb;
}

// What programs without fur show of a painted model: a PNG over the atlas, or nothing.
std::vector<std::uint8_t> App::State::paintedPicture() const {
  const groom::GroomMap& painted = groom.groom().paint;
  if (painted.isPlain()) return {};
  const geometry::Surface& surface = shape.surface();
  const int size = document.image.empty() ? kPaintedSize : kPaintedPictureSize;
  const geometry::AtlasTexels atlas(surface, size);
  // A model's own picture as others show it; without one the coat's colour.
  const Vec3 coat = encodeSrgb((document.image.empty() ? coatColor(settings) : Vec3(1)) * Vec3(document.baseColorFactor));
  std::vector<std::uint8_t> pixels(std::size_t{3} * static_cast<std::size_t>(size) * static_cast<std::size_t>(size));
  for (std::size_t i = 0; i < pixels.size(); ++i) pixels[i] = toByte(coat[static_cast<int>(i % 3)]);
  for (std::uint32_t t = 0; t < surface.triangleCount(); ++t)
    atlas.forTexelsOf(surface, t, [&](std::uint32_t texel, const Vec3& weights) {
      const geometry::SurfacePoint point{t, weights, 0};
      const Vec4 paint = painted.at(atlasAt(surface, point));
      const Vec3 color = glm::mix(coat * pictureAt(point), Vec3(paint), paint.w);
      for (int k = 0; k < 3; ++k) pixels[std::size_t{3} * texel + static_cast<std::size_t>(k)] = toByte(color[k]);
    });
  for (const auto& [texel, source] : atlas.gutter()) std::copy_n(&pixels[std::size_t{3} * source], 3, &pixels[std::size_t{3} * texel]);
  return scene::writePng(size, size, 3, pixels);
}

std::vector<std::uint8_t> App::saveFo() const {
  const State& s = *state_;
  const geometry::Surface& surface = s.shape.surface();
  const groom::GroomMap& map = s.groom.groom().map;
  std::vector<int> types;
  std::vector<float> lengths;
  const bool plain = map.isPlain();
  for (const auto& vertex : surface.vertices) {
    if (plain) break;
    lengths.push_back(map.lengthAt(vertex.atlas));
    types.push_back(map.typeAt(vertex.atlas) - 1);
  }
  if (!surface.turned) return scene::writeFo(scene::foFromSurface(surface, s.settings.repeat, lengths, types));
  const geometry::OwnSurface own = geometry::ownSurface(s.shape.surface(), s.shape.mesh());
  return scene::writeFo(scene::foFromSurface(own.surface, s.settings.repeat, ofVertices(lengths, own.vertexOf), ofVertices(types, own.vertexOf)));
}

Warnings App::lostBySaving() const {
  const State& s = *state_;
  Warnings lost = s.document.lostOfFile;
  if (coatGiven()) lost.push_back("the coat that was read from a .fts file");
  return lost;
}

std::vector<std::uint8_t> App::saveScene() const {
  State& s = *state_;
  const groom::Groom& groom = s.groom.groom();
  const geometry::OwnSurface own = geometry::ownSurface(s.shape.surface(), s.shape.mesh());
  geometry::Mesh mesh;
  mesh.indices = own.surface.indices;
  for (const geometry::SurfaceVertex& v : own.surface.vertices) {
    mesh.positions.push_back(v.position);
    mesh.normals.push_back(v.normal);
    if (!s.shape.mesh().uv.empty()) mesh.uv.push_back(v.uv);
    mesh.atlas.push_back(v.atlas);
    if (!s.shape.mesh().furUv.empty()) mesh.furUv.push_back(v.fur);
  }
  scene::FurData fur;
  fur.state = state();
  fur.mapSize = groom.map.size();
  if (!groom.map.isPlain()) fur.map = groom.map.texels();
  if (!groom.paint.isPlain()) fur.paint = groom.paint.texels();
  if (!groom.shape.isPlain()) fur.shape = groom.shape.texels();
  if (!groom.mask.isPlain()) fur.mask = groom.mask.texels();
  if (!s.groom.upright()) {
    fur.comb = ofVertices(groom::restBends(groom, s.shape.surface(), s.shape.points()), own.vertexOf);
  }
  fur.whiskers = groom.whiskers;
  fur.hair = s.hair->style();
  s.hair->addWetness(fur.hair);
  fur.wetnessSize = s.water.mask().size();
  if (!s.water.mask().isDry()) fur.wetness = s.water.mask().texels();
  return scene::exportScene(mesh, s.document.name, fur, {s.document.sourceImage.bytes.empty() ? s.document.pendingImage : s.document.sourceImage, s.document.baseColorFactor, s.paintedPicture()});
}

}  // namespace fur::app
