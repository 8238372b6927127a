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
  const Document::Picture* picture = document.pictureOf(shape.materialAt(at.triangle));
  if (!picture) return Vec3(1);
  const geometry::Surface& surface = shape.surface();
  Vec2 uv(0);
  for (int k = 0; k < 3; ++k)
    uv += at.weights[k] * surface.vertices[surface.indices[std::size_t{3} * at.triangle + static_cast<std::size_t>(k)]].uv;
  const scene::MaterialTexture& texture = document.materials[shape.materialAt(at.triangle)].baseColorTexture;
  const auto along = [](float c, int size, int wrap) {
    const float twice = c * 0.5f - std::floor(c * 0.5f), part = wrap == scene::kWrapClamp ? saturate(c) : wrap == scene::kWrapMirror ? 1 - std::abs(2 * twice - 1) : c - std::floor(c);
    return std::min(static_cast<int>(part * static_cast<float>(size)), size - 1);
  };
  const int column = along(uv.x, picture->width, texture.wrapS), row = along(uv.y, picture->height, texture.wrapT);
  const std::uint8_t* texel = &(*picture->rgba)[4 * static_cast<std::size_t>(row * picture->width + column)];
  return Vec3(texel[0], texel[1], texel[2]) / 255.0f;
}

std::optional<std::uint32_t> App::colorAt(Vec2 pixel) const {
  const State& s = *state_;
  const auto hit = state_->pick(pixel);
  if (!hit) return std::nullopt;
  // As the shaders have it.
  const Vec3 coat = coatColor(s.settings) * Vec3(s.document.materials[s.shape.materialAt(hit->triangle)].baseColor) * glm::mix(Vec3(1), s.pictureAt(*hit), s.settings.textureAmount);
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
  const bool plain = document.pictureOf(document.main) == nullptr;
  const int size = plain ? kPaintedSize : kPaintedPictureSize;
  const geometry::AtlasTexels atlas(surface, size);
  // A model's own picture as others show it; without one the coat's colour.
  const Vec3 coat = encodeSrgb((plain ? coatColor(settings) : Vec3(1)) * Vec3(document.materials[document.main].baseColor));
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
  const unsigned grown = s.groom.types();
  const float longest = settings::coatLength(s.settings, grown);
  scene::FoFur fur;
  for (const auto& vertex : surface.vertices) {
    const bool bare = !s.shape.materialOf().empty() && s.groom.isBare(s.shape.materialOf()[static_cast<std::size_t>(&vertex - surface.vertices.data())]);
    const int type = map.typeAt(vertex.atlas) - 1;
    fur.lengths.push_back(bare ? 0 : map.lengthAt(vertex.atlas) * longest * settings::typeHeight(s.settings, type, longest));
    // Its fourth type is bald: what grows as that here has the third one there.
    fur.types.push_back(fur.lengths.back() <= 0 ? scene::kFoBald : std::min(type + 1, scene::kFoBald - 1));
  }
  fur.bends = s.groom.rests();
  if (!surface.turned) return scene::writeFo(scene::foFromSurface(surface, s.settings.repeat, fur));
  const geometry::OwnSurface own = geometry::ownSurface(s.shape.surface(), s.shape.mesh());
  return scene::writeFo(scene::foFromSurface(own.surface, s.settings.repeat,
                                             {ofVertices(fur.lengths, own.vertexOf), ofVertices(fur.types, own.vertexOf), ofVertices(fur.bends, own.vertexOf)}));
}

namespace {
const scene::DocumentKeeping* keeping = nullptr;
}
void App::keepDocuments(const scene::DocumentKeeping* with) { keeping = with; }

void App::State::keepFile(Document& from, std::span<const std::uint8_t> bytes, const scene::FileSet& others) const {
  if (keeping) from.file = keeping->keep(bytes, from.name, others);
  if (from.file) from.beside = keeping->beside(*from.file);
}

Warnings App::lostBySaving() const { return state_->document.beside; }

// All but the comb, which is for the vertices that are written.
scene::FurData App::State::furData() const {
  const groom::Groom& from = groom.groom();
  scene::FurData fur;
  fur.mapSize = from.map.size();
  if (!from.map.isPlain()) fur.map = from.map.texels();
  if (!from.paint.isPlain()) fur.paint = from.paint.texels();
  if (!from.shape.isPlain()) fur.shape = from.shape.texels();
  if (!from.mask.isPlain()) fur.mask = from.mask.texels();
  fur.isLying = groom.isLying();
  fur.whiskers = from.whiskers;
  fur.hair = hair->style();
  hair->addWetness(fur.hair);
  for (hair::Body& body : fur.hair.bodies) body.bone = body.bone < 0 || !document.file ? -1 : static_cast<int>(shape.rig().nodes[static_cast<std::size_t>(body.bone)].source);
  fur.wetnessSize = water.mask().size();
  if (!water.mask().isDry()) fur.wetness = water.mask().texels();
  if (water.isWet()) fur.water = water.save(true);
  fur.coats = shelf.filesOf(settings);
  fur.hasBare = !from.bare.empty();
  for (std::size_t i = 0; i < from.bare.size(); ++i)
    if (from.bare[i]) fur.bare.push_back(document.materials[i].source);
  return fur;
}

// One a vertex of the mesh.
std::vector<Vec3> App::State::combOfMesh() const {
  const groom::SurfacePoints& points = shape.points();
  std::vector<Vec3> comb(shape.mesh().positions.size(), Vec3(0));
  const std::vector<geometry::SurfaceVertex>& vertices = shape.surface().vertices;
  for (std::size_t i = 0; i < vertices.size(); ++i)
    if (vertices[i].source < comb.size()) comb[vertices[i].source] = groom.groom().comb[points.pointOf[i]];
  return comb;
}

std::vector<std::uint8_t> App::State::saveMesh(scene::FurData fur) const {
  const geometry::OwnSurface own = geometry::ownSurface(shape.surface(), shape.mesh());
  geometry::Mesh mesh;
  mesh.indices = own.surface.indices;
  for (const geometry::SurfaceVertex& v : own.surface.vertices) {
    mesh.positions.push_back(v.position);
    mesh.normals.push_back(v.normal);
    if (!shape.mesh().uv.empty()) mesh.uv.push_back(v.uv);
    mesh.atlas.push_back(v.atlas);
    if (!shape.mesh().furUv.empty()) mesh.furUv.push_back(v.fur);
  }
  if (groom.isCombed()) fur.comb = ofVertices(groom::restBends(groom.groom(), shape.surface(), shape.points()), own.vertexOf);
  const scene::Material& main = document.materials[document.main];
  const int image = main.baseColorTexture.image;
  static const scene::EncodedImage none;
  return scene::exportScene(mesh, document.name, fur, {image < 0 ? none : document.pictures[static_cast<std::size_t>(image)].encoded, main.baseColor, paintedPicture()});
}

std::vector<std::uint8_t> App::saveScene() const {
  const State& s = *state_;
  scene::FurData fur = s.furData();
  fur.state = state();
  if (!s.document.file) return s.saveMesh(std::move(fur));
  if (s.groom.isCombed()) fur.comb = s.combOfMesh();
  return keeping->write(*s.document.file, scene::furSurface(s.shape.surface(), s.shape.mesh()), fur);
}

}  // namespace fur::app
