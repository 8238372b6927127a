#include "editor/CoatPlots.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "core/Math.h"
#include "editor/Theme.h"

namespace fur::editor {

namespace {

constexpr ImU32 kGround = IM_COL32(0, 0, 0, 90);
constexpr ImU32 kEdge = IM_COL32(255, 255, 255, 40);
constexpr ImU32 kMark = IM_COL32(255, 226, 150, 230);
constexpr int kLoupeTexels = 15;  // odd: one is in the middle

// The next item; returns whether a mouse is over it.
bool place(const char* id, ImVec2 size, bool deaf) {
  if (deaf)
    ImGui::Dummy(size);
  else
    ImGui::InvisibleButton(id, size);
  return !deaf && ImGui::IsItemHovered();
}

void frameAround(ImDrawList& list, ImVec2 low, ImVec2 high) { list.AddRect(low, high, kEdge, 0, 0, px(1)); }

// `at`: of the texture, in tiles.
void loupe(const TilePlot& plot, Vec2 at) {
  const float texel = px(9), side = texel * kLoupeTexels;
  const Vec2 middle = glm::floor(glm::fract(at) * static_cast<float>(plot.texels));
  const float reach = (kLoupeTexels - 1) * 0.5f, scale = 1.0f / static_cast<float>(plot.texels);
  const Vec2 from = (middle - reach) * scale, to = (middle + reach + 1.0f) * scale;
  ImGui::BeginTooltip();
  const ImVec2 low = ImGui::GetCursorScreenPos();
  ImGui::Image(plot.texture, ImVec2(side, side), ImVec2(from.x, from.y), ImVec2(to.x, to.y));
  const ImVec2 mark(low.x + reach * texel, low.y + reach * texel);
  ImGui::GetWindowDrawList()->AddRect(mark, ImVec2(mark.x + texel, mark.y + texel), kMark, 0, 0, px(1));
  ImGui::TextDisabled("texel %.0f, %.0f", static_cast<double>(middle.x), static_cast<double>(middle.y));
  ImGui::EndTooltip();
}

struct PlotFrame {
  ImVec2 low, high;
  std::size_t layers;
  float top(std::size_t layer) const {
    return high.y - (high.y - low.y) * static_cast<float>(layer + 1) / static_cast<float>(layers);
  }
  float bottom(std::size_t layer) const {
    return high.y - (high.y - low.y) * static_cast<float>(layer) / static_cast<float>(layers);
  }
  float right(float share) const { return low.x + (high.x - low.x) * saturate(share); }
  int layerAt(float y) const {
    const float height = saturate((high.y - y) / (high.y - low.y));
    return std::min(static_cast<int>(height * static_cast<float>(layers)), static_cast<int>(layers) - 1);
  }
};

void drawAxes(ImDrawList& list, const PlotFrame& frame, float left) {
  const float line = ImGui::GetFontSize();
  list.AddText(ImVec2(left, frame.low.y - line * 0.2f), color::kDim, "tip");
  list.AddText(ImVec2(left, frame.high.y - line * 0.9f), color::kDim, "skin");
  const struct {
    float share;
    const char* label;
  } ticks[] = {{0, "0"}, {0.5f, "50"}, {1, "100 % covered"}};
  for (const auto& tick : ticks) {
    const float x = frame.right(tick.share);
    list.AddLine(ImVec2(x, frame.low.y), ImVec2(x, frame.high.y), kEdge, px(1));
    // The outer labels end where the plot ends.
    const float shift =
        tick.share == 0 ? 0 : ImGui::CalcTextSize(tick.label).x * (tick.share == 1 ? 1 : 0.5f);
    list.AddText(ImVec2(x - shift, frame.high.y + px(2)), color::kDim, tick.label);
  }
}

}  // namespace

void tilePlot(const char* id, const TilePlot& plot, float side, bool deaf) {
  const ImVec2 low = ImGui::GetCursorScreenPos(), high(low.x + side, low.y + side);
  const bool hovered = place(id, ImVec2(side, side), deaf);
  ImDrawList& list = *ImGui::GetWindowDrawList();
  list.AddRectFilled(low, high, kGround);
  const auto tiles = static_cast<float>(plot.tiles);
  if (plot.texture) list.AddImage(plot.texture, low, high, ImVec2(0, 0), ImVec2(tiles, tiles));
  frameAround(list, low, high);
  const ImVec2 mouse = ImGui::GetIO().MousePos;
  if (hovered && plot.texture) loupe(plot, (Vec2(mouse.x, mouse.y) - Vec2(low.x, low.y)) / side * tiles);
}

void finPlot(ImTextureID texture, ImVec2 size, float height) {
  const ImVec2 low = ImGui::GetCursorScreenPos(), high(low.x + size.x, low.y + size.y);
  ImGui::Dummy(size);
  ImDrawList& list = *ImGui::GetWindowDrawList();
  list.AddRectFilled(low, high, kGround);
  if (texture) list.AddImage(texture, low, high, ImVec2(0, 1), ImVec2(1, 0));
  const float y = high.y - size.y * height;
  list.AddLine(ImVec2(low.x, y), ImVec2(high.x, y), kMark, px(1));
  frameAround(list, low, high);
}

std::optional<int> coveragePlot(const char* id, std::span<const float> shares, int layer, ImVec2 size,
                                bool deaf) {
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const float labels = ImGui::CalcTextSize("skin").x + px(6), axis = ImGui::GetFontSize() + px(3);
  const bool hovered = place(id, size, deaf);
  if (shares.empty()) return {};
  const PlotFrame frame{ImVec2(at.x + labels, at.y), ImVec2(at.x + size.x, at.y + size.y - axis),
                        shares.size()};
  const int pointed = frame.layerAt(ImGui::GetIO().MousePos.y);
  ImDrawList& list = *ImGui::GetWindowDrawList();
  list.AddRectFilled(frame.low, frame.high, kGround);
  for (std::size_t i = 0; i < shares.size(); ++i) {
    const bool lit = hovered && static_cast<int>(i) == pointed;
    const ImU32 fill = static_cast<int>(i) == layer ? kMark : lit ? color::kText : color::kAccent;
    list.AddRectFilled(ImVec2(frame.low.x, frame.top(i)), ImVec2(frame.right(shares[i]), frame.bottom(i)),
                       fill);
  }
  drawAxes(list, frame, at.x);
  if (hovered) {
    const auto share = static_cast<double>(shares[static_cast<std::size_t>(pointed)]);
    ImGui::SetTooltip("Layer %d of %d: %.1f %% covered", pointed + 1, static_cast<int>(shares.size()),
                      share * 100);
  }
  if (!deaf && ImGui::IsItemActive()) return pointed;
  return {};
}

}  // namespace fur::editor
