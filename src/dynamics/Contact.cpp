#include "dynamics/Contact.h"

#include "core/PortableMath.h"
#include "dynamics/RigidMotion.h"

namespace fur::dynamics {

namespace {

// Of its radius: the way on which a ball of full grip has taken two thirds of the strands along.
constexpr float kTakenAlong = 0.4f;
constexpr float kParting = 0.5f;  // how far aside those go that are taken along
constexpr float kSoftness = 2.5f;
constexpr float kMaxRadius = 4.0f;  // model units: no larger ball touches more

}  // namespace

Press::Press(const Contact& contact, const Mat4& modelToWorld, float furLength) {
  const Mat3 toModel = glm::transpose(rotationOf(modelToWorld));
  const Vec3 origin(modelToWorld[3]);
  const Vec3 to = toModel * (contact.to - origin);
  from_ = toModel * (contact.from - origin);
  way_ = to - from_;
  const float way = glm::length(way_);
  // A jump is no stroke.
  if (!(way < kMaxRadius)) from_ = to, way_ = Vec3(0);
  const bool sound = std::isfinite(to.x + to.y + to.z) && contact.radius > 0 && furLength > 0;
  if (!sound) return;
  radius_ = std::min(contact.radius, kMaxRadius);
  furLength_ = std::min(furLength, kMaxRadius);
  most_ = std::min(contact.presses, kMostPressed);
  if (!(glm::dot(way_, way_) > 1e-12f)) return;
  perWay_ = 1.0f / glm::dot(way_, way_);
  along_ = way_ * std::sqrt(perWay_);
  drag_ = unitOr0(contact.grip) * (1.0f - portableExp(-std::min(way / (kTakenAlong * radius_), 80.0f)));
}

bool Press::reaches(const Vec3& centre, float radius) const {
  if (radius_ <= 0) return false;
  const Vec3 apart = centre - (from_ + way_ * saturate(glm::dot(centre - from_, way_) * perWay_));
  const float reach = radius + radius_ + furLength_;
  return glm::dot(apart, apart) < reach * reach;
}

LaneMask Press::apply(Lanes3& bends, const Lanes3& before, const Lanes3& roots, const Lanes3& normals,
                      const Lanes& lengths) const {
  // Where the ball came nearest to the root.
  const Lanes share = min(max(dot(roots - splat(from_), splat(way_)) * perWay_, splat(0.0f)), splat(1.0f));
  const Lanes3 centre = splat(from_) + splat(way_) * share;
  const Lanes3 apart = roots - centre;
  const Lanes height = -dot(apart, normals);
  const Lanes3 outward = apart + normals * height;
  const Lanes aside = dot(outward, outward);
  const Lanes3 nearest = outward + normals * (min(max(height, splat(0.0f)), lengths) - height);
  const float squared = radius_ * radius_;
  const LaneMask held = (dot(nearest, nearest) < squared) & (lengths > 1e-4f);
  if (!any(held)) return held;

  // The ball leaves this share of the strand's length as room; an arc of 1 that turns by a is sin(a) / a high, which is
  // 1 - a^2 / 6 + a^4 / 120.
  const Lanes room = (height - sqrtOf(max(squared - aside, splat(0.0f)))) / max(lengths, splat(1e-4f));
  const Lanes lowered = 1.0f - min(max(room, splat(0.0f)), splat(1.0f));
  const Lanes fullTurn = min(sqrtOf(10.0f - sqrtOf(max(100.0f - 120.0f * lowered, splat(0.0f)))), splat(most_));
  // Softer to the sides, so that the fur makes no step round it.
  const Lanes soft = min(kSoftness * (1.0f - aside * (1.0f / squared)), splat(1.0f));
  const Lanes turn = fullTurn * max(soft, splat(0.0f));
  Lanes3 bent = bends;
  if (drag_ > 0) {
    const Lanes3 along = normalize(across(splat(along_), normals) + outward * splat(kParting / radius_));
    bent = bent + (along * max(turn, sqrtOf(dot(bent, bent))) - bent) * splat(drag_);
  }
  // Out of the way: one that stands up goes where the ball presses it, one that leans already lies down further; a little
  // to where it leans in any case, so that those in the very middle have somewhere to go.
  const Lanes3 out = normalize(outward * splat(1.0f / radius_) + bent * splat(0.1f));
  const Lanes missing = turn - sqrtOf(dot(bent, bent));
  bent = select(missing > 0.0f, normalize(bent + out * missing) * turn, bent);
  if (drag_ <= 0) bent = select(dot(before, before) > turn * turn * 0.998f, before, bent);
  bends = select(held, bent, bends);
  return held;
}

}  // namespace fur::dynamics
