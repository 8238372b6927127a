// A person at the panel, without a window: runs Dear ImGui frame by frame, moves a pointer, and
// carries settings commands out as a program would.
#pragma once

#include <cstring>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>
#include <imgui.h>
#include <imgui_internal.h>

#include "editor/Editor.h"
#include "editor/FieldRows.h"
#include "settings/Presets.h"

namespace fur::editor {

class PanelDriver {
 public:
  explicit PanelDriver(Vec2 screen = {1280, 3600}, ThemeScale scale = {}) : scale_(scale) {
    before_ = ImGui::GetCurrentContext();
    context_ = ImGui::CreateContext();
    ImGui::SetCurrentContext(context_);
    ImGuiIO& io = ImGui::GetIO();
    io.IniFilename = nullptr;
    io.DisplaySize = ImVec2(screen.x, screen.y);
    io.DeltaTime = 1.0f / 60;
    InputQueue::mapKeys(io);
    frames(3);
  }
  ~PanelDriver() {
    ImGui::DestroyContext(context_);
    ImGui::SetCurrentContext(before_);
  }

  void frames(int count) {
    for (int i = 0; i < count; ++i) {
      applyTheme(scale_);
      input.feed(ImGui::GetIO());
      ImGui::NewFrame();
      for (const Command& command : editor.frame(model, scale_)) {
        if (std::holds_alternative<command::BeginChange>(command)) undoTo_ = model.settings;
        if (std::holds_alternative<command::Undo>(command) && undoTo_) model.settings = *std::exchange(undoTo_, {});
        if (const auto* set = std::get_if<command::SetSettings>(&command)) model.settings = set->settings;
        if (const auto* preset = std::get_if<command::ApplyPreset>(&command))
          model.settings = *settings::applyPreset(model.settings, preset->name);
        commands.push_back(command);
      }
      ImGui::Render();
    }
  }
  // Until everything queued has been seen.
  void settle() {
    do frames(1);
    while (!input.empty());
    frames(2);
  }

  void moveTo(Vec2 at, int buttons = 0) {
    input.pointer(PointerKind::Mouse, at, buttons, seconds);
    settle();
  }
  void click(Vec2 at) {
    seconds += 10;
    moveTo(at);
    moveTo(at, 1);
    moveTo(at, 0);
  }
  void doubleClick(Vec2 at) {
    click(at);
    seconds += 0.2;
    moveTo(at, 1);
    moveTo(at, 0);
  }
  void tap(Vec2 at) {
    input.pointer(PointerKind::Touch, at, 1, seconds);
    input.pointer(PointerKind::Touch, at, 0, seconds);
    input.pointerGone();
    settle();
  }
  void type(const char* text) {
    input.text(text);
    settle();
  }
  void pressKey(const char* name) {
    input.key(name, true, {});
    input.key(name, false, {});
    settle();
  }

  // The window that holds the rows.
  ImGuiWindow* content() const {
    for (ImGuiWindow* window : context_->Windows)
      if (std::strstr(window->Name, "/content")) return window;
    return nullptr;
  }
  ImGuiWindow* panel() const { return ImGui::FindWindowByName("wet-fur"); }

  void openAllGroups() {
    for (const std::string_view group : fieldGroups())
      content()->StateStorage.SetInt(content()->GetID(std::string(group).c_str()), 1);
    frames(3);
  }

  ImGuiID id(const char* item) const { return content()->GetID(item); }
  ImGuiID rowId(const char* field, const char* item) const {
    return ImHashStr(item, 0, content()->GetID(field));
  }
  // A colour is a group of widgets; its text box is the leftmost.
  ImGuiID valueId(const settings::Field& field) const {
    const ImGuiID value = rowId(field.name, "##value");
    return field.type == settings::FieldType::Color ? ImHashStr("##Text", 0, value) : value;
  }

  // Where the pointer hovers the item, trying a raster over the panel.
  std::optional<Vec2> find(ImGuiID item) {
    std::optional<Vec2> found;
    sweep([&](Vec2 at, ImGuiID hovered) {
      if (hovered == item) found = at;
      return !found;
    });
    return found;
  }

  // What the pointer hovers, on lines through the value column, the reset column and the left.
  std::vector<std::pair<Vec2, ImGuiID>> sweep() {
    std::vector<std::pair<Vec2, ImGuiID>> seen;
    sweep([&](Vec2 at, ImGuiID hovered) {
      seen.emplace_back(at, hovered);
      return true;
    });
    return seen;
  }
  // The same, one after the other, while `goesOn(at, hovered)`.
  template <class GoesOn>
  void sweep(GoesOn goesOn) {
    const ImRect rect = panel()->Rect();
    for (const float share : {0.47f, 0.7f, 0.2f, 0.92f})
      for (float y = rect.Min.y + 3; y < rect.Max.y; y += 6) {
        const Vec2 at(rect.Min.x + rect.GetWidth() * share, y);
        if (const ImGuiID hovered = hoveredAt(at); hovered && !goesOn(at, hovered)) return;
      }
  }

  // What the pointer hovers there, and not what it hovered the frame before.
  ImGuiID hoveredAt(Vec2 at) {
    input.pointer(PointerKind::Mouse, at, 0);
    frames(1);
    return context_->HoveredId;
  }

  void openGroup(const char* name) {
    content()->StateStorage.SetInt(content()->GetID(name), 1);
    frames(3);
  }
  void press(const char* item) {
    const auto at = find(id(item));
    ASSERT_TRUE(at) << item;
    click(*at);
  }

  // A segment of a row, which may be of something that is listed.
  void pressSegment(ImGuiID row, int segment, const char* label) {
    const auto at = find(ImHashStr(label, 0, ImHashData(&segment, sizeof segment, row)));
    ASSERT_TRUE(at) << label;
    click(*at);
  }
  void pressSegmentOf(const char* one, const char* row, int segment, const char* label) { pressSegment(ImHashStr(row, 0, id(one)), segment, label); }

  template <class C>
  const C* last() const {
    for (auto command = commands.rbegin(); command != commands.rend(); ++command)
      if (const auto* found = std::get_if<C>(&*command)) return found;
    return nullptr;
  }
  template <class C>
  int count() const {
    int n = 0;
    for (const Command& command : commands) n += std::holds_alternative<C>(command);
    return n;
  }

  EditorModel model;
  Editor editor;
  InputQueue input;
  std::vector<Command> commands;  // all so far
  double seconds = 0;             // on the person's clock

 private:
  ThemeScale scale_;
  ImGuiContext *before_, *context_;
  std::optional<settings::Settings> undoTo_;  // before the last change
};

}  // namespace fur::editor
