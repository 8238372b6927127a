#include "editor/CoatPanel.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "editor/CoatPlots.h"
#include "editor/Theme.h"
#include "editor/Widgets.h"
#include "scene/Formats.h"
#include "settings/FurTypes.h"
#include "settings/Presets.h"

namespace fur::editor {

namespace {

// Coats that grow faster than this come without a word: a bar that flashes up says nothing.
constexpr float kQuietSeconds = 0.5f;
constexpr float kFinAspect = 3;  // the tile is as wide as three heights of the coat
constexpr const char* kChannelNames[kTileChannels] = {"Coverage", "Dominance", "Variance",
                                                      "Tangent",  "Offset",    "Strand"};

// The next seed of a cycle through all 65536 (Knuth, TAOCP 2, 3.2.1.2, theorem A): no coat comes twice before
// all came.
int shuffledSeed(int seed) {
  return static_cast<int>((static_cast<unsigned>(seed) * 25173u + 13849u) & 0xffffu);
}

// Beside the list, not over it.
void describe(const settings::Preset& preset) {
  ImGui::SetNextWindowPos(ImVec2(ImGui::GetWindowPos().x - px(4), ImGui::GetItemRectMin().y), 0,
                          ImVec2(1, 0));
  ImGui::BeginTooltip();
  ImGui::PushTextWrapPos(px(220));
  ImGui::TextUnformatted(preset.description);
  ImGui::PopTextWrapPos();
  ImGui::EndTooltip();
}

void drawSeed(int& seed, bool tooltips) {
  const settings::Field& field = *settings::findField("seed");
  const int low = static_cast<int>(field.low), high = static_cast<int>(field.high);
  const float side = ImGui::GetFrameHeight(), gap = px(3), left = ImGui::GetCursorPosX();
  ImGui::AlignTextToFramePadding();
  ImGui::PushStyleColor(ImGuiCol_Text, color::kDim);
  ImGui::TextUnformatted("Seed");
  ImGui::PopStyleColor();
  ImGui::SameLine(left + px(48));
  const auto hint = [&](const char* text) { return tooltips ? text : ""; };
  if (iconButton("##lower", Icon::Minus, hint("The seed before"), seed > low)) --seed;
  ImGui::SameLine(0, gap);
  ImGui::SetNextItemWidth(ImGui::GetContentRegionAvail().x - 2 * (side + gap));
  ImGui::DragInt("##seed", &seed, 0.2f, low, high, "%d", ImGuiSliderFlags_AlwaysClamp);
  ImGui::SameLine(0, gap);
  if (iconButton("##higher", Icon::Plus, hint("The seed after"), seed < high)) ++seed;
  ImGui::SameLine(0, gap);
  if (iconButton("##dice", Icon::Dice, hint("New seed: another coat of the same kind")))
    seed = shuffledSeed(seed);
}

// As many whole pixels a texel, or texels a pixel, as fit: then all are of one size.
float evenSide(float room, int texels) {
  if (texels <= 0) return std::floor(room);
  const auto size = static_cast<float>(texels);
  return room >= size ? size * std::floor(room / size) : size / std::ceil(size / room);
}

}  // namespace

int CoatPanel::layerOf(int layers) const {
  return static_cast<int>(std::lround(height_ * static_cast<float>(std::max(layers - 1, 0))));
}

void CoatPanel::setLayer(int layer, int layers) {
  height_ = static_cast<float>(layer) / static_cast<float>(std::max(layers - 1, 1));
}

std::vector<Command> CoatPanel::draw(const EditorModel& model, settings::Settings& edited,
                                     const Manner& manner) {
  std::vector<Command> commands;
  shown_.reset();
  countTime(model.coat);
  ImGui::SetNextItemOpen(true, ImGuiCond_FirstUseEver);
  if (!groupHeader("Coat")) return commands;
  drawType(model, edited, manner.tooltips);
  drawPresets(model, edited, manner.tooltips, commands);
  drawOwnCoats(model, commands);
  drawSeed(edited.seed, manner.tooltips);
  drawStrands(model);
  ImGui::SetNextItemOpen(manner.roomy, ImGuiCond_FirstUseEver);
  if (groupHeader("Tile, layer by layer")) drawPictures(model.coat, manner);
  const float half = (ImGui::GetContentRegionAvail().x - px(3)) * 0.5f;
  if (ImGui::Button(scene::saveLabel(scene::Format::Fts).c_str(), ImVec2(half, 0))) commands.push_back(command::SaveTypeSet{});
  ImGui::SameLine(0, px(3));
  if (ImGui::Button(scene::saveLabel(scene::Format::Fo).c_str(), ImVec2(-1, 0))) commands.push_back(command::SaveFo{});
  ImGui::Dummy(ImVec2(0, px(2)));
  return commands;
}

// Coats to choose from: bald, where the type can be, those that ship, one's own.
void CoatPanel::drawPresets(const EditorModel& model, settings::Settings& edited, bool tooltips, std::vector<Command>& commands) {
  const settings::Settings coat = settings::typeCoat(model.settings, type_);
  const settings::Preset* current = settings::presetOf(coat);
  ImGui::SetNextItemWidth(-1);
  if (!ImGui::BeginCombo("##preset", current ? current->label : coat.density > 0 ? "Custom coat" : "Bald", ImGuiComboFlags_HeightLargest)) return;
  ImGui::PushStyleVar(ImGuiStyleVar_SelectableTextAlign, ImVec2(0, 0.5f));
  const ImVec2 size(0, tooltips ? 0 : ImGui::GetFrameHeight());
  if (type_ && ImGui::Selectable("Bald", false, 0, size)) settings::makeBald(edited, type_);
  for (const settings::Preset& preset : settings::presets()) {
    if (ImGui::Selectable(preset.label, &preset == current, 0, size)) commands.push_back(command::ApplyPreset{preset.name, type_});
    if (tooltips && ImGui::IsItemHovered()) describe(preset);
  }
  if (!model.ownCoats.empty()) ImGui::Separator();
  for (const OwnCoatView& own : model.ownCoats) {
    ImGui::PushID(own.id.c_str());
    if (ImGui::Selectable(own.name.c_str(), false, 0, size)) commands.push_back(command::WearCoat{own.id});
    ImGui::PopID();
  }
  ImGui::PopStyleVar();
  ImGui::EndCombo();
}

void CoatPanel::drawOwnCoats(const EditorModel& model, std::vector<Command>& commands) {
  if (!groupHeader("Own coats")) return;
  char standard[settings::kTypeNameBytes];
  const std::string_view name = settings::typeName(model.settings, type_);
  if (name.empty()) std::snprintf(standard, sizeof standard, "Coat %d", static_cast<int>(model.ownCoats.size()) + 1);
  else std::snprintf(standard, sizeof standard, "%s", name.data());
  if (std::string kept = newName_.draw("##coatName", "Keep##coat", standard); !kept.empty()) commands.push_back(command::KeepCoat{std::move(kept)});
  for (const OwnCoatView& own : model.ownCoats) {
    ImGui::PushID(own.id.c_str());
    const KeptRows::Pressed pressed = ownRows_.draw(own.id, own.name, "", {"Wear", "File"});
    if (pressed.button == 0) commands.push_back(command::WearCoat{own.id});
    if (pressed.button == 1) commands.push_back(command::SaveOwnCoat{own.id});
    if (!pressed.name.empty()) commands.push_back(command::RenameCoat{own.id, pressed.name});
    if (pressed.deletes) commands.push_back(command::DeleteCoat{own.id});
    ImGui::PopID();
  }
  ImGui::Dummy(ImVec2(0, px(2)));
}

// Which type is edited here and in the rows of settings; its name; what it has from files.
void CoatPanel::drawType(const EditorModel& model, settings::Settings& edited, bool tooltips) {
  if (const int picked = segments("coatTypes", {{"Type 1", type_ == 0}, {"2", type_ == 1}, {"3", type_ == 2}, {"4", type_ == 3}}); picked >= 0) type_ = picked;
  if (tooltips && ImGui::IsItemHovered()) ImGui::SetTooltip("The fur type whose coat is edited, here and in all settings below that each type has");
  char name[settings::kTypeNameBytes];
  std::snprintf(name, sizeof name, "%s", settings::typeName(model.settings, type_).data());
  ImGui::SetNextItemWidth(-1);
  ImGui::PushID(type_);
  if (ImGui::InputTextWithHint("##name", "Name of this coat", name, sizeof name)) settings::setTypeName(edited, type_, name);
  ImGui::PopID();
  const auto type = static_cast<std::size_t>(type_);
  const auto file = [&](bool has, const char* what, std::uint32_t& number) {
    if (!has) return;
    ImGui::PushID(what);
    ImGui::AlignTextToFramePadding();
    ImGui::TextUnformatted(what);
    ImGui::SameLine(ImGui::GetContentRegionMax().x - px(18));
    if (iconButton("##without", Icon::Close, tooltips ? "Without it" : "", true, px(18))) number = 0;
    ImGui::PopID();
  };
  file(model.typeGiven[type], "Strands of a .fts", edited.typeSets[type]);
  file(model.typePictured[type], "A colour map", edited.typePictures[type]);
  file(model.skinPictured, "A picture of the skin", edited.typePictures[settings::kSkin]);
}

// While a slider is dragged coat follows coat, each with a time of its own.
void CoatPanel::countTime(const CoatView& coat) {
  const bool same = coat.progress < 1 && coat.revision == revision_;
  growingFor_ = same ? growingFor_ + ImGui::GetIO().DeltaTime : 0;
  revision_ = coat.revision;
}

void CoatPanel::drawStrands(const EditorModel& model) {
  char text[64];
  if (growingFor_ > kQuietSeconds) {
    std::snprintf(text, sizeof text, "Growing: %.0f %%", static_cast<double>(model.coat.progress) * 100);
    ImGui::ProgressBar(model.coat.progress, ImVec2(-1, ImGui::GetFrameHeight()), text);
    return;
  }
  std::snprintf(text, sizeof text, "%d strands in %d layers", model.strands,
                static_cast<int>(model.coat.coverage.size()));
  ImGui::AlignTextToFramePadding();
  ImGui::PushStyleColor(ImGuiCol_Text, color::kDim);
  ImGui::TextUnformatted(text);
  ImGui::PopStyleColor();
}

void CoatPanel::drawChannels() {
  const float toggle = px(64), gap = px(3);
  ImGui::SetNextItemWidth(-toggle - gap);
  const int current = static_cast<int>(channel_);
  if (ImGui::BeginCombo("##channel", kChannelNames[current])) {
    for (int i = 0; i < kTileChannels; ++i)
      if (ImGui::Selectable(kChannelNames[i], i == current)) channel_ = static_cast<TileChannel>(i);
    ImGui::EndCombo();
  }
  ImGui::SameLine(0, gap);
  if (segments("tiles", {{"3 \xc3\x97 3", repeated_}}) == 0) repeated_ = !repeated_;
  if (ImGui::IsItemHovered()) ImGui::SetTooltip("Nine tiles, to see whether the edges meet");
}

void CoatPanel::drawPictures(const CoatView& coat, const Manner& manner) {
  const int layers = static_cast<int>(coat.coverage.size());
  drawChannels();
  // As beside a scrollbar, whether there is one or not: else it might come and go with the height of these.
  const float width = ImGui::GetWindowWidth() - ImGui::GetStyle().ScrollbarSize;
  const float slider = px(28), gap = px(6);
  const float side = evenSide(width - slider - gap, coat.tileSize);
  tilePlot("##tile", {coat.tile, coat.tileSize, repeated_ ? 3 : 1}, side, !manner.tooltips);
  ImGui::SameLine(0, gap);
  int layer = layerOf(layers);
  if (fillSliderUpright("##layer", layer, 0, std::max(layers - 1, 0), ImVec2(width - side - gap, side)))
    setLayer(layer, layers);
  if (manner.tooltips && ImGui::IsItemHovered())
    ImGui::SetTooltip("The layer that is shown: skin at the bottom, tips at the top");
  const float height = static_cast<float>(layer + 1) / static_cast<float>(std::max(layers, 1));
  ImGui::TextDisabled("Layer %d of %d, %.0f %% of the height", layer + 1, layers,
                      static_cast<double>(height) * 100);
  finPlot(coat.fin, ImVec2(width, std::round(width / kFinAspect)), height);
  ImGui::TextDisabled(channel_ == TileChannel::Offset || channel_ == TileChannel::Strand
                          ? "From the side, as on the silhouette (coverage)"
                          : "From the side, as on the silhouette");
  if (const auto pressed =
          coveragePlot("##coverage", coat.coverage, layer, ImVec2(width, px(112)), !manner.tooltips))
    setLayer(*pressed, layers);
  ImGui::Dummy(ImVec2(0, px(2)));
  shown_ = TileView{layerOf(layers), channel_};
}

}  // namespace fur::editor
