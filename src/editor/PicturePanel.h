// The section "Picture" of the panel: a picture of any size, and the camera going once round the model, live or as a film.
#pragma once

#include <vector>

#include "editor/EditorModel.h"

namespace fur::editor {

class PicturePanel {
 public:
  // Draws the section into the current window. While a picture is drawn it offers only to stop that.
  std::vector<Command> draw(const EditorModel& model, bool tooltips);

 private:
  enum class Size { AsSeen, FullHd, UltraHd, Square, Own };

  void drawSize(const PictureView& view);
  void drawPicture(const PictureView& view);
  void drawTurntable(const EditorModel& model);
  void drawProgress(const PictureView& view);
  bool usable(const PictureView& view) const;
  void hint(const char* text) const;

  std::vector<Command> commands_;
  Size size_ = Size::AsSeen;
  int width_ = 1920, height_ = 1080;
  bool transparent_ = false, tooltips_ = false;
  float secondsPerTurn_ = 12;
  bool leftwards_ = false;
};

}  // namespace fur::editor
