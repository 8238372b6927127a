#include "editor/HairPanel.h"

#include <cstdio>
#include <cstring>
#include <utility>

#include "core/NoteChange.h"
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
    drawValues(model.hair);
    drawSaving(model.hair.scalps[model.hair.selected]);
  }
  drawBodies(model);
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
  if (noteChange(shownGuides_, scalp.guides) && scalp.guides > 0) guides_ = static_cast<int>(scalp.guides);
  fillSlider("##guides", guides_, 3, 1024);
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
  const int more = segments("guideMores", {{"Mirror", false}, {"Bundle", false}});
  hint("Mirror: the guides at +x, and the same at -x. Bundle: they run side by side as one round bundle, as a tail");
  if (more == 0) edit(HairEdit::Mirror, 1);
  if (more == 1) edit(HairEdit::Bundle, 1);
  drawGuideCounts(scalp);
}

// What tools leave alone, and what does not swing.
void HairPanel::drawGuideCounts(const ScalpView& scalp) {
  char text[96];
  std::snprintf(text, sizeof text, "%zu shown, %zu hidden; %zu held still", scalp.guides - scalp.hidden, scalp.hidden, scalp.held);
  rowLabel("Of them");
  ImGui::AlignTextToFramePadding();
  ImGui::TextUnformatted(text);
  hint("Tools work on guides that are shown; hidden ones are protected from them. Held guides keep their shape and do not swing");
  ImGui::Dummy(ImVec2(0, 0));
  ImGui::SameLine(px(80));
  const int swing = segments("guideSwings", {{"Hold all still", false}, {"Let all swing", false}});
  hint("Hold all still: those that are shown. Let all swing: hidden ones as well");
  if (swing == 0) edit(HairEdit::HoldAll);
  if (swing == 1) edit(HairEdit::FreeAll);
  ImGui::Dummy(ImVec2(0, 0));
  ImGui::SameLine(px(80));
  const int shown = segments("guideShows", {{"Show all", false}, {"Invert hidden", false}});
  hint("Invert hidden: shows what is hidden, and hides what is shown. The tool Hide hides what one paints over");
  if (shown == 0) edit(HairEdit::ShowAll);
  if (shown == 1) edit(HairEdit::InvertHidden);
}

// At the end, as a file is made of what is there.
void HairPanel::drawSaving(const ScalpView& scalp) {
  ImGui::BeginDisabled(scalp.wisps == 0);
  if (ImGui::Button(scene::saveLabel(scene::Format::Hair).c_str(), ImVec2(-1, 0))) commands_.push_back(command::SaveHair{});
  ImGui::EndDisabled();
  hint("All strands of this scalp, for other programs. A .hair file that is opened becomes guides of this scalp, or of a new one");
}

void HairPanel::drawBodies(const EditorModel& model) {
  const HairView& hair = model.hair;
  ImGui::TextDisabled("Collision shapes");
  hint("Spheres and capsules that hair does not enter: a head, a neck, shoulders. They go with the model");
  if (const auto tool = toolRow("bodies", model.tool)) commands_.push_back(command::SetTool{*tool});
  hint(app::wordsOf(Tool::HairShape).tooltip);
  rowLabel("Radius");
  ImGui::SetNextItemWidth(-1);
  fillSlider("##bodyRadius", bodyRadius_, 0.05f, 1.5f, "%.2f", false);
  hint("Of those that are added next");
  rowLabel("Add inside");
  const int inside = segments("bodyCentres", {{"Sphere", false}, {"Capsule", false}});
  hint("Round the middle of the model; then drag it where it belongs");
  if (inside >= 0) {
    edit(inside == 0 ? HairEdit::AddSphere : HairEdit::AddCapsule, bodyRadius_);
    commands_.push_back(command::SetTool{Tool::HairShape});
  }
  rowLabel("Add at click");
  const Selects waits = model.groom.selects;
  const int placed = segments("bodyPlaces", {{"Sphere", waits == Selects::Sphere}, {"Capsule", waits == Selects::Capsule}});
  hint("Then click on the model where its middle is to be (Esc: not)");
  if (placed == 0) commands_.push_back(command::SelectAt{waits == Selects::Sphere ? Selects::Nothing : Selects::Sphere, bodyRadius_});
  if (placed == 1) commands_.push_back(command::SelectAt{waits == Selects::Capsule ? Selects::Nothing : Selects::Capsule, bodyRadius_});
  ImGui::BeginDisabled(!hair.bones);
  if (ImGui::Button("Fit to bones", ImVec2(-1, 0))) edit(HairEdit::FitBones);
  ImGui::EndDisabled();
  hint(hair.bones ? "A capsule for each bone, as thick as what it holds, which goes with it; in place of all others" : "This model has no bones");
  if (hair.bodies.empty()) return;
  if (hair.selectedBody >= 0) drawBody(static_cast<std::size_t>(hair.selectedBody), hair.bodies[static_cast<std::size_t>(hair.selectedBody)]);
  char text[48];
  std::snprintf(text, sizeof text, "Clear all %zu###clearBodies", hair.bodies.size());
  const float gap = px(3), half = (ImGui::GetContentRegionAvail().x - gap) * 0.5f;
  ImGui::BeginDisabled(hair.selectedBody < 0);
  if (ImGui::Button("Remove##body", ImVec2(half, 0))) edit(HairEdit::RemoveBody);
  ImGui::EndDisabled();
  ImGui::SameLine(0, gap);
  if (ImGui::Button(text, ImVec2(-1, 0))) edit(HairEdit::ClearBodies);
}

// The numbers of the one that is selected.
void HairPanel::drawBody(std::size_t index, const hair::Body& body) {
  constexpr float kFar = 3;
  const bool capsule = body.a != body.b;
  Vec3 middle = 0.5f * (body.a + body.b), reach = 0.5f * (body.b - body.a);
  hair::Body next = body;
  const float gap = px(3);
  const auto row = [&](const char* label, Vec3& values, const char* what) {
    rowLabel(label);
    const float width = (ImGui::GetContentRegionAvail().x - 2 * gap) / 3;
    bool changed = false;
    for (int k = 0; k < 3; ++k) {
      ImGui::PushID(k);
      ImGui::PushID(label);
      if (k > 0) ImGui::SameLine(0, gap);
      ImGui::SetNextItemWidth(width);
      changed |= fillSlider("##value", values[k], -kFar, kFar, "%.2f", false);
      hint(what);
      ImGui::PopID();
      ImGui::PopID();
    }
    return changed;
  };
  char text[48];
  std::snprintf(text, sizeof text, "%s %zu%s", capsule ? "Capsule" : "Sphere", index + 1, body.bone >= 0 ? ", goes with a bone" : "");
  ImGui::TextUnformatted(text);
  ImGui::PushID(static_cast<int>(index));
  bool changed = row("Middle", middle, "Where its middle is: x, y, z, in radii of the model");
  if (capsule) changed |= row("Half axis", reach, "From its middle to the centre of its far end: x, y, z");
  rowLabel("Its radius");
  ImGui::SetNextItemWidth(-1);
  changed |= fillSlider("##itsRadius", next.radius, hair::kLeastBody, 2, "%.2f", true);
  ImGui::PopID();
  if (!changed) return;
  next.a = middle - reach;
  next.b = middle + reach;
  changed_ = true;
  commands_.push_back(command::SetBody{index, next});
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
  if (values == hair.scalps[hair.selected].values) return;
  changed_ = true;
  commands_.push_back(command::SetHairValues{hair.selected, values});
}

}  // namespace fur::editor
