// What views and tools show of long hair.
#include "app/stages/Brushes.h"
#include "app/stages/GrownHair.h"
#include "core/Fnv1a.h"
#include "core/NoteChange.h"
#include "hair/ViewLines.h"

namespace fur::app {

namespace {

// In the order of the setting `hairView`.
enum class Shows { Final, Guides, Wisps, Influence, Springs, Scalp, Shapes };

Shows shownBy(const settings::Settings& settings) { return static_cast<Shows>(settings.hairView); }
// A view instead of the picture.
bool replaces(const HairStage::Look& look) { return look.settings.view == 0 && shownBy(look.settings) != Shows::Final; }
bool toolShows(const HairStage::Look& look) { return !look.saved && worksOnHair(look.tool); }
bool mapShows(const HairStage::Look& look) {
  return replaces(look) ? shownBy(look.settings) == Shows::Scalp : toolShows(look) && look.tool == Tool::Scalp;
}
bool bodiesShow(const HairStage::Look& look) {
  const Shows shows = shownBy(look.settings);
  return replaces(look) ? shows == Shows::Springs || shows == Shows::Shapes : toolShows(look) && look.tool == Tool::HairShape;
}
bool guidesShow(const HairStage::Look& look) {
  const Shows shows = shownBy(look.settings);
  return replaces(look) ? shows == Shows::Guides || shows == Shows::Influence || shows == Shows::Shapes : toolShows(look);
}

constexpr Vec3 kAwake(1.0f, 0.72f, 0.2f), kAsleep(0.5f, 0.8f, 0.3f), kHeld(0.25f, 0.68f, 1.0f), kHiddenGuide(0.45f, 0.46f, 0.5f), kOther(0.55f, 0.58f, 0.62f);
constexpr Vec3 kPointed(1.0f, 1.0f, 1.0f), kBody(0.95f, 0.45f, 0.85f), kSelectedBody(1.0f, 0.85f, 0.3f);
// Guides are seen through so much hair, model units; and through the skin next to their roots.
constexpr float kThroughHair = 0.3f, kAtSkin = 0.03f;

Vec3 guideColor(std::uint8_t flags, bool asleep, bool selected) {
  const Vec3 color = flags & hair::kHidden ? kHiddenGuide : flags & hair::kStatic ? kHeld : asleep ? kAsleep : kAwake;
  return selected ? color : glm::mix(color, kOther, 0.7f);
}

}  // namespace

const hair::HairView* GrownHair::view(const Look& look) {
  view_.instead = replaces(look);
  mapOver_ = !view_.instead && mapShows(look);
  if (style_.empty() || !(view_.instead || toolShows(look))) return nullptr;
  const auto near = pointedNode(look);
  // What lines are made of, and colours.
  Fnv1a lines, colors;
  lines.add(revision_), lines.add(selected_), lines.add(view_.instead), lines.add(look.tool);
  lines.add(near ? near->guide * hair::kMostNodes + near->node + 1 : 0);
  for (const float number : {static_cast<float>(look.settings.hairView), look.pixelRatio, look.settings.brushRadius}) lines.add(number);
  if (bodiesShow(look)) {
    lines.addAll(bodies_);
    lines.add(selectedBody_);
    if (look.tool == Tool::HairShape) lines.add(look.eye);
  }
  if (noteChange(linesFor_, lines.value())) viewLines(look);
  for (const int number : {static_cast<int>(selected_), int{mapShows(look)}, view_.instead ? look.settings.hairView : 0, look.settings.scalpMap, look.mapSize})
    colors.add(number);
  for (const LiveScalp& live : scalps_) colors.add(live.grown);
  if (mapShows(look) && selected_ < style_.scalps.size()) colors.add(style_.scalps[selected_].map.hash());
  if (noteChange(colorsFor_, colors.value())) viewColors(look);
  return &view_;
}

std::optional<GrownHair::Near> GrownHair::pointedNode(const Look& look) const {
  if (!look.points || !toolShows(look) || look.tool == Tool::Scalp || look.tool == Tool::HairShape) return std::nullopt;
  return nearestNode(look.origin, look.direction, reachOf(look.tool, look.settings));
}

bool GrownHair::pointsElsewhere(const Look& look) {
  const auto near = pointedNode(look);
  return noteChange(pointedAt_, near ? std::pair(near->guide + 1, near->node) : std::pair<std::size_t, std::size_t>());
}

// --- lines ---

void GrownHair::viewLines(const Look& look) {
  view_.lines.clear();
  ++view_.lineRevision;
  const bool springs = replaces(look) && shownBy(look.settings) == Shows::Springs;
  for (std::size_t i = 0; i < scalps_.size(); ++i) {
    if (scalps_[i].nodes.size() != style_.scalps[i].guides.positions.size()) continue;  // it has not grown yet
    if (springs) viewSprings(i, look);
    else if (guidesShow(look) && (replaces(look) || i == selected_)) viewGuides(i, look);
  }
  if (!replaces(look)) viewPointed(look);
  if (bodiesShow(look)) viewBodies(look);
}

void GrownHair::viewGuides(std::size_t scalp, const Look& look) {
  const hair::Scalp& of = style_.scalps[scalp];
  const LiveScalp& live = scalps_[scalp];
  const Shows shows = shownBy(look.settings);
  const bool instead = replaces(look), nodes = instead ? shows == Shows::Guides : look.tool != Tool::Scalp;
  const auto n = static_cast<std::size_t>(of.guides.nodes);
  for (std::size_t g = 0; g < of.guides.count(); ++g) {
    const bool hidden = of.guides.flags[g] & hair::kHidden;
    if (hidden && !instead && look.tool != Tool::HairHide) continue;
    hair::GuideStyle style;
    const Vec3 color = shows == Shows::Influence && instead ? hair::colorOfNumber(static_cast<std::uint32_t>(g))
                                                                : guideColor(of.guides.flags[g], live.simulation.atRest(), scalp == selected_);
    style.color = Vec4(color, instead ? 1.0f : 0.75f);
    style.width = look.pixelRatio * (hidden ? 1.0f : instead ? 1.8f : 1.2f);
    style.dots = nodes && !hidden ? look.pixelRatio * (instead ? 4.5f : 3.0f) : 0;
    style.lift = instead ? kAtSkin : kThroughHair;
    hair::addGuide(view_.lines, {&live.nodes[g * n], n}, of.values.curve == 0, style);
  }
}

// What the tool would work on: nodes within the brush.
void GrownHair::viewPointed(const Look& look) {
  const auto near = pointedNode(look);
  if (!near) return;
  const hair::Guides& guides = style_.scalps[selected_].guides;
  const auto n = static_cast<std::size_t>(guides.nodes);
  const bool one = look.tool == Tool::HairMove;
  for (std::size_t i = 0; i < guides.positions.size(); ++i) {
    const float away = glm::length(guides.positions[i] - near->rest);
    const bool itself = i == near->guide * n + near->node;
    if (one ? !itself : away > look.settings.brushRadius || guides.flags[i / n] & hair::kHidden) continue;
    const float weight = one ? 1 : 1 - away / look.settings.brushRadius;
    const Vec3 at = scalps_[selected_].nodes[i].position;
    view_.lines.push_back({at, look.pixelRatio * (3.5f + 4.0f * weight), at, kThroughHair, Vec4(glm::mix(kAwake, kPointed, 0.4f + 0.6f * weight), 1)});
  }
}

void GrownHair::viewSprings(std::size_t scalp, const Look& look) {
  const LiveScalp& live = scalps_[scalp];
  const hair::Guides& guides = style_.scalps[scalp].guides;
  std::vector<Vec3> references = live.simulation.references(), nodes;
  const Mat4 modelFromWorld = glm::inverse(look.worldFromModel);
  for (Vec3& at : references) at = Vec3(modelFromWorld * Vec4(at, 1));
  for (const hair::GuideNode& node : live.nodes) nodes.push_back(node.position);
  const std::vector<std::uint8_t> simulated = live.simulation.simulated();
  const auto n = static_cast<std::size_t>(guides.nodes);
  for (std::size_t g = 0; g < guides.count(); ++g) {
    // What follows others has no springs of its own.
    if (simulated[g]) hair::addSprings(view_.lines, {&nodes[g * n], n}, {&references[g * n], n}, look.pixelRatio);
    else hair::addGuide(view_.lines, {&live.nodes[g * n], n}, false, {Vec4(guides.flags[g] & hair::kStatic ? kHeld : kOther, 0.6f), look.pixelRatio, 0, kAtSkin});
  }
}

void GrownHair::viewBodies(const Look& look) {
  const bool edits = !look.saved && look.tool == Tool::HairShape;
  for (std::size_t i = 0; i < bodies_.size(); ++i) {
    const hair::Body& body = bodies_[i];
    const bool selected = edits && static_cast<int>(i) == selectedBody_;
    hair::addBody(view_.lines, body, Vec4(selected ? kSelectedBody : kBody, 1), (selected ? 2.0f : 1.4f) * look.pixelRatio);
    if (!selected) continue;
    // Its handles are never hidden.
    constexpr float kOnTop = 1e3f;
    for (const Vec3& at : {body.a, body.b, radiusHandle(body, look.eye)})
      for (const auto& [width, color] : {std::pair(11.0f, Vec4(0, 0, 0, 0.6f)), {8.0f, Vec4(kSelectedBody, 1)}})
        view_.lines.push_back({at, width * look.pixelRatio, at, kOnTop, color});
  }
}

// --- colours ---

void GrownHair::viewColors(const Look& look) {
  ++view_.colorRevision;
  view_.mapColors = mapColors(look);
  view_.wispColors.clear();
  const Shows shows = shownBy(look.settings);
  if (!(mapShows(look) || (replaces(look) && (shows == Shows::Wisps || shows == Shows::Influence)))) return;
  for (std::size_t i = 0; i < scalps_.size(); ++i) view_.wispColors.push_back(wispColors(i, look));
}

// Density everywhere on the scalp; the others where hair grows.
std::vector<hair::ViewColor> GrownHair::mapColors(const Look& look) const {
  std::vector<hair::ViewColor> colors;
  if (!mapShows(look) || selected_ >= style_.scalps.size()) return colors;
  const groom::GroomMap map = groom::resized(style_.scalps[selected_].map, look.mapSize);
  const auto channel = static_cast<std::size_t>(look.settings.scalpMap);
  for (const groom::GroomMap::Texel& texel : map.texels())
    colors.push_back(texel[0] ? hair::packColor(hair::heatColor(static_cast<float>(texel[channel]) / 255)) : hair::ViewColor{});
  return colors;
}

// Two a wisp: at its root and at its tip.
std::vector<hair::ViewColor> GrownHair::wispColors(std::size_t scalp, const Look& look) const {
  std::vector<hair::ViewColor> colors;
  const Shows shows = replaces(look) ? shownBy(look.settings) : Shows::Final;
  const groom::GroomMap& map = style_.scalps[scalp].map;
  std::uint32_t number = 0;
  for (const hair::Wisp& wisp : scalps_[scalp].growth.wisps) {
    ++number;
    Vec3 root(0), tip(0);
    if (shows == Shows::Wisps) {
      root = tip = hair::colorOfNumber(number);
    } else if (shows == Shows::Influence) {
      for (int k = 0; k < 3; ++k) {
        const Vec3 guide = hair::colorOfNumber(wisp.guides[static_cast<std::size_t>(k)]);
        root += guide * wisp.weights[k];
        tip += guide * (wisp.weights[k] + wisp.magnet[k]);
      }
    } else {
      // The map that is painted; other scalps stand back.
      root = tip = scalp == selected_ ? hair::heatColor(map.at(wisp.atlas)[look.settings.scalpMap]) : kOther;
    }
    colors.push_back(hair::packColor(root));
    colors.push_back(hair::packColor(tip));
  }
  return colors;
}

const groom::GroomMap& GrownHair::paintUnderView(const groom::GroomMap& paint) {
  std::vector<groom::GroomMap::Texel> texels = paint.texels();
  if (!mapOver_ || view_.mapColors.size() != texels.size()) return paint;
  constexpr std::uint8_t kOpacity = 205;
  for (std::size_t i = 0; i < texels.size(); ++i)
    if (const hair::ViewColor& color = view_.mapColors[i]; color[3]) texels[i] = {color[0], color[1], color[2], kOpacity};
  paintUnderView_ = groom::GroomMap(paint.size(), groom::GroomMap::kBlank);
  paintUnderView_.restore(std::move(texels));
  return paintUnderView_;
}

}  // namespace fur::app
