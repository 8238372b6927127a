#include "editor/Icons.h"

#include <cmath>
#include <initializer_list>
#include <utility>

#include "core/Math.h"

namespace fur::editor {

namespace {

// A pen in a square from -1 to 1, y down.
struct Pen {
  ImDrawList& list;
  ImVec2 center;
  float half, thickness;
  ImU32 color;

  ImVec2 at(float x, float y) const { return {center.x + x * half, center.y + y * half}; }
  void line(float x0, float y0, float x1, float y1) const {
    list.AddLine(at(x0, y0), at(x1, y1), color, thickness);
  }
  void arc(float x, float y, float radius, float from, float to) const {
    list.PathArcTo(at(x, y), radius * half, from, to, 20);
    list.PathStroke(color, 0, thickness);
  }
  void triangle(float x0, float y0, float x1, float y1, float x2, float y2) const {
    list.AddTriangleFilled(at(x0, y0), at(x1, y1), at(x2, y2), color);
  }
};

// side -1: back, 1: forth
void drawTurn(const Pen& pen, float side) {
  pen.line(-0.7f * side * -1, -0.25f, -0.15f * side, -0.25f);
  pen.arc(-0.15f * side, 0.25f, 0.5f, side > 0 ? kPi * 0.5f : -kPi * 0.5f,
          side > 0 ? kPi * 1.5f : kPi * 0.5f);
  pen.line(-0.15f * side, 0.75f, 0.35f * side, 0.75f);
  pen.triangle(0.95f * side, -0.25f, 0.4f * side, -0.72f, 0.4f * side, 0.22f);
}

void drawDroplet(const Pen& pen) {
  pen.list.PathLineTo(pen.at(0, -0.95f));
  pen.list.PathBezierCubicCurveTo(pen.at(0.25f, -0.45f), pen.at(0.68f, -0.05f), pen.at(0.68f, 0.32f), 12);
  pen.list.PathArcTo(pen.at(0, 0.27f), 0.68f * pen.half, 0.07f, kPi - 0.07f, 16);
  pen.list.PathBezierCubicCurveTo(pen.at(-0.68f, -0.05f), pen.at(-0.25f, -0.45f), pen.at(0, -0.95f), 12);
  pen.list.PathStroke(pen.color, 0, pen.thickness);
}

void drawSun(const Pen& pen) {
  pen.list.AddCircle(pen.center, 0.42f * pen.half, pen.color, 20, pen.thickness);
  for (int ray = 0; ray < 8; ++ray) {
    const float angle = static_cast<float>(ray) * kPi / 4;
    const float x = std::cos(angle), y = std::sin(angle);
    pen.line(0.68f * x, 0.68f * y, 0.95f * x, 0.95f * y);
  }
}

// Arrows to the four sides.
void drawCross(const Pen& pen) {
  pen.line(-0.6f, 0, 0.6f, 0);
  pen.line(0, -0.6f, 0, 0.6f);
  for (const float side : {-1.0f, 1.0f}) {
    pen.triangle(side, 0, 0.55f * side, -0.35f, 0.55f * side, 0.35f);
    pen.triangle(0, side, -0.35f, 0.55f * side, 0.35f, 0.55f * side);
  }
}

}  // namespace

std::optional<Icon> iconNamed(std::string_view name) {
  constexpr std::pair<std::string_view, Icon> kNamed[] = {{"droplet", Icon::Droplet}, {"dry", Icon::Dry}, {"move", Icon::Move}, {"orbit", Icon::Orbit}};
  for (const auto& [known, icon] : kNamed)
    if (known == name) return icon;
  return std::nullopt;
}

void drawIcon(ImDrawList& list, Icon icon, ImVec2 center, float size, ImU32 color) {
  const Pen pen{list, center, size * 0.5f, std::fmax(1.2f, size * 0.11f), color};
  switch (icon) {
    case Icon::Undo:
      drawTurn(pen, -1);
      break;
    case Icon::Redo:
      drawTurn(pen, 1);
      break;
    case Icon::Reset:
      pen.arc(0, 0.05f, 0.7f, -kPi * 0.35f, kPi * 1.2f);
      pen.triangle(-0.05f, -0.7f, 0.55f, -1.0f, 0.5f, -0.3f);
      break;
    case Icon::Camera:  // a frame with its four corners
      for (const float x : {-1.0f, 1.0f})
        for (const float y : {-1.0f, 1.0f}) {
          pen.line(0.85f * x, 0.85f * y, 0.35f * x, 0.85f * y);
          pen.line(0.85f * x, 0.85f * y, 0.85f * x, 0.35f * y);
        }
      list.AddCircleFilled(center, 0.24f * pen.half, color, 16);
      break;
    case Icon::ChevronDown:
      pen.line(-0.6f, -0.3f, 0, 0.35f);
      pen.line(0, 0.35f, 0.6f, -0.3f);
      break;
    case Icon::ChevronUp:
      pen.line(-0.6f, 0.3f, 0, -0.35f);
      pen.line(0, -0.35f, 0.6f, 0.3f);
      break;
    case Icon::Close:
      pen.line(-0.55f, -0.55f, 0.55f, 0.55f);
      pen.line(-0.55f, 0.55f, 0.55f, -0.55f);
      break;
    case Icon::Droplet:
      drawDroplet(pen);
      break;
    case Icon::Dry:
      drawSun(pen);
      break;
    case Icon::Move:
      drawCross(pen);
      break;
    case Icon::Plus:
      pen.line(0, -0.6f, 0, 0.6f);
      [[fallthrough]];
    case Icon::Minus:
      pen.line(-0.6f, 0, 0.6f, 0);
      break;
    case Icon::Dice:
      list.AddRect(pen.at(-0.85f, -0.85f), pen.at(0.85f, 0.85f), color, 0.3f * pen.half, 0, pen.thickness);
      for (const float x : {-0.42f, 0.42f})
        for (const float y : {-0.42f, 0.42f}) list.AddCircleFilled(pen.at(x, y), 0.17f * pen.half, color, 10);
      list.AddCircleFilled(center, 0.17f * pen.half, color, 10);
      break;
    case Icon::Orbit:
      pen.list.AddCircle(pen.center, 0.85f * pen.half, color, 24, pen.thickness);
      pen.arc(0, -0.55f, 1.0f, kPi * 0.2f, kPi * 0.8f);
      list.AddCircleFilled(pen.at(0.55f, 0.25f), 0.2f * pen.half, color, 12);
      break;
  }
}

}  // namespace fur::editor
