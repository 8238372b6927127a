// Tools that work on long hair where they are: the brush that paints scalps, and those that shape guides.
#include "app/stages/Brushes.h"
#include "app/stages/GrownHair.h"
#include "app/stages/Mirror.h"
#include "groom/GroomBrush.h"
#include "hair/GuideEdits.h"
#include "hair/Hanging.h"
#include "hair/PlantGuides.h"

namespace fur::app {

namespace {

// What one dab at full strength does.
constexpr float kLonger = 1.06f, kTurns = 0.35f, kTwist = 0.15f;
// Hanging hair lies on the coat, which gives way a little, and stays so far outside of bare skin, model units.
constexpr float kOnCoat = 1.15f, kClearance = 0.015f;

// A ball round all there is, so that edits of all guides are dabs, too.
groom::Brush everywhere(float strength) {
  groom::Brush brush;
  brush.radius = 100;
  brush.strength = strength;
  brush.falloff = groom::Falloff::Flat;
  return brush;
}

}  // namespace

std::optional<GrownHair::Near> GrownHair::nearestNode(const Vec3& origin, const Vec3& direction, float reach) const {
  std::optional<Near> best;
  if (selected_ >= scalps_.size()) return best;
  const LiveScalp& live = scalps_[selected_];
  const hair::Guides& guides = style_.scalps[selected_].guides;
  // Several dabs come between two updates: it is seen as it was at the last one.
  if (live.nodes.size() != guides.positions.size()) return best;
  for (std::size_t i = 0; i < live.nodes.size(); ++i) {
    const std::size_t guide = i / static_cast<std::size_t>(guides.nodes), node = i % static_cast<std::size_t>(guides.nodes);
    if (node == 0 || guides.flags[guide] & hair::kHidden) continue;  // roots stay where they are
    const Vec3 way = live.nodes[i].position - origin;
    const float along = glm::dot(way, direction);
    const Vec3 aside = way - direction * along;
    if (along <= 0 || glm::dot(aside, aside) > reach * reach || (best && along > best->distance)) continue;
    best = Near{guide, node, live.nodes[i].position, guides.positions[i], along};
  }
  return best;
}

bool GrownHair::paintScalp(const Dab& dab) {
  hair::Scalp& scalp = style_.scalps[selected_];
  const settings::Settings& settings = dab.settings;
  if (!dab.skin) return false;
  if (scalp.map.size() != dab.surface.atlas.size()) scalp.map = groom::resized(scalp.map, dab.surface.atlas.size());
  const auto paint = [&](const geometry::SurfacePoint& point) {
    const groom::Brush brush = brushAt(settings, positionAt(dab.shape.surface(), point), normalAt(dab.shape.surface(), point));
    return groom::paintChannel(scalp.map, dab.mask, dab.surface, brush, static_cast<std::size_t>(settings.scalpMap), settings.brushErases ? 0 : 255);
  };
  bool changed = paint(*dab.skin);
  if (const auto other = mirrored(settings, dab.shape, *dab.skin)) changed |= paint(*other);
  return changed;
}

bool GrownHair::shapeGuides(const Dab& dab) {
  hair::Guides& guides = style_.scalps[selected_].guides;
  const settings::Settings& settings = dab.settings;
  const bool moves = dab.tool == Tool::HairComb || dab.tool == Tool::HairMove;
  if (!guideStroke_ || !moves) {
    const auto near = nearestNode(dab.origin, dab.direction, reachOf(dab.tool, settings));
    if (!near) return false;
    if (!guideStroke_) guideStroke_ = Stroke{near->rest, near->shown, -dab.direction, *near};
    guideStroke_->last = near->rest;
    if (moves) return false;
  }
  Stroke& stroke = *guideStroke_;
  Vec3 move(0);
  if (moves) {
    const auto now = onPlane(dab.origin, dab.direction, stroke.planePoint, stroke.planeNormal);
    if (!now) return false;
    move = *now - stroke.planePoint;
    stroke.planePoint = *now;
  }
  const auto apply = [&](const Vec3& centre, const Vec3& way) {
    const groom::Brush brush = brushAt(settings, centre, stroke.planeNormal);
    const bool erases = settings.brushErases;
    switch (dab.tool) {
      case Tool::HairComb: return hair::comb(guides, brush, way);
      case Tool::HairCut: return hair::cut(guides, brush);
      case Tool::HairLength: return hair::lengthen(guides, brush, erases ? 1 / kLonger : kLonger);
      case Tool::HairCurl: return erases ? hair::straighten(guides, brush) : hair::curl(guides, scalps_[selected_].asMade, brush, 3, kTurns * settings.groomStrength);
      case Tool::HairTwist: return hair::twist(guides, brush, erases ? -kTwist : kTwist);
      case Tool::HairCopy: return hair::copyShape(guides, scalps_[selected_].asMade, brush, stroke.first.guide);
      case Tool::HairHold: return hair::setFlag(guides, brush, hair::kStatic, !erases);
      case Tool::HairHide: return hair::setFlag(guides, brush, hair::kHidden, !erases);
      default: return false;
    }
  };
  if (dab.tool == Tool::HairMove) return hair::moveNode(guides, stroke.first.guide, stroke.first.node, guides.of(stroke.first.guide)[stroke.first.node] + move);
  bool changed = apply(stroke.last, move);
  if (settings.mirror > 0) changed |= apply(mirrored(settings, stroke.last), mirrored(settings, move));
  stroke.last += move;
  return changed;
}

void GrownHair::dab(const Dab& dab) {
  if (dab.tool == Tool::HairShape) {
    if (dragBody(dab)) touch();
    return;
  }
  if (style_.scalps.empty()) return;
  if (dab.tool == Tool::Scalp ? paintScalp(dab) : shapeGuides(dab)) touch();
}

void GrownHair::editGuides(const ShapeStage& shape, const Edit& edit, Warnings& warnings) {
  hair::Guides& guides = style_.scalps[selected_].guides;
  const auto roots = [&] { return hair::rootFrames(shape.surface(), shape.query(), guides); };
  const float clearance = kClearance + kOnCoat * edit.coat;
  switch (edit.what) {
    case HairEdit::Hang:
      hair::hang(guides, shape.surface(), shape.query(), edit.direction == Vec3(0) ? Vec3(0, -1, 0) : edit.direction, edit.value, clearance);
      break;
    case HairEdit::Part: hair::part(guides, roots(), edit.direction, edit.value); break;
    case HairEdit::Gather: hair::gather(guides, shape.surface(), shape.query(), edit.direction, edit.value, clearance); break;
    case HairEdit::Bundle: hair::bundle(guides, edit.value); break;
    case HairEdit::Cut: hair::cut(guides, {edit.direction, Vec3(0, 1, 0), edit.value, 1}); break;
    case HairEdit::Straighten: hair::straighten(guides, everywhere(edit.value)); break;
    case HairEdit::Lengthen: hair::lengthen(guides, everywhere(1), edit.value); break;
    case HairEdit::Curl: hair::curl(guides, roots(), everywhere(1), edit.value); break;
    case HairEdit::Twist: hair::twist(guides, everywhere(1), edit.value); break;
    case HairEdit::ShowAll: hair::setFlag(guides, hair::kHidden, false); break;
    case HairEdit::InvertHidden:
      for (std::uint8_t& flags : guides.flags) flags ^= hair::kHidden;
      break;
    case HairEdit::HoldAll: hair::setFlag(guides, everywhere(1), hair::kStatic, true); break;
    case HairEdit::FreeAll: hair::setFlag(guides, hair::kStatic, false); break;
    case HairEdit::Mirror: {
      auto both = hair::mirrored(guides, {Vec3(0), Vec3(edit.value < 0 ? -1 : 1, 0, 0)});
      if (both) guides = std::move(*both);
      else warnings.push_back(style_.scalps[selected_].name + ": " + both.error().message);
      break;
    }
    default: break;
  }
}

}  // namespace fur::app
