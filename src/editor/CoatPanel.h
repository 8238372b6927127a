// The section "Coat" of the panel: presets and coats of one's own, seed, and what the generator makes of the settings: the tile
// layer by layer, its strands from the side, and how much of each layer they cover.
#pragma once

#include <optional>
#include <vector>

#include "editor/EditorModel.h"
#include "editor/KeptRows.h"

namespace fur::editor {

class CoatPanel {
 public:
  struct Manner {
    bool tooltips = true;  // there is a mouse: it hovers, and a finger's scroll need not be left alone
    bool roomy = true;     // the pictures are open until the person closes them
  };

  // Draws the section into the current window. A new seed goes into `edited`, everything else is a command.
  std::vector<Command> draw(const EditorModel& model, settings::Settings& edited, const Manner& manner);

  // The panel is closed: nothing of this is on the screen.
  void hide() { shown_.reset(); }

  // The fur type, 0 to 3, that it and the rows of settings edit.
  int type() const { return type_; }

  // What it shows; none while the pictures are closed.
  std::optional<TileView> shownTile() const { return shown_; }

 private:
  void drawPresets(const EditorModel& model, settings::Settings& edited, bool tooltips, std::vector<Command>& commands);
  void drawOwnCoats(const EditorModel& model, std::vector<Command>& commands);
  void drawType(const EditorModel& model, settings::Settings& edited, bool tooltips);
  void countTime(const CoatView& coat);
  void drawStrands(const EditorModel& model);
  void drawPictures(const CoatView& coat, const Manner& manner);
  void drawChannels();
  int layerOf(int layers) const;
  void setLayer(int layer, int layers);

  std::optional<TileView> shown_;
  TileChannel channel_ = TileChannel::Coverage;
  float height_ = 0.5f;  // of the layer, 0 skin to 1 tip: keeps its place when the number of layers changes
  bool repeated_ = false;
  int type_ = 0;
  NewName newName_;
  KeptRows ownRows_;
  float growingFor_ = 0;        // seconds that the coat on its way has taken
  std::uint64_t revision_ = 0;  // of the coat before it
};

}  // namespace fur::editor
