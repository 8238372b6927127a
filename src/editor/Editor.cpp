#include "editor/Editor.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <iterator>
#include <utility>

#include <imgui_internal.h>  // ActiveId: which window a finger drags, whose text is typed

#include "editor/FieldRows.h"
#include "editor/ToolRows.h"
#include "editor/Widgets.h"
#include "scene/Formats.h"
#include "settings/FurTypes.h"

namespace fur::editor {

namespace {

// Added to the panel's padding, so that a finger can take hold of its edge.
constexpr float kFingerEdgeCssPixels = 8;

bool isModel(const EditorModel& model, std::string_view name) {
  return std::string_view(model.modelName).substr(0, model.modelName.find('.')) == name;
}

// Those of assets/scenes/scenes.mjs.
struct ShippedScene {
  const char *name, *label;
};
constexpr ShippedScene kModels[] = {{"otter", "Otter"}, {"pony", "Pony"}, {"bunny", "Bunny"}, {"sphere", "Sphere"}, {"torus", "Torus"}, {"plane", "Plane"}};
constexpr ShippedScene kScenes[] = {
    {"five-coats", "Five coats"},
    {"shells-8", "8 layers"},
    {"shells-16", "16 layers"},
    {"shells-32", "32 layers"},
    {"fins-everywhere", "Fins everywhere"},
    {"fins-outline", "Fins at the outline"},
    {"fading", "Fading fur"},
    {"variance", "Variance"},
    {"interpolation", "One type into another"},
    {"wet-bunny", "Wet bunny"},
    {"half-wet", "Half wet"},
    {"wet-letters", "Letters of water"},
    {"wet-straight", "Straight clumps"},
    {"wet-bent", "Bent clumps"},
    {"wet-tile", "Dry and wet"},
    {"hair-short", "Short hair"},
    {"hair-shoulder", "Shoulder-long hair"},
    {"hair-pony", "Pony tail"},
};

// A type that has just been made "own" begins as what it was.
void keepChosenTypes(const settings::Settings& before, settings::Settings& edited) {
  for (int type = 1; type < settings::kFurTypes; ++type)
    if (settings::isOwn(edited, type) && !settings::isOwn(before, type) && edited.ownTypes == before.ownTypes)
      settings::setTypeCoat(edited, type, settings::typeCoat(before, type));
}

void caption(const char* text) {
  ImGui::PushStyleColor(ImGuiCol_Text, color::kDim);
  ImGui::TextUnformatted(text);
  ImGui::PopStyleColor();
}

void statLine(const char* label, const char* format, double value) {
  caption(label);
  ImGui::SameLine(px(110));
  ImGui::Text(format, value);
}

}  // namespace

std::optional<Command> Editor::shortcut(std::string_view key, Modifiers modifiers) {
  if (!modifiers.control || modifiers.alt) return {};
  if (key == "z" || key == "Z") return modifiers.shift ? Command(command::Redo{}) : Command(command::Undo{});
  if (key == "y" || key == "Y") return Command(command::Redo{});
  if (key == "s" || key == "S") return Command(command::SaveScene{});
  return {};
}

std::string Editor::layout() const {
  const std::string frequent = frequent_.text();
  return layout_.text() + (frequent.empty() ? "" : ' ' + frequent);
}

void Editor::setLayout(std::string_view text) {
  layout_.read(text);
  frequent_.read(text);
}

// Arrow keys and Enter choose, too; Escape and a press beside it mean no use.
void Editor::askPicture(const EditorModel& model) {
  constexpr const char* kTitle = "What is this picture?";
  if (model.pictureAsked.empty()) return;
  if (!ImGui::IsPopupOpen(kTitle)) ImGui::OpenPopup(kTitle);
  ImGui::SetNextWindowPos(ImGui::GetMainViewport()->GetCenter(), ImGuiCond_Always, ImVec2(0.5f, 0.5f));
  if (!ImGui::BeginPopupModal(kTitle, nullptr, ImGuiWindowFlags_AlwaysAutoResize | ImGuiWindowFlags_NoSavedSettings)) return;
  std::optional<command::UsePicture> answer;
  ImGui::TextDisabled("%s", model.pictureAsked.c_str());
  for (std::size_t i = 0; i < app::kPictureUseCount; ++i) {
    const auto use = static_cast<PictureUse>(i);
    if (ImGui::IsWindowAppearing() && i == 0) ImGui::SetKeyboardFocusHere();
    if (ImGui::Button(app::rowOf(use).label, ImVec2(px(260), touch_ ? px(40) : 0))) answer = command::UsePicture{use};
    if (!touch_ && ImGui::IsItemHovered()) ImGui::SetTooltip("%s", app::rowOf(use).tooltip);
  }
  if (ImGui::Button("Cancel", ImVec2(px(260), touch_ ? px(40) : 0)) || ImGui::IsKeyPressed(ImGuiKey_Escape, false)) answer = command::UsePicture{};
  if (answer) {
    emit(*answer);
    ImGui::CloseCurrentPopup();
  }
  ImGui::EndPopup();
}

std::vector<Command> Editor::frame(const EditorModel& model, const ThemeScale& scale) {
  commands_.clear();
  const bool saves = std::exchange(saves_, false);
  if (saves && model.lostBySaving.empty()) emit(command::SaveScene{});
  if (saves && !model.lostBySaving.empty()) asksToSave_ = true, layout_.setCollapsed(false);
  touch_ = scale.touch;
  // Two taps of a finger are further apart than two clicks.
  ImGui::GetIO().MouseDoubleClickMaxDist = px(touch_ ? 24 : 6);
  layout_.place(scale, contentHeight_ > 0 ? contentHeight_ + messagesHeight_ : 0);
  constexpr ImGuiWindowFlags kFlags = ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoMove |
                                      ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoSavedSettings |
                                      ImGuiWindowFlags_NoScrollbar | ImGuiWindowFlags_NoScrollWithMouse |
                                      ImGuiWindowFlags_NoFocusOnAppearing;
  ImGui::Begin("wet-fur", nullptr, kFlags);
  if (touch_ && !layout_.narrow()) ImGui::Indent(px(kFingerEdgeCssPixels));
  layout_.drawEdge();
  drawTitle(model);
  if (!layout_.collapsed()) {
    drawContent(model, saves);
    drawMessages(model);
  } else {
    coat_.hide();
    groom_.hide();
  }
  askPicture(model);
  ImGui::End();
  // ImGui gives the focus to a window of its own first and then hands it on; arrow keys are the camera's
  // until the person turns to the panel.
  if (ImGui::GetFrameCount() == 1) ImGui::SetWindowFocus(nullptr);
  if (changing_ && !ImGui::IsAnyItemActive()) {
    changing_ = false;
    emit(command::EndChange{});
  }
  return std::exchange(commands_, {});
}

// Shows the coat of the type that is edited.
template <class Draw>
void Editor::editTyped(settings::Settings& edited, Draw draw) {
  settings::Settings shown = settings::typeCoat(edited, coat_.type());
  draw(shown);
  settings::takeEdited(edited, coat_.type(), shown);
}

void Editor::drawContent(const EditorModel& model, bool saves) {
  // With its scrollbar always, or rows would get narrower when it comes.
  ImGui::BeginChild("content", ImVec2(0, messagesHeight_ > 0 ? -messagesHeight_ : 0), false, ImGuiWindowFlags_AlwaysVerticalScrollbar);
  scrollByFinger();
  if (saves && asksToSave_) ImGui::SetScrollY(0);
  // The scene stands still for a picture.
  const bool busy = model.picture.busy;
  ImGui::BeginDisabled(busy);
  drawSaving(model);
  ImGui::EndDisabled();
  for (Command& command : picture_.draw(model, !touch_)) emit(std::move(command));
  ImGui::BeginDisabled(busy);
  for (Command& command : versions_.draw(model)) emit(std::move(command));
  settings::Settings edited = model.settings;
  editTyped(edited, [&](settings::Settings& shown) { drawFrequent(shown, frequent_, !touch_); });
  drawScene(model);
  for (Command& command : coat_.draw(model, edited, {.tooltips = !touch_, .roomy = layout_.roomy()})) emit(std::move(command));
  std::vector<Command> ofGroom = groom_.draw(model, edited, !touch_);
  if (groom_.changesNumbers()) beginChange();
  for (Command& command : ofGroom) emit(std::move(command));
  std::vector<Command> ofHair = hair_.draw(model, edited, !touch_);
  if (hair_.changesValues()) beginChange();
  for (Command& command : ofHair) emit(std::move(command));
  drawWater(model);
  editTyped(edited, [&](settings::Settings& shown) { drawSettings(shown, model.animations); });
  keepChosenTypes(model.settings, edited);
  if (edited != model.settings) change(model, edited);
  drawStats(model);
  ImGui::EndDisabled();
  contentHeight_ = ImGui::GetCursorPosY();
  ImGui::EndChild();
}

void Editor::change(const EditorModel& model, const settings::Settings& edited) {
  // The first click of a double click has moved a slider; the second, which asks for the text box, takes that back.
  const ImGuiContext& context = *ImGui::GetCurrentContext();
  const bool asksForText = ImGui::IsMouseDoubleClicked(0) && context.ActiveId && context.ActiveId == context.TempInputId;
  if (!changing_ && asksForText && beforeChange_ == edited) {
    beforeChange_.reset();
    emit(command::Undo{});
    return;
  }
  if (!changing_) beforeChange_ = model.settings;
  beginChange();
  emit(command::SetSettings{edited});
}

void Editor::beginChange() {
  if (!changing_) emit(command::BeginChange{});
  changing_ = true;
}

void Editor::drawTitle(const EditorModel& model) {
  ImGui::AlignTextToFramePadding();
  ImGui::TextUnformatted("wet-fur");
  const float gap = px(kTitleGapCssPixels);
  ImGui::SameLine(ImGui::GetContentRegionMax().x - titleButtonsWidth());
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, ImVec2(gap, ImGui::GetStyle().ItemSpacing.y));
  const auto hint = [&](const char* text) { return touch_ ? "" : text; };
  if (iconButton("##undo", Icon::Undo, hint("Undo (Ctrl+Z)"), model.canUndo)) emit(command::Undo{});
  ImGui::SameLine();
  if (iconButton("##redo", Icon::Redo, hint("Redo (Ctrl+Shift+Z)"), model.canRedo)) emit(command::Redo{});
  ImGui::SameLine();
  if (iconButton("##camera", Icon::Camera, hint("Reset the camera"))) emit(command::ResetCamera{});
  ImGui::SameLine();
  // The arrow points where the panel's free edge will go: the sheet opens upwards, the column downwards.
  const bool closed = layout_.collapsed();
  const Icon arrow = closed == layout_.narrow() ? Icon::ChevronUp : Icon::ChevronDown;
  if (iconButton("##collapse", arrow, hint(closed ? "Open" : "Collapse"))) layout_.setCollapsed(!closed);
  ImGui::PopStyleVar();
}

void Editor::drawMessages(const EditorModel& model) {
  constexpr std::size_t kMostShown = 3;
  const float top = ImGui::GetCursorPosY(), side = px(18);
  const std::size_t first = model.messages.size() > kMostShown ? model.messages.size() - kMostShown : 0;
  for (std::size_t i = first; i < model.messages.size(); ++i) {
    ImGui::PushID(static_cast<int>(i));
    const ImVec2 from = ImGui::GetCursorScreenPos();
    const float width = ImGui::GetContentRegionAvail().x;
    ImGui::Indent(px(10));
    ImGui::AlignTextToFramePadding();
    ImGui::PushTextWrapPos(ImGui::GetCursorPosX() + width - px(10) - side - px(6));
    ImGui::TextUnformatted(model.messages[i].text.c_str());
    ImGui::PopTextWrapPos();
    const float bottom = ImGui::GetItemRectMax().y;
    ImGui::Unindent(px(10));
    ImGui::GetWindowDrawList()->AddRectFilled(from, ImVec2(from.x + px(3), bottom),
                                              model.messages[i].isError ? color::kError : color::kWarning,
                                              px(1.5f));
    ImGui::SameLine(ImGui::GetContentRegionMax().x - side);
    if (iconButton("##dismiss", Icon::Close, "", true, side)) emit(command::DismissMessage{i});
    ImGui::PopID();
  }
  messagesHeight_ = ImGui::GetCursorPosY() - top;
}

void Editor::drawScene(const EditorModel& model) {
  ImGui::SetNextItemOpen(true, ImGuiCond_FirstUseEver);
  if (!groupHeader("Model")) return;
  ImGui::TextUnformatted(model.modelName.c_str());
  std::vector<Segment> models;
  for (const ShippedScene& shipped : kModels) models.push_back({shipped.label, isModel(model, shipped.name)});
  if (const int pressed = segments("models", models); pressed >= 0) emit(command::LoadShipped{kModels[pressed].name});
  drawShippedScenes(model);
  drawActions(model);
  if (ImGui::Button("Open a model, a coat, hair or a length map", ImVec2(-1, 0))) emit(command::OpenDialog{});
  if (model.fileAccess == FileAccess::Dialog) return;
  ImGui::SetNextItemWidth(-px(56));
  const bool entered = ImGui::InputTextWithHint("##path", "Path of a model, coat or picture, or drop one", path_,
                                                sizeof path_, ImGuiInputTextFlags_EnterReturnsTrue);
  ImGui::SameLine(0, px(3));
  const bool pressed = ImGui::Button("Open", ImVec2(-1, 0));
  if ((entered || pressed) && path_[0]) emit(command::OpenPath{path_});
}

void Editor::drawShippedScenes(const EditorModel& model) {
  const ShippedScene* shown = std::find_if(std::begin(kScenes), std::end(kScenes),
                                           [&](const ShippedScene& scene) { return isModel(model, scene.name); });
  ImGui::SetNextItemWidth(-1);
  if (!ImGui::BeginCombo("##scenes", shown == std::end(kScenes) ? "Scenes" : shown->label, ImGuiComboFlags_HeightLargest)) return;
  for (const ShippedScene& scene : kScenes)
    if (ImGui::Selectable(scene.label, &scene == shown)) emit(command::LoadShipped{scene.name});
  ImGui::EndCombo();
}

// Of an animal; the one that it does now is lit.
void Editor::drawActions(const EditorModel& model) {
  if (model.actions.empty()) return;
  std::vector<Segment> actions;
  for (const std::string& action : model.actions) actions.push_back({action.c_str(), action == model.action});
  if (const int pressed = segments("actions", actions); pressed >= 0) emit(command::Act{model.actions[static_cast<std::size_t>(pressed)]});
}

void Editor::drawWater(const EditorModel& model) {
  ImGui::SetNextItemOpen(true, ImGuiCond_FirstUseEver);
  if (!groupHeader("Water and touch")) return;
  drawTools(model);
  const float button = px(64), gap = px(3);
  char text[32];
  std::snprintf(text, sizeof text, "%.0f %% wet", static_cast<double>(model.meanWetness) * 100);
  const float width = ImGui::GetContentRegionAvail().x - 2 * (button + gap);
  ImGui::ProgressBar(model.meanWetness, ImVec2(width, ImGui::GetFrameHeight()), text);
  ImGui::SameLine(0, gap);
  if (ImGui::Button("Soak", ImVec2(button, 0))) emit(command::SetWetness{1});
  ImGui::SameLine(0, gap);
  if (ImGui::Button("Dry off", ImVec2(button, 0))) emit(command::SetWetness{0});
  const WaterView& w = model.water;
  if (ImGui::Button("Shake", ImVec2(button, 0))) emit(command::Shake{});
  ImGui::SameLine(0, gap);
  ImGui::SetNextItemWidth(-button - gap);
  const bool entered = ImGui::InputTextWithHint("##letters", "Letters", letters_, sizeof letters_, ImGuiInputTextFlags_EnterReturnsTrue);
  ImGui::SameLine(0, gap);
  if ((ImGui::Button("Stamp", ImVec2(button, 0)) || entered) && letters_[0]) emit(command::Stamp{letters_});
  ImGui::TextDisabled("fur %.2f  film %.2f  drops %.2f", w.held, w.film, w.drops);
  ImGui::TextDisabled("of %.2f  dripped %.2f  dried %.2f", w.came, w.dripped, w.dried);
  ImGui::Dummy(ImVec2(0, px(2)));
}

void Editor::drawTools(const EditorModel& model) {
  if (const auto tool = toolIconRow("tools", model.tool)) emit(command::SetTool{*tool});
  for (const char* row : {"held", "touch"})
    if (const auto tool = toolRow(row, model.tool)) emit(command::SetTool{*tool});
}

void Editor::drawSettings(settings::Settings& edited, std::span<const std::string> animations) {
  const bool filtered = filter_[0] != '\0';
  ImGui::SetNextItemWidth(filtered ? -ImGui::GetFrameHeight() - px(2) : -1);
  ImGui::InputTextWithHint("##filter", "Search settings", filter_, sizeof filter_);
  if (filtered) {
    ImGui::SameLine(0, px(2));
    if (iconButton("##clear", Icon::Close, "")) filter_[0] = '\0';
  }
  if (drawFields(edited, frequent_, filter_, !touch_, animations) == 0) caption("No setting has that in its name.");
}

// What would be left out is said before anything is written.
void Editor::drawSaving(const EditorModel& model) {
  if (model.lostBySaving.empty()) asksToSave_ = false;
  if (!asksToSave_) {
    if (!ImGui::Button(scene::saveLabel(scene::Format::Glb).c_str(), ImVec2(-1, 0))) return;
    asksToSave_ = !model.lostBySaving.empty();
    if (!asksToSave_) emit(command::SaveScene{});
    return;
  }
  ImGui::PushTextWrapPos(0);
  ImGui::TextUnformatted("A saved scene will be without");
  for (const std::string& what : model.lostBySaving) ImGui::BulletText("%s", what.c_str());
  ImGui::PopTextWrapPos();
  const float half = (ImGui::GetContentRegionAvail().x - px(3)) * 0.5f;
  const bool saves = ImGui::Button("Save anyway", ImVec2(half, 0));
  ImGui::SameLine(0, px(3));
  if (ImGui::Button("Cancel", ImVec2(-1, 0)) || saves) asksToSave_ = false;
  if (saves) emit(command::SaveScene{});
}

void Editor::drawStats(const EditorModel& model) {
  if (!groupHeader("Share and statistics")) return;
  const float half = (ImGui::GetContentRegionAvail().x - px(3)) * 0.5f;
  if (ImGui::Button("Copy settings", ImVec2(half, 0))) emit(command::CopyState{});
  ImGui::SameLine(0, px(3));
  if (ImGui::Button("Paste settings", ImVec2(half, 0))) emit(command::PasteState{});
  statLine("Vertices", "%.0f", model.vertices);
  statLine("Triangles", "%.0f", model.triangles);
  statLine("Strands", "%.0f", model.strands);
  statLine("Layers", "%.0f", model.layers);
  statLine("Fin edges", "%.0f", model.finEdges);
  constexpr double kMebi = 1024.0 * 1024.0;
  statLine("Memory", "%.1f MiB", static_cast<double>(model.cpuBytes) / kMebi);
  statLine("GPU memory", "%.1f MiB", static_cast<double>(model.gpuBytes) / kMebi);
  if (model.frameSeconds.empty()) return;
  const float longest = *std::max_element(model.frameSeconds.begin(), model.frameSeconds.end());
  char text[32];
  std::snprintf(text, sizeof text, "%.1f ms", static_cast<double>(model.frameSeconds.back()) * 1000);
  ImGui::PlotLines("##frames", model.frameSeconds.data(), static_cast<int>(model.frameSeconds.size()), 0,
                   text, 0, longest * 1.1f, ImVec2(-1, px(48)));
}

void Editor::scrollByFinger() {
  // ImGui 1.86 scrolls by wheel and scrollbar only. A finger that starts on nothing in particular
  // drags the content; ImGui then counts the window itself as the active item.
  const ImGuiWindow* window = ImGui::GetCurrentWindow();
  if (touch_ && ImGui::IsMouseDown(0) && ImGui::GetActiveID() == window->MoveId)
    ImGui::SetScrollY(ImGui::GetScrollY() - ImGui::GetIO().MouseDelta.y);
}

}  // namespace fur::editor
