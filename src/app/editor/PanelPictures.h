// The pictures that the panel shows of an App: layers of the coat, the groom's map, versions of the scene. They are on the
// graphics processor, and made anew when what they show has changed and somebody looks.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/App.h"
#include "editor/Editor.h"
#include "gl/Objects.h"

namespace fur::app {

// A scene that was kept under a name.
struct KeptVersion {
  std::string id, name, when;
  std::vector<std::uint8_t> rgba;  // editor::kVersionPictureWidth x kVersionPictureHeight; or none
};

class PanelPictures {
 public:
  explicit PanelPictures(const App& app) : app_(app) {}

  // Before the frame that shows them: the frame before may still be drawn with the old ones.
  void refresh(const editor::Editor& editor);
  // Newest first; in place of those before. Without a context they come with the next showVersions().
  void setVersions(std::vector<KeptVersion> versions) { versions_ = std::move(versions); }
  void showVersions();
  // What they are of goes into the model that the panel is given.
  void describe(editor::EditorModel& model) const;
  // Forgets what is in the context.
  void release();
  // Another number whenever one was made.
  std::uint64_t revision() const { return made_; }

 private:
  // A picture of the coat, and what it shows.
  struct CoatPicture {
    gl::Texture texture;
    std::uint64_t revision = 0;  // of the coat
    editor::TileView view;
  };

  void refreshCoat(const std::optional<editor::TileView>& view);
  void refreshGroom(bool shown);

  const App& app_;
  CoatPicture tile_, fin_;
  gl::Texture groom_;
  std::uint64_t groomRevision_ = 0;  // of that and the coverage; 0: none
  groom::Coverage groomCoverage_;
  std::vector<Vec4> groomOutlines_;
  std::uint64_t outlinesOf_ = 0;  // the app's surfaceRevision()
  std::vector<KeptVersion> versions_;
  std::vector<editor::VersionView> versionViews_;
  std::vector<gl::Texture> versionPictures_;
  std::uint64_t made_ = 0;
};

}  // namespace fur::app
