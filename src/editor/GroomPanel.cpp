#include "editor/GroomPanel.h"

#include <cstdio>
#include <utility>

#include "editor/Theme.h"
#include "editor/ToolRows.h"
#include "editor/Widgets.h"

namespace fur::editor {

namespace {

// How much shorter "Vary" makes the shortest patches.
constexpr float kVariation = 0.5f;
// How far the mask grows, shrinks and softens at once, model units.
constexpr float kMaskStep = 0.03f;
// A map of 256 texels at this size shows each as a pixel on most screens.
constexpr float kMapSide = 160;

void choice(const char* text, const char* id, int& value, const char* const (&names)[4]) {
  rowLabel(text);
  const int chosen = segments(id, {{names[0], value == 0}, {names[1], value == 1}, {names[2], value == 2}, {names[3], value == 3}});
  if (chosen >= 0) value = chosen;
}

void slider(const char* text, const char* id, float& value, const char* field) {
  rowLabel(text);
  ImGui::SetNextItemWidth(-1);
  const settings::Field& bounds = *settings::findField(field);
  fillSlider(id, value, static_cast<float>(bounds.low), static_cast<float>(bounds.high), "%.2f", false);
}

}  // namespace

void GroomPanel::hint(const char* text) const {
  if (tooltips_ && ImGui::IsItemHovered()) ImGui::SetTooltip("%s", text);
}

std::vector<Command> GroomPanel::draw(const EditorModel& model, settings::Settings& edited, bool tooltips) {
  commands_.clear();
  shown_ = false;
  tooltips_ = tooltips;
  if (!groupHeader("Groom")) return {};
  drawBrush(model, edited);
  drawPaint(model, edited);
  drawMask(model, edited);
  drawSelection(model, edited);
  drawWhiskers(model, edited);
  drawLengths();
  drawDirections();
  drawMap(model.groom);
  ImGui::Dummy(ImVec2(0, px(2)));
  return std::exchange(commands_, {});
}

void GroomPanel::drawBrush(const EditorModel& model, settings::Settings& edited) {
  for (const char* row : {"combs", "cuts"})
    if (const auto tool = toolRow(row, model.tool)) commands_.push_back(command::SetTool{*tool});
  for (const Tool tool : toolsIn("shapes")) givesOrTakes(tool, model, edited);
  ImGui::Dummy(ImVec2(0, 0));
  ImGui::SameLine(px(80));
  if (segments("shapeAlls", {{"Clear curls, frizz and locks", false}}) == 0) edit(GroomEdit::ClearShape);
  slider("Size", "##groomSize", edited.brushRadius, "brushRadius");
  hint("[ and ] make it smaller and larger");
  slider("Strength", "##groomStrength", edited.groomStrength, "groomStrength");
  hint("Shift with [ and ] makes it weaker and stronger");
  choice("Falloff", "falloffs", edited.brushFalloff, {"Smooth", "Linear", "Sharp", "Flat"});
  hint("How a brush fades from its middle to its rim");
  choice("Mirror", "mirrors", edited.mirror, {"Off", "X", "Y", "Z"});
  hint("Brushes, also those with water, work on the other side of the model, too; X is left and right");
  slider("Cut to", "##cutLength", edited.cutLength, "cutLength");
  hint("What the brush Cut leaves of longer fur");
  rowLabel("Type");
  const int type = segments("types", {{"1", edited.groomType == 0}, {"2", edited.groomType == 1},
                                      {"3", edited.groomType == 2}, {"4", edited.groomType == 3}});
  if (type >= 0) edited.groomType = type;
  hint("What the brush Type paints: 1, the coat of the settings, takes the others away. What 2 to 4 are is set under Types");
}

void GroomPanel::givesOrTakes(Tool tool, const EditorModel& model, settings::Settings& edited) {
  drawToolAndInverse(tool, model, edited, commands_);
  hint(app::wordsOf(tool).tooltip);
}

void GroomPanel::drawPaint(const EditorModel& model, settings::Settings& edited) {
  for (const Tool tool : toolsIn("paints")) givesOrTakes(tool, model, edited);
  rowLabel("Colour");
  const std::uint32_t rgb = edited.paintColor;
  float color[3] = {static_cast<float>(rgb >> 16 & 255u) / 255, static_cast<float>(rgb >> 8 & 255u) / 255, static_cast<float>(rgb & 255u) / 255};
  ImGui::SetNextItemWidth(-1);
  if (ImGui::ColorEdit3("##paintColor", color, ImGuiColorEditFlags_PickerHueWheel | ImGuiColorEditFlags_DisplayHex)) {
    edited.paintColor = 0;
    for (const float c : color) edited.paintColor = edited.paintColor << 8 | static_cast<std::uint32_t>(c * 255 + 0.5f);
  }
  hint("Click the square for more; Alt+click on the model takes its colour");
  ImGui::Dummy(ImVec2(0, 0));
  ImGui::SameLine(px(80));
  const int all = segments("paintAlls", {{"Fill", false}, {"Clear paint", false}});
  if (all == 0) edit(GroomEdit::Paint, static_cast<float>(edited.paintColor));
  if (all == 1) edit(GroomEdit::ClearPaint);
}

void GroomPanel::drawMask(const EditorModel& model, settings::Settings& edited) {
  for (const Tool tool : toolsIn("masks")) givesOrTakes(tool, model, edited);
  ImGui::Dummy(ImVec2(0, 0));
  ImGui::SameLine(px(80));
  const int all = segments("maskAlls", {{"Invert mask", false}, {"Clear mask", false}});
  if (all == 0) edit(GroomEdit::InvertMask);
  if (all == 1) edit(GroomEdit::ClearMask);
}

void GroomPanel::drawSelection(const EditorModel& model, settings::Settings& edited) {
  const std::size_t before = commands_.size();
  rowLabel("Mask");
  const int change = segments("maskChanges", {{"Grow", false}, {"Shrink", false}, {"Smooth", false}});
  constexpr GroomEdit kChanges[] = {GroomEdit::GrowMask, GroomEdit::ShrinkMask, GroomEdit::SmoothMask};
  if (change >= 0) edit(kChanges[change], kMaskStep);
  rowLabel("Select");
  const Selects waits = model.groom.selects;
  const int chosen = segments("selects", {{"Connected", waits == Selects::Connected}, {"Paint", waits == Selects::Paint}, {"Type", false}});
  hint("The mask protects all else. Connected and Paint: then click on the model, on a part of it or on a colour (Esc: not). "
       "Type: what the brush Type would paint");
  if (chosen == 0) commands_.push_back(command::SelectAt{waits == Selects::Connected ? Selects::Nothing : Selects::Connected});
  if (chosen == 1) commands_.push_back(command::SelectAt{waits == Selects::Paint ? Selects::Nothing : Selects::Paint});
  if (chosen == 2) edit(GroomEdit::SelectType, static_cast<float>(edited.groomType + 1));
  rowLabel("Lengths");
  const float button = px(56), gap = px(3), width = (ImGui::GetContentRegionAvail().x - button - 2 * gap) * 0.5f;
  ImGui::SetNextItemWidth(width);
  fillSlider("##shortest", shortest_, 0, 1, "%.2f", false);
  hint("The shortest and the longest fur that is selected, as shares of the longest");
  ImGui::SameLine(0, gap);
  ImGui::SetNextItemWidth(width);
  fillSlider("##longest", longest_, 0, 1, "%.2f", false);
  ImGui::SameLine(0, gap);
  if (ImGui::Button("Select##lengths", ImVec2(-1, 0))) edit(GroomEdit::SelectLength, 1, {shortest_, longest_, 0});
  // The mask is shown to who is grooming.
  if (commands_.size() > before && !app::grooms(model.tool)) commands_.push_back(command::SetTool{Tool::Mask});
}

void GroomPanel::drawWhiskers(const EditorModel& model, settings::Settings& edited) {
  if (const auto tool = toolRow("hairs", model.tool)) commands_.push_back(command::SetTool{*tool});
  hint("Press to plant one, drag to aim it; Pluck pulls out those under the brush. How they grow is set under Whiskers below");
  rowLabel("Hairs");
  ImGui::SetNextItemWidth(-px(64));
  fillSlider("##whiskerHairs", edited.whiskerHairs, 1, 8);
  ImGui::SameLine(0, px(3));
  ImGui::TextDisabled("%d stand", model.groom.whiskers);
}

void GroomPanel::drawLengths() {
  rowLabel("Length");
  const int share = segments("lengths", {{"Full", false}, {"3/4", false}, {"1/2", false}, {"1/4", false}, {"Bald", false}});
  if (share >= 0) edit(GroomEdit::Length, 1 - 0.25f * static_cast<float>(share));
  ImGui::Dummy(ImVec2(0, 0));
  ImGui::SameLine(px(80));
  const int change = segments("changes", {{"Invert", false}, {"Vary", false}});
  if (change == 0) edit(GroomEdit::Invert);
  if (change == 1) edit(GroomEdit::Vary, kVariation);
}

void GroomPanel::drawDirections() {
  rowLabel("Comb all");
  const int way = segments("ways", {{"Down", false}, {"Back", false}, {"Up", false}, {"Upright", false}});
  constexpr float kWays[3][3] = {{0, -1, 0}, {0, -0.3f, -1}, {0, 1, 0}};
  if (way == 3) edit(GroomEdit::Raise);
  else if (way >= 0) edit(GroomEdit::Comb, 1, {kWays[way][0], kWays[way][1], kWays[way][2]});
}

void GroomPanel::drawMap(const GroomView& groom) {
  char text[64];
  std::snprintf(text, sizeof text, "%.0f %% furry, %.0f %% long", static_cast<double>(1 - groom.bald) * 100,
                static_cast<double>(groom.length) * 100);
  const float button = px(64), gap = px(3);
  ImGui::ProgressBar(1 - groom.bald, ImVec2(-button - gap, ImGui::GetFrameHeight()), text);
  ImGui::SameLine(0, gap);
  ImGui::BeginDisabled(groom.plain);
  if (ImGui::Button("Clear", ImVec2(-1, 0))) edit(GroomEdit::Clear);
  ImGui::EndDisabled();
  hint("All of the groom: full length, one type, upright, no whiskers, no paint, no mask, no curls, frizz or locks of brushes");
  std::snprintf(text, sizeof text, "Types %.0f, %.0f, %.0f, %.0f %%", static_cast<double>(groom.types[0]) * 100,
                static_cast<double>(groom.types[1]) * 100, static_cast<double>(groom.types[2]) * 100,
                static_cast<double>(groom.types[3]) * 100);
  ImGui::TextDisabled("%s", text);
  rowLabel("Map");
  const int size = segments("sizes", {{"256", groom.mapSize == 256}, {"512", groom.mapSize == 512}, {"1024", groom.mapSize == 1024}});
  if (size >= 0) edit(GroomEdit::Size, static_cast<float>(256 << size));
  shown_ = true;
  const float side = px(kMapSide);
  const ImVec2 corner = ImGui::GetCursorScreenPos();
  if (groom.map) ImGui::Image(groom.map, ImVec2(side, side));
  else ImGui::Dummy(ImVec2(side, side));
  hint("The groom over the atlas: bright is long, colours are the types 2 to 4 and the paint. Lines: where charts end");
  for (const Vec4& line : groom.outlines)
    ImGui::GetWindowDrawList()->AddLine(ImVec2(corner.x + line.x * side, corner.y + line.y * side),
                                        ImVec2(corner.x + line.z * side, corner.y + line.w * side), IM_COL32(255, 96, 0, 200));
  if (ImGui::Button("Save maps (.png)", ImVec2(-1, 0))) commands_.push_back(command::SaveMaps{});
  hint("Length, types, paint, mask, shape, comb, wetness and the outlines of the charts, for other programs. Opened here or dropped "
       "on the model, the first five come back");
}

}  // namespace fur::editor
