#include "app/editor/PanelPictures.h"

#include <algorithm>
#include <utility>

#include "core/NoteChange.h"
#include "geometry/AtlasOutlines.h"

namespace fur::app {

namespace {

gl::Texture pictureTexture(int width, int height, std::span<const std::byte> rgba) {
  gl::TextureShape shape{gl::TexelFormat::RGBA8, width, height};
  shape.filter = gl::Filter::Crisp;
  shape.repeats = true;
  return {shape, rgba};
}

gl::Texture textureOf(const furgen::TilePicture& picture) {
  return pictureTexture(picture.width, picture.height, gl::bytesOf(picture.rgba));
}

ImTextureID idOf(const gl::Texture& texture) {
  return reinterpret_cast<ImTextureID>(static_cast<std::uintptr_t>(texture.id()));
}

}  // namespace

void PanelPictures::refresh(const editor::Editor& editor) {
  refreshCoat(editor.shownTile());
  refreshGroom(editor.showsGroom());
}

void PanelPictures::refreshCoat(const std::optional<editor::TileView>& view) {
  if (!view || app_.coatLayers() == 0) {
    tile_ = {};
    fin_ = {};
    return;
  }
  static_assert(static_cast<int>(editor::TileChannel::Strand) == static_cast<int>(furgen::TileChannel::Strand) &&
                editor::kTileChannels == furgen::kTileChannels);
  const auto channel = static_cast<furgen::TileChannel>(view->channel);
  const std::uint64_t revision = app_.coatRevision();
  const auto stale = [&](const CoatPicture& picture) {
    return !picture.texture.id() || picture.revision != revision || picture.view.channel != view->channel;
  };
  if (stale(fin_)) {
    fin_ = {textureOf(app_.finPicture(channel)), revision, *view};
    ++made_;
  }
  if (stale(tile_) || tile_.view.layer != view->layer) {
    const int layer = std::clamp(view->layer, 0, app_.coatLayers() - 1);
    tile_ = {textureOf(app_.tilePicture(layer, channel)), revision, *view};
    ++made_;
  }
}

// The map for people, while it is on the screen.
void PanelPictures::refreshGroom(bool shown) {
  if (!shown) {
    groom_ = {};
    groomRevision_ = 0;
    return;
  }
  if (groomRevision_ == app_.groomRevision()) return;
  groomRevision_ = app_.groomRevision();
  groomCoverage_ = app_.groomCoverage();
  if (noteChange(outlinesOf_, app_.surfaceRevision())) groomOutlines_ = geometry::atlasOutlines(app_.surface());
  groom_ = pictureTexture(app_.groomMap().size(), app_.groomMap().size(), gl::bytesOf(groom::picture(app_.groom())));
  ++made_;
}

void PanelPictures::showVersions() {
  using editor::kVersionPictureWidth, editor::kVersionPictureHeight;
  constexpr std::size_t kBytes = std::size_t{4} * kVersionPictureWidth * kVersionPictureHeight;
  versionViews_.clear();
  versionPictures_.clear();
  for (const KeptVersion& version : versions_) {
    editor::VersionView view{version.id, version.name, version.when};
    if (version.rgba.size() == kBytes) {
      versionPictures_.push_back(pictureTexture(kVersionPictureWidth, kVersionPictureHeight, gl::bytesOf(version.rgba)));
      view.picture = idOf(versionPictures_.back());
    }
    versionViews_.push_back(std::move(view));
  }
  ++made_;
}

void PanelPictures::describe(editor::EditorModel& model) const {
  model.coat.tile = idOf(tile_.texture);
  model.coat.fin = idOf(fin_.texture);
  model.coat.tileSize = tile_.texture.id() ? tile_.texture.shape().width : 0;
  model.groom.bald = groomCoverage_.bald;
  model.groom.length = groomCoverage_.length;
  std::copy_n(groomCoverage_.types, groom::kTypes, model.groom.types);
  model.groom.map = idOf(groom_);
  model.groom.outlines = groomOutlines_;
  model.versions = versionViews_;
}

void PanelPictures::release() {
  tile_ = {};
  fin_ = {};
  groom_ = {};
  groomRevision_ = 0;
  versionPictures_.clear();
}

}  // namespace fur::app
