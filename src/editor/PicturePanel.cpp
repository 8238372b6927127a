#include "editor/PicturePanel.h"

#include <cstdio>
#include <utility>

#include <imgui.h>

#include "editor/Theme.h"
#include "editor/Widgets.h"

namespace fur::editor {

namespace {

constexpr float kQuickestTurn = 2, kSlowestTurn = 60;

}  // namespace

void PicturePanel::hint(const char* text) const {
  if (tooltips_ && ImGui::IsItemHovered(ImGuiHoveredFlags_AllowWhenDisabled)) ImGui::SetTooltip("%s", text);
}

std::vector<Command> PicturePanel::draw(const EditorModel& model, bool tooltips) {
  commands_.clear();
  tooltips_ = tooltips;
  if (!groupHeader("Picture")) return {};
  if (model.picture.busy) {
    drawProgress(model.picture);
    return std::exchange(commands_, {});
  }
  drawSize(model.picture);
  drawPicture(model.picture);
  drawTurntable(model);
  ImGui::Dummy(ImVec2(0, px(2)));
  return std::exchange(commands_, {});
}

bool PicturePanel::usable(const PictureView& view) const {
  return width_ >= view.leastSide && height_ >= view.leastSide && width_ <= view.mostSide && height_ <= view.mostSide;
}

void PicturePanel::drawSize(const PictureView& view) {
  const int pressed = segments("pictureSizes", {{"As seen", size_ == Size::AsSeen}, {"1080p", size_ == Size::FullHd},
                                                {"4K", size_ == Size::UltraHd}, {"Square", size_ == Size::Square}});
  if (pressed >= 0) size_ = static_cast<Size>(pressed);
  switch (size_) {
    case Size::AsSeen: width_ = view.shownWidth, height_ = view.shownHeight; break;
    case Size::FullHd: width_ = 1920, height_ = 1080; break;
    case Size::UltraHd: width_ = 3840, height_ = 2160; break;
    case Size::Square: width_ = height_ = 2048; break;
    case Size::Own: break;
  }
  rowLabel("Pixels");
  const float cross = ImGui::CalcTextSize("x").x + 2 * px(6), field = (ImGui::GetContentRegionAvail().x - cross) * 0.5f;
  ImGui::SetNextItemWidth(field);
  const bool wider = ImGui::InputInt("##pictureWidth", &width_, 0);
  ImGui::SameLine(0, px(6));
  ImGui::TextUnformatted("x");
  ImGui::SameLine(0, px(6));
  ImGui::SetNextItemWidth(-1);
  const bool higher = ImGui::InputInt("##pictureHeight", &height_, 0);
  if (wider || higher) size_ = Size::Own;
  if (usable(view)) return;
  ImGui::PushStyleColor(ImGuiCol_Text, color::kWarning);
  ImGui::TextWrapped("Each side has %d to %d pixels here.", view.leastSide, view.mostSide);
  ImGui::PopStyleColor();
}

void PicturePanel::drawPicture(const PictureView& view) {
  ImGui::Checkbox("Transparent background", &transparent_);
  hint("Without background and ground; strands at the outline let through what is put behind them");
  ImGui::BeginDisabled(!usable(view));
  if (ImGui::Button("Save picture (.png)", ImVec2(-1, 0))) commands_.push_back(command::SavePicture{width_, height_, transparent_});
  ImGui::EndDisabled();
}

void PicturePanel::drawTurntable(const EditorModel& model) {
  rowLabel("One turn");
  ImGui::SetNextItemWidth(-1);
  fillSlider("##turnSeconds", secondsPerTurn_, kQuickestTurn, kSlowestTurn, "%.0f s", false);
  rowLabel("Turns");
  const int way = segments("turnWays", {{"Right", !leftwards_}, {"Left", leftwards_}});
  if (way >= 0) leftwards_ = way == 1;
  const float seconds = leftwards_ ? -secondsPerTurn_ : secondsPerTurn_;
  const float half = (ImGui::GetContentRegionAvail().x - px(3)) * 0.5f;
  const bool turning = model.picture.turning;
  if (ImGui::Button(turning ? "Stop###turn" : "Turn once###turn", ImVec2(half, 0))) {
    if (turning) commands_.push_back(command::StopPicture{});
    else commands_.push_back(command::TurnOnce{seconds});
  }
  ImGui::SameLine(0, px(3));
  const bool film = model.fileAccess == FileAccess::Dialog;
  ImGui::BeginDisabled(!usable(model.picture));
  if (ImGui::Button(film ? "Save video" : "Save frames (.png)", ImVec2(-1, 0)))
    commands_.push_back(command::SaveTurntable{width_, height_, transparent_ && !film, seconds});
  ImGui::EndDisabled();
  hint(film ? "One turn at the size above, before the background" : "One turn at the size above, as numbered pictures");
}

void PicturePanel::drawProgress(const PictureView& view) {
  const float button = px(64), gap = px(3);
  char text[32];
  std::snprintf(text, sizeof text, "%.0f %%", static_cast<double>(view.progress) * 100);
  ImGui::ProgressBar(view.progress, ImVec2(-button - gap, ImGui::GetFrameHeight()), text);
  ImGui::SameLine(0, gap);
  if (ImGui::Button("Cancel", ImVec2(-1, 0))) commands_.push_back(command::StopPicture{});
}

}  // namespace fur::editor
