#include "editor/HairPanel.h"

#include <cstdio>
#include <cstring>
#include <utility>

#include "editor/FieldRows.h"
#include "editor/Theme.h"
#include "editor/ToolRows.h"
#include "editor/Widgets.h"
#include "hair/HairFields.h"
#include "scene/Formats.h"

namespace fur::editor {

void HairPanel::hint(const char* text) const {
  if (tooltips_ && ImGui::IsItemHovered()) ImGui::SetTooltip("%s", text);
}

std::vector<Command> HairPanel::draw(const EditorModel& model, settings::Settings& edited, bool tooltips) {
  commands_.clear();
  changed_ = false;
  tooltips_ = tooltips;
  if (!groupHeader("Long hair")) return {};
  drawScalps(model.hair);
  if (!model.hair.scalps.empty()) {
    drawName(model.hair);
    drawBrush(model, edited);
    drawGuides(model, edited);
    drawBodies(model.hair);
    drawValues(model.hair);
    drawSaving(model.hair.scalps[model.hair.selected]);
  }
  ImGui::Dummy(ImVec2(0, px(2)));
  return std::exchange(commands_, {});
}

void HairPanel::drawScalps(const HairView& hair) {
  for (std::size_t i = 0; i < hair.scalps.size(); ++i) {
    const ScalpView& scalp = hair.scalps[i];
    char text[128];
    std::snprintf(text, sizeof text, "%s: %zu guides, %zu wisps##scalp%zu", scalp.name.c_str(), scalp.guides, scalp.wisps, i);
    if (ImGui::Selectable(text, i == hair.selected) && i != hair.selected) edit(HairEdit::Select, static_cast<float>(i));
  }
  const int pressed = segments("scalpAlls", {{"Add scalp", false}, {"Remove", false}, {"Clear all", false}});
  hint("A scalp is where long hair grows: a mane, a tail, a forelock. Add one, paint it with Scalp, then plant guides");
  if (pressed == 0) {
    edit(HairEdit::AddScalp);
    commands_.push_back(command::SetTool{Tool::Scalp});
  }
  if (pressed == 1 && !hair.scalps.empty()) edit(HairEdit::Remove);
  if (pressed == 2 && !hair.scalps.empty()) edit(HairEdit::Clear);
}

void HairPanel::drawName(const HairView& hair) {
  rowLabel("Name");
  ImGui::SetNextItemWidth(-1);
  if (named_ != hair.selected || !ImGui::IsAnyItemActive()) {
    named_ = hair.selected;
    std::snprintf(name_, sizeof name_, "%s", hair.scalps[named_].name.c_str());
  }
  if (ImGui::InputText("##scalpName", name_, sizeof name_, ImGuiInputTextFlags_EnterReturnsTrue) || ImGui::IsItemDeactivatedAfterEdit())
    commands_.push_back(command::RenameScalp{named_, name_});
}

// A tool and its inverse, side by side.
void HairPanel::givesOrTakes(Tool tool, const EditorModel& model, settings::Settings& edited) {
  drawToolAndInverse(tool, model, edited, commands_);
  hint(app::wordsOf(tool).tooltip);
}

void HairPanel::drawBrush(const EditorModel& model, settings::Settings& edited) {
  for (const Tool tool : toolsIn("scalps")) givesOrTakes(tool, model, edited);
  rowLabel("Paints");
  const int map = segments("scalpMaps", {{"Density", edited.scalpMap == 0}, {"Width", edited.scalpMap == 1}, {"Length", edited.scalpMap == 2},
                                         {"Turn", edited.scalpMap == 3}});
  hint("Where hair grows and how densely; how wide wisps are there; how long; how far they turn by chance. Size and strength of the brush: under Groom");
  if (map >= 0) edited.scalpMap = map;
  ImGui::Dummy(ImVec2(0, 0));
  ImGui::SameLine(px(80));
  const int all = segments("coverAlls", {{"Everywhere", false}, {"Nowhere", false}});
  if (all >= 0) edit(HairEdit::Cover, all == 0 ? 1.0f : 0.0f);
}

void HairPanel::drawGuides(const EditorModel& model, settings::Settings& edited) {
  const ScalpView& scalp = model.hair.scalps[model.hair.selected];
  rowLabel("Guides");
  const float button = px(64), gap = px(3);
  ImGui::SetNextItemWidth(-button - gap);
  fillSlider("##guides", guides_, 3, 512);
  ImGui::SameLine(0, gap);
  if (ImGui::Button(scalp.guides ? "Replant" : "Plant", ImVec2(-1, 0))) edit(HairEdit::Plant, static_cast<float>(guides_));
  hint("Guides shape the hair and swing; all wisps follow three of them. They grow along the skin's normal, or as the coat is combed");
  if (scalp.guides == 0) return;
  if (const auto tool = toolRow("guides", model.tool)) commands_.push_back(command::SetTool{*tool});
  hint("Work on guides where hair is seen; size, strength and mirror of the brush are under Groom");
  for (const Tool tool : toolsIn("guideShapes")) givesOrTakes(tool, model, edited);
  rowLabel("All");
  const int all = segments("guideAlls", {{"Hang", false}, {"Straight", false}, {"Longer", false}, {"Shorter", false}});
  constexpr float kHang = 0.5f, kLonger = 1.1f;
  if (all == 0) edit(HairEdit::Hang, kHang);
  if (all == 1) edit(HairEdit::Straighten, 1);
  if (all == 2) edit(HairEdit::Lengthen, kLonger);
  if (all == 3) edit(HairEdit::Lengthen, 1 / kLonger);
  ImGui::Dummy(ImVec2(0, 0));
  ImGui::SameLine(px(80));
  const int more = segments("guideMores", {{"Mirror", false}, {"Show all", false}, {"Free all", false}});
  hint("Mirror: the guides at +x, and the same at -x. Show all: those that were hidden. Free all: all swing");
  if (more == 0) edit(HairEdit::Mirror, 1);
  if (more == 1) edit(HairEdit::ShowAll);
  if (more == 2) edit(HairEdit::FreeAll);
}

// At the end, as a file is made of what is there.
void HairPanel::drawSaving(const ScalpView& scalp) {
  ImGui::BeginDisabled(scalp.wisps == 0);
  if (ImGui::Button(scene::saveLabel(scene::Format::Hair).c_str(), ImVec2(-1, 0))) commands_.push_back(command::SaveHair{});
  ImGui::EndDisabled();
  hint("All strands of this scalp, for other programs. A .hair file that is opened becomes guides of this scalp, or of a new one");
}

void HairPanel::drawBodies(const HairView& hair) {
  rowLabel("Sphere");
  const float button = px(64), gap = px(3);
  ImGui::SetNextItemWidth(-2 * (button + gap));
  fillSlider("##sphere", sphereRadius_, 0.05f, 1.5f, "%.2f", false);
  ImGui::SameLine(0, gap);
  if (ImGui::Button("Add##sphere", ImVec2(button, 0))) edit(HairEdit::AddSphere, sphereRadius_);
  hint("Hair does not enter it; it goes round the middle of the model");
  ImGui::SameLine(0, gap);
  ImGui::BeginDisabled(hair.bodies == 0);
  char text[32];
  std::snprintf(text, sizeof text, "Clear %zu###clearBodies", hair.bodies);
  if (ImGui::Button(text, ImVec2(-1, 0))) edit(HairEdit::ClearBodies);
  ImGui::EndDisabled();
}

void HairPanel::drawValues(const HairView& hair) {
  hair::HairValues values = hair.scalps[hair.selected].values;
  const char* group = "";
  ImGui::PushID(static_cast<int>(hair.selected));
  for (const hair::HairField& field : hair::hairFields()) {
    if (std::strcmp(group, field.group) != 0) ImGui::TextDisabled("%s", group = field.group);
    const std::optional<double> changed = drawValue(field, field.get(values), tooltips_ ? hair::tooltipOf(field) : "");
    Warnings clamped;
    if (changed) settings::setField(values, field, *changed, clamped);
  }
  ImGui::PopID();
  changed_ = values != hair.scalps[hair.selected].values;
  if (changed_) commands_.push_back(command::SetHairValues{hair.selected, values});
}

}  // namespace fur::editor
