#include "app/editor/EditModes.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include <imgui.h>

#include "app/stages/ShapeStage.h"

namespace fur::app {

namespace {

// A pointer that moves less only clicks; so far off its line a whisker is met; CSS pixels.
constexpr float kClick = 4, kReach = 9, kFingerReach = 20;
// A drag of so many CSS pixels goes through all lengths of fur, or makes a whisker e times as long.
constexpr float kLengthDrag = 200;
// What one press of a key does.
constexpr float kLengthStep = 0.05f, kLonger = 1.1f, kTurn = 0.1f;
constexpr float kDegrees = 180 / kPi;
constexpr ImU32 kChosen = IM_COL32(255, 190, 80, 255), kEdge = IM_COL32(0, 0, 0, 150);

// Up the model along the skin, and to the right of that as seen from above.
struct Compass {
  explicit Compass(const Vec3& normal)
      : up(normalizeOr(Vec3(0, 1, 0) - normal * normal.y, axesOn(normal).first)), right(glm::cross(up, normal)) {}
  Vec3 up, right;
};

editor::LeanView leanOf(float radians, const Vec3& way, const Vec3& normal) {
  const Compass compass(normal);
  const float heading = std::atan2(glm::dot(way, compass.right), glm::dot(way, compass.up));
  return {radians * kDegrees, radians > 1e-3f ? heading * kDegrees : 0};
}
// Unit, along the skin.
Vec3 wayOf(const editor::LeanView& lean, const Vec3& normal) {
  const Compass compass(normal);
  return compass.up * std::cos(lean.heading / kDegrees) + compass.right * std::sin(lean.heading / kDegrees);
}

editor::PointView viewOf(const FurAt& at) {
  editor::PointView view;
  view.length = at.length;
  view.comb = leanOf(glm::length(at.comb), at.comb, at.normal);
  std::copy(at.types.begin(), at.types.end(), view.types);
  view.wetness = at.wetness;
  return view;
}

bool isRight(const PointerEvent& event) { return event.kind == PointerKind::Mouse && (event.buttons & 2); }

void drawLine(const std::vector<Vec2>& line, bool closed, float width) {
  std::vector<ImVec2> points;
  for (const Vec2& point : line) points.emplace_back(point.x, point.y);
  ImDrawList& list = *ImGui::GetBackgroundDrawList();
  const ImDrawFlags flags = closed ? ImDrawFlags_Closed : ImDrawFlags_None;
  list.AddPolyline(points.data(), static_cast<int>(points.size()), kEdge, flags, width + 2);
  list.AddPolyline(points.data(), static_cast<int>(points.size()), kChosen, flags, width);
}

void drawDot(Vec2 at, float radius) {
  ImDrawList& list = *ImGui::GetBackgroundDrawList();
  list.AddCircleFilled({at.x, at.y}, radius + 1, kEdge);
  list.AddCircleFilled({at.x, at.y}, radius, kChosen);
}

// Beside the pointer.
void drawNumbers(const FurAt& at, Vec2 pixel, float ratio) {
  const editor::PointView view = viewOf(at);
  const int type = 1 + static_cast<int>(std::max_element(at.types.begin(), at.types.end()) - at.types.begin());
  char text[80];
  std::snprintf(text, sizeof text, "length %.2f\nlean %.0f deg\ntype %d\nwet %.0f %%", static_cast<double>(view.length),
                static_cast<double>(view.comb.lean), type, static_cast<double>(view.wetness) * 100);
  const ImVec2 size = ImGui::CalcTextSize(text), room = ImGui::GetIO().DisplaySize;
  const float gap = 18 * ratio, pad = 6 * ratio;
  const ImVec2 from(std::min(pixel.x + gap, room.x - size.x - 2 * pad), std::min(pixel.y + gap, room.y - size.y - 2 * pad));
  ImDrawList& list = *ImGui::GetBackgroundDrawList();
  list.AddRectFilled(from, ImVec2(from.x + size.x + 2 * pad, from.y + size.y + 2 * pad), IM_COL32(20, 24, 30, 200), pad);
  list.AddText(ImVec2(from.x + pad, from.y + pad), IM_COL32(240, 244, 248, 255), text);
}

}  // namespace

// --- pointers ---

bool EditModes::press(const PointerEvent& event, float pixelRatio) {
  if (event.control || event.shift || event.alt || !(event.buttons & 3)) return false;
  // A free camera looks round with the right button.
  if (isRight(event) && app_.settings().cameraMode > 0) return false;
  pixelRatio_ = pixelRatio;
  from_ = event.position;
  moved_ = false;
  const bool taken = app_.tool() == Tool::Edit ? pressEdit(event) : app_.tool() == Tool::Whisker && pressWhisker(event);
  used_ |= taken;
  return taken;
}

bool EditModes::pressEdit(const PointerEvent& event) {
  const auto at = app_.furAt(event.position);
  if (!at) return false;
  fromPlace_ = at->place;
  hover_ = event.position;
  choosePoint(*at);
  gesture_ = isRight(event) ? Gesture::Length : Gesture::Comb;
  before_ = at->length;
  return true;
}

bool EditModes::pressWhisker(const PointerEvent& event) {
  const float reach = (event.kind == PointerKind::Touch ? kFingerReach : kReach) * pixelRatio_;
  if (const auto met = app_.whiskerAt(event.position, reach)) {
    choose(*met);
    gesture_ = isRight(event) ? Gesture::WhiskerLength : Gesture::Aim;
    before_ = app_.groom().whiskers[*met].length;
    return true;
  }
  if (isRight(event)) return false;
  app_.beginChange();
  const auto planted = app_.plantWhisker(event.position);
  if (!planted) {
    app_.endChange();
    whiskerRoot_.reset();
    return false;
  }
  choose(*planted);
  gesture_ = Gesture::AimPlanted;
  return true;
}

void EditModes::drag(const PointerEvent& event) {
  if (gesture_ == Gesture::None) return;
  const Vec2 way = event.position - from_;
  if (!moved_ && glm::length(way) < kClick * pixelRatio_) return;
  if (!moved_ && gesture_ != Gesture::AimPlanted) app_.beginChange();
  moved_ = true;
  hover_ = event.position;
  const float up = -way.y / (kLengthDrag * pixelRatio_);
  switch (gesture_) {
    case Gesture::Comb: {
      const auto at = app_.furAt(event.position);
      const auto chosen = point_ ? app_.furAt(*point_) : std::nullopt;
      if (!at || !chosen) break;
      const Vec3 along = at->place - fromPlace_;
      const float share = std::min(glm::length(along) / app_.settings().brushRadius, 1.0f);
      app_.setFurAt(*point_, FurNumber::Comb, 0, normalizeOr(along - chosen->normal * glm::dot(along, chosen->normal), Vec3(0)) * (share * groom::kMaxComb));
      break;
    }
    case Gesture::Length:
      if (point_) app_.setFurAt(*point_, FurNumber::Length, saturate(before_ + up));
      break;
    case Gesture::Aim:
      if (const auto index = whisker()) app_.aimWhisker(*index, event.position);
      break;
    case Gesture::AimPlanted: app_.aimPlanted(event.position); break;
    case Gesture::WhiskerLength:
      changeWhisker([&](groom::Whisker& one) { one.length = before_ * std::exp(up); });
      break;
    case Gesture::None: break;
  }
}

void EditModes::release() {
  if (gesture_ != Gesture::None && (moved_ || gesture_ == Gesture::AimPlanted)) app_.endChange();
  gesture_ = Gesture::None;
}

// --- keys ---

bool EditModes::key(std::string_view name, bool down, const editor::Modifiers& modifiers) {
  std::string lower(name);
  if (lower.size() == 1 && lower[0] >= 'A' && lower[0] <= 'Z') lower[0] = static_cast<char>(lower[0] - 'A' + 'a');
  if (modifiers.control || modifiers.alt) return false;
  const bool isMode = lower == "e" || lower == "w", isPart = lower == "b" || lower == "s" || lower == "f";
  if (isMode || isPart) {
    if (!down && held_ != lower) return false;
    const bool repeats = down && held_ == lower;
    held_ = down ? lower : "";
    if (repeats) return true;
    return isMode ? modeKey(lower, down) : !down || toggle(lower);
  }
  if (!down) return false;
  if (lower.size() == 1 && lower[0] >= '1' && lower[0] <= '4') {
    if (app_.tool() == Tool::Edit && point_) set({FurNumber::Type, static_cast<float>(lower[0] - '0')});
    else app_.setField("groomType", lower);
    used_ = true;
    return true;
  }
  if (app_.tool() == Tool::Edit) return keyOfPoint(lower, modifiers.shift);
  return app_.tool() == Tool::Whisker && keyOfWhisker(lower, modifiers.shift);
}

bool EditModes::modeKey(std::string_view name, bool down) {
  const Tool mode = name == "e" ? Tool::Edit : Tool::Whisker;
  if (!down) {
    if (used_ && app_.tool() == mode) app_.setTool(toolBefore_);
    return true;
  }
  used_ = false;
  if (app_.tool() == mode) {
    app_.setTool(toolBefore_);
    return true;
  }
  // From one mode to the other: the way back is out of both.
  if (app_.tool() != Tool::Edit && app_.tool() != Tool::Whisker) toolBefore_ = app_.tool();
  app_.setTool(mode);
  return true;
}

bool EditModes::toggle(std::string_view name) {
  const settings::Settings& now = app_.settings();
  const bool shown = name == "b" ? now.skin : name == "s" ? now.shells : now.fins;
  return app_.setField(name == "b" ? "skin" : name == "s" ? "shells" : "fins", shown ? "false" : "true");
}

bool EditModes::keyOfPoint(std::string_view name, bool shift) {
  if (name == " ") {
    if (const auto at = app_.furAt(app_.cursor())) choosePoint(*at);
    return true;
  }
  if (!point_) return false;
  if (name == "Escape") return point_.reset(), true;
  const bool shorter = name == "{" || (shift && name == "["), longer = name == "}" || (shift && name == "]");
  if (!shorter && !longer) return false;
  if (const auto at = app_.furAt(*point_)) app_.setFurAt(*point_, FurNumber::Length, saturate(at->length + (longer ? kLengthStep : -kLengthStep)));
  return true;
}

bool EditModes::keyOfWhisker(std::string_view name, bool shift) {
  if (name == " ") {
    const auto met = app_.whiskerAt(app_.cursor(), kReach * pixelRatio_);
    if (const auto one = met ? met : app_.plantWhisker(app_.cursor())) choose(*one);
    return true;
  }
  if (name == "n") return chooseWhisker(shift ? -1 : 1), true;
  if (!whisker()) return false;
  if (name == "Escape") return whiskerRoot_.reset(), true;
  if (name == "Delete" || name == "Backspace") return removeWhisker(), true;
  const bool thinner = name == "{" || (shift && name == "["), thicker = name == "}" || (shift && name == "]");
  if (thinner || thicker) changeWhisker([&](groom::Whisker& one) { one.width *= thicker ? kLonger : 1 / kLonger; });
  else if (name == "[" || name == "]") changeWhisker([&](groom::Whisker& one) { one.length *= name == "]" ? kLonger : 1 / kLonger; });
  else if (shift && name.starts_with("Arrow")) {
    editor::GroomView view;
    describe(view);
    if (!view.whisker) return true;
    const float step = kTurn * kDegrees;
    view.whisker->aim.lean = glm::clamp(view.whisker->aim.lean + (name == "ArrowDown" ? step : name == "ArrowUp" ? -step : 0), 0.0f, 90.0f);
    view.whisker->aim.heading += name == "ArrowRight" ? step : name == "ArrowLeft" ? -step : 0;
    set(*view.whisker);
  } else return false;
  return true;
}

// --- whiskers ---

std::optional<std::size_t> EditModes::whisker() {
  const auto& all = app_.groom().whiskers;
  if (!whiskerRoot_) return std::nullopt;
  if (whiskerIndex_ < all.size() && all[whiskerIndex_].root == *whiskerRoot_) return whiskerIndex_;
  for (std::size_t i = 0; i < all.size(); ++i)
    if (all[i].root == *whiskerRoot_) return whiskerIndex_ = i;
  return std::nullopt;
}

void EditModes::choose(std::size_t whisker) {
  whiskerIndex_ = whisker;
  whiskerRoot_ = app_.groom().whiskers[whisker].root;
}

void EditModes::chooseWhisker(int step) {
  const auto count = static_cast<int>(app_.whiskerCount());
  if (count == 0) return;
  const auto now = whisker();
  choose(static_cast<std::size_t>(now ? (static_cast<int>(*now) + step + count) % count : step > 0 ? 0 : count - 1));
}

void EditModes::removeWhisker() {
  if (const auto index = whisker()) app_.removeWhisker(*index);
}

template <class Change>
void EditModes::changeWhisker(Change&& change) {
  const auto index = whisker();
  if (!index) return;
  groom::Whisker one = app_.groom().whiskers[*index];
  change(one);
  app_.setWhisker(*index, one);
}

// --- the panel ---

void EditModes::describe(editor::GroomView& view) {
  if (const auto under = hover_ ? app_.furAt(*hover_) : std::nullopt) view.under = viewOf(*under);
  if (const auto at = point_ && app_.tool() == Tool::Edit ? app_.furAt(*point_) : std::nullopt) view.point = viewOf(*at);
  const auto index = app_.tool() == Tool::Whisker ? whisker() : std::nullopt;
  if (!index) return;
  const groom::Whisker& one = app_.groom().whiskers[*index];
  const auto at = app_.furAt(one.root);
  if (!at) return;
  const float lean = std::acos(glm::clamp(glm::dot(one.direction, at->normal), -1.0f, 1.0f));
  view.whisker = editor::WhiskerView{one.length, one.width, one.spread, one.stiffness, leanOf(lean, one.direction, at->normal), static_cast<int>(one.hairs), one.color};
}

void EditModes::set(const editor::command::SetPoint& numbers) {
  const auto at = point_ ? app_.furAt(*point_) : std::nullopt;
  if (!at) return;
  app_.setFurAt(*point_, numbers.what, numbers.value, wayOf(numbers.comb, at->normal) * (numbers.comb.lean / kDegrees));
}

void EditModes::set(const editor::WhiskerView& to) {
  changeWhisker([&](groom::Whisker& one) {
    one.length = to.length;
    one.width = to.width;
    one.spread = to.spread;
    one.stiffness = to.stiffness;
    one.hairs = static_cast<std::uint32_t>(to.hairs);
    one.color = to.color;
    if (const auto at = app_.furAt(one.root))
      one.direction = glm::normalize(at->normal * std::cos(to.aim.lean / kDegrees) + wayOf(to.aim, at->normal) * std::sin(to.aim.lean / kDegrees));
  });
}

void EditModes::draw(float ratio) {
  if (app_.tool() == Tool::Edit) {
    if (point_) {
      drawLine(app_.ringRound(*point_), true, 1.5f * ratio);
      drawDot(app_.pixelOf(*point_), 4 * ratio);
    }
    if (const auto under = hover_ ? app_.furAt(*hover_) : std::nullopt) drawNumbers(*under, *hover_, ratio);
  }
  if (app_.tool() != Tool::Whisker) return;
  const auto drawn = [&](std::size_t index, float width) {
    const std::vector<Vec2> line = app_.whiskerLine(index);
    if (line.empty()) return;
    drawLine(line, false, width);
    drawDot(line.front(), 4 * ratio);
  };
  const auto chosen = whisker();
  if (chosen) drawn(*chosen, 2 * ratio);
  const auto met = hover_ && gesture_ == Gesture::None ? app_.whiskerAt(*hover_, kReach * ratio) : std::nullopt;
  if (met && met != chosen) drawn(*met, 1 * ratio);
}

}  // namespace fur::app
