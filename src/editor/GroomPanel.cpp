#include "editor/GroomPanel.h"

#include <algorithm>
#include <cstdio>
#include <iterator>
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
// Degrees that a comb lays fur down at most (groom::kMaxComb).
constexpr float kMostCombed = 66;
// Sizes of markings, 1 as is usual.
constexpr float kLeastPattern = 0.3f, kMostPattern = 3;
// A map of 256 texels at this size shows each as a pixel on most screens.
constexpr float kMapSide = 160;

// Of shares, counted from 1.
int mostOf(const float (&types)[4]) { return 1 + static_cast<int>(std::max_element(std::begin(types), std::end(types)) - types); }

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
  shown_ = changes_ = false;
  tooltips_ = tooltips;
  // In two frames, as only the second knows how long the panel has become.
  if (openFor(model.tool)) scrolls_ = 2;
  if (!groupHeader("Groom")) return {};
  if (scrolls_ > 0) --scrolls_, ImGui::SetScrollHereY(0);
  drawPoint(model);
  drawParts(model);
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

bool GroomPanel::openFor(Tool tool) {
  const bool begins = tool != tool_ && (tool == Tool::Edit || tool == Tool::Whisker);
  tool_ = tool;
  if (!begins || ImGui::GetStateStorage()->GetInt(ImGui::GetID("Groom"), 0) != 0) return false;
  ImGui::SetNextItemOpen(true);
  return true;
}

bool GroomPanel::number(const char* label, float& value, float low, float high, const char* format) {
  rowLabel(label);
  ImGui::PushID(label);
  ImGui::SetNextItemWidth(-1);
  const bool changed = fillSlider("##number", value, low, high, format, false);
  ImGui::PopID();
  changes_ |= changed;
  return changed;
}

bool GroomPanel::drawLean(LeanView& lean, float most, const char* what) {
  const bool leans = number("Lean", lean.lean, 0, most, "%.0f deg");
  hint(what);
  const bool turns = number("Towards", lean.heading, -180, 180, "%.0f deg");
  hint("Seen from above: 0 is up the model, 90 to the right");
  return leans || turns;
}

void GroomPanel::drawPoint(const EditorModel& model) {
  if (const auto tool = toolRow("modes", model.tool)) commands_.push_back(command::SetTool{*tool});
  hint("Edit points: click a point to see and set its numbers, drag to comb it, with the right button to lengthen it (key E). Whisker: press "
       "to plant one, drag to aim it; press on one that stands to choose it, and drag to aim it anew (key W)");
  if (const auto& under = model.groom.under)
    ImGui::TextDisabled("Under the brush: length %.2f, lean %.0f, type %d, wet %.0f %%", static_cast<double>(under->length), static_cast<double>(under->comb.lean),
                        mostOf(under->types), static_cast<double>(under->wetness) * 100);
  else ImGui::TextDisabled("Under the brush: nothing of the model");
  if (model.groom.whisker) drawWhisker(*model.groom.whisker);
  if (model.tool != Tool::Edit) return;
  if (!model.groom.point) return ImGui::TextDisabled("Click a point of the model to set its numbers");
  PointView point = *model.groom.point;
  if (number("Length", point.length, 0, 1, "%.2f")) commands_.push_back(command::SetPoint{FurNumber::Length, point.length});
  hint("Of the longest, over the brush's size; right button and drag on the model, or { and }");
  if (drawLean(point.comb, kMostCombed, "How far the fur is combed down; drag on the model")) commands_.push_back(command::SetPoint{FurNumber::Comb, 0, point.comb});
  rowLabel("Type");
  const int chosen = mostOf(point.types);
  const int type = segments("pointTypes", {{"1", chosen == 1}, {"2", chosen == 2}, {"3", chosen == 3}, {"4", chosen == 4}});
  hint("The keys 1 to 4 do the same");
  if (type >= 0) commands_.push_back(command::SetPoint{FurNumber::Type, static_cast<float>(type + 1)});
  // Water takes strokes, which a replay does again: one when the slider is let go.
  rowLabel("Wetness");
  ImGui::SetNextItemWidth(-1);
  float wetness = wetness_.value_or(point.wetness);
  if (fillSlider("##pointWetness", wetness, 0, 1, "%.2f", false)) wetness_ = wetness;
  if (wetness_ && !ImGui::IsItemActive()) {
    commands_.push_back(command::SetPoint{FurNumber::Wetness, *wetness_});
    wetness_.reset();
  }
}

void GroomPanel::drawWhisker(const WhiskerView& whisker) {
  const settings::Field& longest = *settings::findField("whiskerLength");
  const settings::Field& widest = *settings::findField("whiskerWidth");
  WhiskerView next = whisker;
  bool changed = number("Its length", next.length, static_cast<float>(longest.low), static_cast<float>(longest.high), "%.2f");
  hint("Right button and drag on the model, or [ and ]");
  changed |= number("Its width", next.width, static_cast<float>(widest.low), static_cast<float>(widest.high), "%.4f");
  hint("Or { and }");
  changed |= drawLean(next.aim, 90, "Away from upright; drag it on the model, or shift and arrow keys");
  changed |= number("Its spread", next.spread, 0, 1, "%.2f");
  changed |= number("Its stiffness", next.stiffness, 0, 1, "%.2f");
  rowLabel("Its hairs");
  ImGui::SetNextItemWidth(-1);
  if (fillSlider("##itsHairs", next.hairs, 1, 8)) changed = changes_ = true;
  rowLabel("Its colour");
  float color[3];
  for (int k = 0; k < 3; ++k) color[k] = static_cast<float>(next.color >> (16 - 8 * k) & 255u) / 255;
  ImGui::SetNextItemWidth(-1);
  if (ImGui::ColorEdit3("##itsColor", color, ImGuiColorEditFlags_PickerHueWheel | ImGuiColorEditFlags_DisplayHex)) {
    next.color = 0;
    for (const float c : color) next.color = next.color << 8 | static_cast<std::uint32_t>(c * 255 + 0.5f);
    changed = changes_ = true;
  }
  if (changed) commands_.push_back(command::SetWhisker{next});
  ImGui::Dummy(ImVec2(0, 0));
  ImGui::SameLine(px(80));
  const int done = segments("whiskerSteps", {{"Previous", false}, {"Next", false}, {"Delete", false}});
  hint("The keys N, shift+N and Delete do the same");
  if (done == 0 || done == 1) commands_.push_back(command::ChooseWhisker{done == 0 ? -1 : 1});
  if (done == 2) commands_.push_back(command::RemoveWhisker{});
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
  rowLabel("Pattern");
  ImGui::SetNextItemWidth(-1);
  fillSlider("##patternSize", patternSize_, kLeastPattern, kMostPattern, "%.2f", true);
  hint("How large the markings are; the seed of the coat makes others");
  constexpr GroomEdit kPatterns[] = {GroomEdit::Tabby, GroomEdit::Spots, GroomEdit::Rosettes, GroomEdit::Patches};
  const int pattern = segments("patterns", {{"Tabby", false}, {"Spots", false}, {"Rosettes", false}, {"Patches", false}});
  hint("Markings all over in the colour above, in place of what is painted");
  if (pattern >= 0) edit(kPatterns[pattern], patternSize_);
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

void GroomPanel::drawParts(const EditorModel& model) {
  if (const auto tool = toolRow("parts", model.tool)) commands_.push_back(command::SetTool{*tool});
  hint("Then click a part of the model: fur grows on its material, or no longer");
  int material = 0;
  for (const MaterialView& part : model.materials) {
    ImGui::PushID(material);
    bool furry = part.furry;
    ImGui::Dummy(ImVec2(0, 0));
    ImGui::SameLine(px(80));
    if (ImGui::Checkbox(part.name.empty() ? "(no name)" : part.name.c_str(), &furry)) commands_.push_back(command::SetFurry{material, furry});
    ImGui::PopID();
    ++material;
  }
}

void GroomPanel::drawWhiskers(const EditorModel& model, settings::Settings& edited) {
  if (const auto tool = toolRow("hairs", model.tool)) commands_.push_back(command::SetTool{*tool});
  hint("Pulls out whiskers under the brush. How new ones grow is set under Whiskers below");
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
  const int way = segments("ways", {{"Down", false}, {"Back", false}, {"Up", false}, {"Upright", false}, {"As it lies", false}});
  constexpr float kWays[3][3] = {{0, -1, 0}, {0, -0.3f, -1}, {0, 1, 0}};
  if (way == 4) edit(GroomEdit::Lie);
  else if (way == 3) edit(GroomEdit::Raise);
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
