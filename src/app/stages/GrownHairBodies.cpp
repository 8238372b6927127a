// The spheres and capsules that hair does not enter: edits of them, the tool that drags them, and how they go with bones.
#include <cmath>

#include "app/stages/GrownHair.h"
#include "core/NoteChange.h"
#include "core/NumberText.h"
#include "scene/BoneBodies.h"

namespace fur::app {

namespace {

constexpr float kGripPixels = 12;
constexpr float kFarthestBody = 100;  // from the model's middle, model units

hair::Body sound(hair::Body body) {
  const auto within = [](const Vec3& at) { return glm::clamp(at, Vec3(-kFarthestBody), Vec3(kFarthestBody)); };
  body.a = within(body.a);
  body.b = within(body.b);
  body.radius = glm::clamp(body.radius, hair::kLeastBody, hair::kLargestBody);
  return body;
}

bool isFinite(const hair::Body& body) {
  const Vec3 sum = body.a + body.b;
  return std::isfinite(sum.x + sum.y + sum.z + body.radius);
}

hair::Body moved(const Mat4& by, hair::Body body) {
  body.a = Vec3(by * Vec4(body.a, 1));
  body.b = Vec3(by * Vec4(body.b, 1));
  return body;
}

}  // namespace

// Where the pose has them: with bones as they have moved since they were made.
void GrownHair::placeBodies(const ShapeStage& shape) {
  bodies_ = style_.bodies;
  bodyMotions_.assign(bodies_.size(), Mat4(1));
  const scene::Pose* pose = shape.pose();
  if (!pose) return;
  const std::size_t nodes = shape.rig().nodes.size();
  for (std::size_t i = 0; i < bodies_.size(); ++i) {
    const std::int32_t bone = bodies_[i].bone;
    if (bone < 0 || bone >= static_cast<std::int32_t>(nodes)) continue;
    if (noteChange(restFor_, shape.surfaceRevision())) {
      const scene::Pose rest(shape.rig());
      restInverses_.clear();
      for (std::size_t node = 0; node < nodes; ++node) restInverses_.push_back(glm::inverse(rest.transform(node)));
    }
    const auto node = static_cast<std::size_t>(bone);
    const Mat4 motion = pose->transform(node) * restInverses_[node];
    const hair::Body at = moved(motion, bodies_[i]);
    if (!isFinite(at) || !(std::abs(glm::determinant(motion)) > 1e-9f)) continue;  // a bone of no size
    bodies_[i] = at;
    bodyMotions_[i] = motion;
  }
}

hair::Body* GrownHair::body() {
  const bool one = selectedBody_ >= 0 && selectedBody_ < static_cast<int>(style_.bodies.size());
  return one ? &style_.bodies[static_cast<std::size_t>(selectedBody_)] : nullptr;
}

void GrownHair::addBody(const hair::Body& body, Warnings& warnings) {
  if (style_.bodies.size() >= hair::kMostBodies) return warnings.push_back("a model has at most " + decimal(hair::kMostBodies) + " spheres and capsules");
  if (!(body.radius > 0)) return;
  style_.bodies.push_back(sound(body));
  selectedBody_ = static_cast<int>(style_.bodies.size()) - 1;
}

// False: it is another edit.
bool GrownHair::editBodies(const ShapeStage& shape, const Edit& edit, Warnings& warnings) {
  hair::Body* one = body();
  const Vec3 middle = one ? 0.5f * (one->a + one->b) : Vec3(0);
  switch (edit.what) {
    case HairEdit::AddSphere: addBody({edit.direction, edit.direction, edit.value}, warnings); return true;
    case HairEdit::AddCapsule: {
      const Vec3 up(0, edit.value, 0);
      addBody({edit.direction - up, edit.direction + up, edit.value}, warnings);
      return true;
    }
    case HairEdit::SelectBody:
      selectedBody_ = static_cast<int>(glm::clamp(edit.value, -1.0f, static_cast<float>(style_.bodies.size()) - 1));
      return true;
    case HairEdit::FitBones: {
      auto fitted = scene::fitBodies(shape.rig());
      if (fitted.empty()) return warnings.push_back("the model has no bones"), true;
      style_.bodies = std::move(fitted);
      selectedBody_ = -1;
      return true;
    }
    case HairEdit::MoveBody:
      if (one) *one = sound({edit.direction + one->a - middle, edit.direction + one->b - middle, one->radius, one->bone});
      return true;
    case HairEdit::BodyEnds:
      if (one) *one = sound({middle - edit.direction, middle + edit.direction, one->radius, one->bone});
      return true;
    case HairEdit::BodyRadius:
      if (one) *one = sound({one->a, one->b, edit.value, one->bone});
      return true;
    case HairEdit::RemoveBody:
      if (one) style_.bodies.erase(style_.bodies.begin() + selectedBody_);
      selectedBody_ = -1;
      return true;
    case HairEdit::ClearBodies:
      style_.bodies.clear();
      selectedBody_ = -1;
      return true;
    default: return false;
  }
}

void GrownHair::setBody(std::size_t body, const hair::Body& to) {
  if (body >= style_.bodies.size() || style_.bodies[body] == to || !isFinite(to)) return;
  style_.bodies[body] = sound(to);
  touch();
}

bool GrownHair::meets(const Look& look) const {
  if (look.tool == Tool::HairShape) return gripAt(bodies_, selectedBody_, look.origin, look.direction, kGripPixels * look.pixelRatio * look.pixel).has_value();
  return nearestNode(look.origin, look.direction, look.settings.brushRadius).has_value();
}

// The first dab of a stroke takes hold, the others drag.
bool GrownHair::dragBody(const Dab& dab) {
  if (bodies_.size() != style_.bodies.size()) return false;  // it has not been updated yet
  if (!bodyStroke_) {
    const auto grip = gripAt(bodies_, selectedBody_, dab.origin, dab.direction, kGripPixels * dab.pixel);
    if (!grip) return false;
    selectedBody_ = static_cast<int>(grip->body);
    bodyStroke_ = BodyStroke{*grip, grip->at, -dab.direction};
    return true;
  }
  BodyStroke& stroke = *bodyStroke_;
  const auto now = onPlane(dab.origin, dab.direction, stroke.at, stroke.normal);
  const std::size_t i = stroke.grip.body;
  if (!now || i >= bodies_.size()) return false;
  bodies_[i] = dragged(bodies_[i], stroke.grip, *now);
  style_.bodies[i] = sound(moved(glm::inverse(bodyMotions_[i]), bodies_[i]));
  stroke.grip.at = stroke.at = *now;
  return true;
}

}  // namespace fur::app
