// The editor's panel. Pure Dear ImGui: it draws between ImGui::NewFrame() and ImGui::Render() of
// the current context, never calls gl and never changes the program: see EditorModel.h.
// Wide screens: a column at the right. Below 600 CSS pixels: a sheet at the bottom, closed to its title at
// first, so that the model stays in sight. A person makes either larger or smaller: see PanelLayout.h.
// What the program tells (water, messages, statistics) moves no row; only what a person opens does.
#pragma once

#include <optional>
#include <string_view>
#include <vector>

#include <imgui.h>

#include "core/Math.h"
#include "editor/CoatPanel.h"
#include "editor/EditorModel.h"
#include "editor/Frequent.h"
#include "editor/GroomPanel.h"
#include "editor/HairPanel.h"
#include "editor/InputQueue.h"
#include "editor/PanelLayout.h"
#include "editor/PicturePanel.h"
#include "editor/Theme.h"
#include "editor/VersionsPanel.h"

namespace fur::editor {

class Editor {
 public:
  // Draws the panel; returns what the person asked for since the last frame. A held slider gives
  // BeginChange, one SetSettings per frame in which it moved, and EndChange when it is let go.
  std::vector<Command> frame(const EditorModel& model, const ThemeScale& scale);

  // What the panel hides of the screen, from the right edge and from the bottom edge, as shares of its
  // width and height. Closed to its title it counts as nothing.
  Vec2 covered() const { return layout_.covered(); }

  // The sizes that the person gave the panel, to be kept for the next time: see PanelLayout::text().
  // Behind them what stands in "Frequently used".
  std::string layout() const;
  void setLayout(std::string_view text);

  // The pictures of the tile that the panel shows; none while that part of it is closed.
  int coatType() const { return coat_.type(); }
  std::optional<TileView> shownTile() const { return coat_.shownTile(); }

  // Whether the picture of the groom's map is on the screen.
  bool showsGroom() const { return groom_.shownMap(); }

  // Whether a change has begun and not ended.
  bool changing() const { return changing_; }
  // Until set or clicked: closed to its title on narrow screens, else open.
  void setCollapsed(bool collapsed) { layout_.setCollapsed(collapsed); }

  // As a press on Save scene: where something would be left out it asks.
  void save() { saves_ = true; }

  // The command of a key that means the same wherever the focus is (undo, redo, saving).
  static std::optional<Command> shortcut(std::string_view key, Modifiers modifiers);

 private:
  void drawTitle(const EditorModel& model);
  void drawMessages(const EditorModel& model);
  void askPicture(const EditorModel& model);
  void drawContent(const EditorModel& model, bool saves);
  void beginChange();
  void change(const EditorModel& model, const settings::Settings& edited);
  void drawScene(const EditorModel& model);
  void drawShippedScenes(const EditorModel& model);
  void drawActions(const EditorModel& model);
  void drawWater(const EditorModel& model);
  void drawTools(const EditorModel& model);
  template <class Draw>
  void editTyped(settings::Settings& edited, Draw draw);
  void drawSettings(settings::Settings& edited, std::span<const std::string> animations);
  void drawStats(const EditorModel& model);
  void drawSaving(const EditorModel& model);
  void scrollByFinger();
  void emit(Command command) { commands_.push_back(std::move(command)); }

  CoatPanel coat_;
  GroomPanel groom_;
  HairPanel hair_;
  PicturePanel picture_;
  VersionsPanel versions_;
  std::vector<Command> commands_;
  char filter_[64] = "";
  char path_[1024] = "";
  char letters_[32] = "";
  PanelLayout layout_;
  Frequent frequent_;
  std::optional<settings::Settings> beforeChange_;  // the last one, which may go on
  bool changing_ = false;
  bool saves_ = false;       // save() was called
  bool asksToSave_ = false;  // what saving would leave out is shown
  bool touch_ = false;
  // Heights of the scrolled part and of the messages below it, as of the last frame.
  float contentHeight_ = 0, messagesHeight_ = 0;
};

}  // namespace fur::editor
