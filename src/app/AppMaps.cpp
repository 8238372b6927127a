// The half of App that gives its maps away as pictures and takes them back.
#include "app/AppState.h"
#include "groom/GroomFilters.h"
#include "groom/MapPictures.h"
#include "scene/Png.h"

namespace fur::app {

namespace {

constexpr int kLargeMap = 512;

groom::MapPicture wetnessPicture(const wet::WetnessMask& mask) {
  groom::MapPicture out{"wetness", mask.size(), 1, {}};
  out.pixels.reserve(mask.texels().size());
  for (const Vec4& texel : mask.texels()) out.pixels.push_back(static_cast<std::uint8_t>(saturate(texel.w) * 255 + 0.5f));
  return out;
}

}  // namespace

std::string App::mapsName() const { return state_->modelName.substr(0, state_->modelName.rfind('.')); }

std::vector<scene::NamedFile> App::saveMaps() const {
  State& s = *state_;
  s.refreshGroom();
  std::vector<groom::MapPicture> pictures = groom::mapPictures(s.groom, s.groomSurface());
  pictures.push_back(wetnessPicture(s.mask));
  pictures.push_back(groom::layoutPicture(s.surface, s.groom.map.size() >= kLargeMap ? groom::kLargeLayoutSize : groom::kLayoutSize));
  std::vector<scene::NamedFile> files;
  for (const groom::MapPicture& picture : pictures)
    files.push_back({groom::mapFileName(mapsName(), picture.name), scene::writePng(picture.size, picture.size, picture.channels, picture.pixels)});
  return files;
}

void App::groomFromFile(groom::ImageOf what, std::string_view name, int width, int height, std::span<const std::uint8_t> rgba) {
  const auto map = groom::mapOfFile(name);
  if (!map) return groomFromImage(what, width, height, rgba);
  State& s = *state_;
  s.beginGroomStroke();
  groom::readMapPicture(*map, s.groom, width, height, rgba);
  if (*map != groom::ImageOf::Mask) groom::keepProtected(s.groom, *s.groomBefore, s.groomSurface());
  s.groomTouched();
  s.endGroomStroke();
}

std::optional<Vec3> App::placeAt(Vec2 pixel) const {
  const auto hit = state_->pick(pixel);
  if (!hit) return std::nullopt;
  return positionAt(state_->surface, *hit);
}

}  // namespace fur::app
