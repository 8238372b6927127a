// What programs do with the groom.
#include <cmath>

#include "app/AppState.h"
#include "core/Json.h"
#include "core/NumberText.h"
#include "groom/MapPictures.h"
#include "scene/Png.h"

namespace fur::app {

namespace {

// From this size of the maps on the picture of the layout is larger.
constexpr int kLargeMap = 512;

groom::MapPicture wetnessPicture(const wet::WetnessMask& mask) {
  groom::MapPicture out{"wetness", mask.size(), 1, {}};
  out.pixels.reserve(mask.texels().size());
  for (const Vec4& texel : mask.texels()) out.pixels.push_back(static_cast<std::uint8_t>(saturate(texel.w) * 255 + 0.5f));
  return out;
}

}  // namespace

void App::State::beginGroomStroke() {
  endStroke();
  groom.beginStroke(shape);
}

void App::groomAll(GroomEdit edit, float value, const Vec3& direction, std::optional<std::uint32_t> color) {
  State& s = *state_;
  if (!std::isfinite(value) || !std::isfinite(direction.x + direction.y + direction.z)) return;
  settings::Settings with = s.settings;
  if (color) with.paintColor = *color;
  s.beginGroomStroke();
  s.groom.edit(s.shape, edit, value, direction, with, s.warnings);
  s.endStroke();
}

// Not by groomAll(): programs that only clear are spared all other edits.
void App::clearGroom() {
  State& s = *state_;
  s.beginGroomStroke();
  s.groom.clear(s.shape);
  s.endStroke();
}

void App::groomFromImage(groom::ImageOf what, int width, int height, std::span<const std::uint8_t> rgba) {
  groomFromFile(what, "", width, height, rgba);
}

void App::groomFromFile(groom::ImageOf what, std::string_view name, int width, int height, std::span<const std::uint8_t> rgba) {
  State& s = *state_;
  s.beginGroomStroke();
  s.groom.readImage(s.shape, what, name, width, height, rgba);
  s.endStroke();
}

Status App::usePicture(PictureUse use, std::string_view name, int width, int height, std::span<const std::uint8_t> rgba, std::vector<std::uint8_t> file) {
  State& s = *state_;
  if (groom::mapOfFile(name)) return groomFromFile(groom::ImageOf::Length, name, width, height, rgba), Done{};
  if (use == PictureUse::TypeColor || use == PictureUse::Skin) {
    if (file.empty()) file = scene::writePng(width, height, 4, rgba);
    return setTypePicture(use == PictureUse::Skin ? settings::kSkin : s.settings.groomType, std::move(file), width, height, {rgba.begin(), rgba.end()});
  }
  s.beginGroomStroke();
  s.groom.usePicture(s.shape, s.settings, use, width, height, rgba, s.warnings);
  s.endStroke();
  return Done{};
}

groom::Coverage App::groomCoverage() const {
  // A plain one needs no atlas.
  State& s = *state_;
  const groom::GroomMap& map = s.groom.groom().map;
  return map.isPlain() ? groom::Coverage{} : groom::coverage(map, s.groom.groomSurface(s.shape).atlas);
}

std::uint64_t App::groomRevision() const { return state_->groom.revision(); }
bool App::groomed() const { return !state_->groom.isPlain(); }
std::size_t App::whiskerCount() const { return state_->groom.groom().whiskers.size(); }
const groom::GroomMap& App::groomMap() const { return state_->groom.groom().map; }
const groom::Groom& App::groom() const { return state_->groom.groom(); }
std::uint64_t App::groomHash() const { return state_->groom.hash(state_->shape); }

std::vector<std::uint8_t> App::saveGroom() const { return state_->groom.save(state_->shape); }

Status App::restoreGroom(std::span<const std::uint8_t> bytes, bool undoable) {
  State& s = *state_;
  s.endStroke();
  if (undoable) s.groom.beginStroke(s.shape);
  const bool restored = s.groom.restore(s.shape, bytes);
  s.endStroke();
  if (restored) return Done{};
  return Error{ErrorId::BadFile, "a groom of " + decimal(bytes.size()) + " bytes is not of this model"};
}

// --- materials ---

std::string App::materials() const {
  const State& s = *state_;
  std::string out;
  for (std::size_t i = 0; i < s.document.materials.size(); ++i) {
    const scene::Material& material = s.document.materials[i];
    out += (out.empty() ? "[" : ",") + std::string("{\"name\":") + jsonString(material.name) + ",\"triangles\":" + decimal(material.triangles) +
           ",\"furry\":" + (s.groom.isBare(i) ? "false" : "true") + "}";
  }
  return out + "]";
}

int App::materialCount() const { return static_cast<int>(state_->document.materials.size()); }
const std::string& App::materialName(int material) const { return state_->document.materials[static_cast<std::size_t>(material)].name; }
bool App::isFurry(int material) const { return !state_->groom.isBare(static_cast<std::size_t>(material)); }

Status App::setFurry(int material, bool furry) {
  State& s = *state_;
  const std::size_t count = s.groom.groom().bare.size();
  if (material < 0 || static_cast<std::size_t>(material) >= count)
    return Error{ErrorId::BadFile, "material " + decimal(material) + ": fur can be chosen for " + decimal(count) + " materials of this model"};
  s.beginGroomStroke();
  s.groom.setBare(static_cast<std::size_t>(material), !furry);
  s.endStroke();
  return Done{};
}

int App::materialAt(Vec2 pixel) const {
  const auto hit = state_->pick(pixel);
  return hit ? static_cast<int>(state_->shape.materialAt(hit->triangle)) : -1;
}

std::string App::mapsName() const { return modelName().substr(0, modelName().rfind('.')); }

std::vector<scene::NamedFile> App::saveMaps() const {
  State& s = *state_;
  const groom::Groom& groom = s.groom.groom();
  std::vector<groom::MapPicture> pictures = groom::mapPictures(groom, s.groom.groomSurface(s.shape));
  pictures.push_back(wetnessPicture(s.water.mask()));
  pictures.push_back(groom::layoutPicture(s.shape.surface(), groom.map.size() >= kLargeMap ? groom::kLargeLayoutSize : groom::kLayoutSize));
  std::vector<scene::NamedFile> files;
  for (const groom::MapPicture& picture : pictures)
    files.push_back({groom::mapFileName(mapsName(), picture.name), scene::writePng(picture.size, picture.size, picture.channels, picture.pixels)});
  return files;
}

}  // namespace fur::app
