#include "hair/Colliders.h"

#include <algorithm>
#include <cmath>

#include "hair/Lengths.h"

namespace fur::hair {

namespace {

constexpr float kSkin = 2e-4f;      // hair keeps this far away, model units: what rounding and capsules' curves may take
constexpr int kRounds = 4;          // over all obstacles, for where one turns a segment into another
constexpr float kFriction = 0.15f;  // of the sliding, lost in a step

bool isNear(const Vec3& v) { return std::isfinite(v.x + v.y + v.z) && glm::dot(v, v) < 1e12f; }

// What of an obstacle's axis is nearest, and how far along.
struct Nearest {
  Lanes3 point;
  Lanes along;
};
Nearest nearestOf(const Obstacle& o, const Lanes3& p) {
  const Lanes3 a = splat(o.a), axis = splat(o.axis);
  const Lanes t = min(max(dot(p - a, axis) * o.perAxis2, splat(0.0f)), splat(1.0f));
  return {a + axis * t, t};
}
LaneMask within(const Obstacle& o, const Lanes3& p, const Lanes& margin) {
  const Lanes3 away = p - nearestOf(o, p).point;
  return dot(away, away) < (o.radius + margin) * (o.radius + margin);
}

// A segment of length L from the node before it.
struct Segment {
  Lanes3 from, along;
  Lanes length;
  Lanes3 at(float share) const { return from + along * (length * share); }
};

// Turns the segment about its first node until the point at `share` of it is out of the obstacle: by the least angle. For a sphere
// about c of radius R that is where the segment's cosine to (from - c) is (R^2 - D^2 - l^2) / (2 D l), D = |from - c|.
LaneMask turnOut(const Obstacle& o, float share, Segment& s) {
  const Lanes3 point = s.at(share), centre = nearestOf(o, point).point, away = point - centre;
  const float radius = o.radius + kSkin;
  const LaneMask inside = dot(away, away) < radius * radius;
  if (!any(inside)) return inside;
  const Lanes3 back = s.from - centre;
  const Lanes distance = sqrtOf(dot(back, back)), part = s.length * share;
  const Lanes3 out = directionOr(back, directionOr(away, s.along));
  const Lanes wanted = (radius * radius - distance * distance - part * part) / max(2.0f * distance * part, splat(1e-9f));
  const Lanes cosine = min(max(wanted, dot(s.along, out)), splat(1.0f));
  const Lanes3 side = directionOr(across(s.along, out), Lanes3{});
  const Lanes sine = sqrtOf(max(1.0f - cosine * cosine, splat(0.0f)));
  s.along = select(inside, directionOr(out * cosine + side * sine, out), s.along);
  return inside;
}

LaneMask hits(std::span<const Obstacle> obstacles, const Segment& s) {
  LaneMask hit{};
  for (const Obstacle& o : obstacles) hit |= within(o, s.at(1), splat(0.5f * kSkin)) | within(o, s.at(0.5f), splat(0.5f * kSkin));
  return hit;
}

// For where turning out of one obstacle after another has not ended: straight away from all that are near; else back along the
// segment before, which is known to be free.
void escape(std::span<const Obstacle> obstacles, const Lanes3& before, Segment& s) {
  LaneMask stuck = hits(obstacles, s);
  if (!any(stuck)) return;
  Lanes3 sum{};
  for (const Obstacle& o : obstacles) {
    const Lanes3 away = s.from - nearestOf(o, s.from).point;
    const Lanes near = o.radius + s.length + kSkin;
    sum = sum + select(dot(away, away) < near * near, directionOr(away, Lanes3{}), Lanes3{});
  }
  for (const Lanes3& way : {directionOr(sum, before), before * splat(-1.0f)}) {
    Segment tried = s;
    tried.along = select(stuck, way, s.along);
    const LaneMask freed = stuck & ~hits(obstacles, tried);
    s.along = select(freed, way, s.along);
    stuck &= ~freed;
  }
}

void turnOutOfAll(std::span<const Obstacle> obstacles, const Lanes3& before, Segment& s) {
  LaneMask turned{};
  for (int round = 0; round < kRounds; ++round) {
    LaneMask now{};
    for (const Obstacle& o : obstacles) now |= turnOut(o, 1, s) | turnOut(o, 0.5f, s);
    if (!any(now)) break;
    turned |= now;
  }
  if (any(turned)) escape(obstacles, before, s);
}

// The direction, or the nearest that does not turn back on the one before.
Lanes3 unfolded(const Lanes3& along, const Lanes3& before, const Lanes& leastCosine, const FrameLanes& root) {
  const LaneMask folded = dot(along, before) < leastCosine;
  if (!any(folded)) return along;
  const Lanes3 sideways = directionOr(across(root.x, before), root.z), side = directionOr(across(along, before), sideways);
  return select(folded, before * leastCosine + side * sqrtOf(max(1.0f - leastCosine * leastCosine, splat(0.0f))), along);
}

void noteContacts(std::span<const Obstacle> obstacles, const Lanes3& p, LaneMask& touched, Lanes3& normal, Lanes3& move) {
  for (const Obstacle& o : obstacles) {
    const LaneMask near = within(o, p, splat(2 * kSkin));
    if (!any(near)) continue;
    const Nearest nearest = nearestOf(o, p);
    touched |= near;
    normal = select(near, directionOr(p - nearest.point, normal), normal);
    move = select(near, splat(o.moveA) + splat(o.moveAxis) * nearest.along, move);
  }
}

}  // namespace

std::vector<Collider> soundColliders(std::span<const Collider> colliders) {
  std::vector<Collider> out;
  for (const Collider& c : colliders)
    if (isNear(c.a) && isNear(c.b) && c.radius > 0 && c.radius < 1e3f) out.push_back(c);
  return out;
}

std::vector<Obstacle> obstaclesBetween(std::span<const Collider> from, std::span<const Collider> to, float share, float stepShare) {
  const bool moves = from.size() == to.size();
  std::vector<Obstacle> out(to.size());
  for (std::size_t i = 0; i < out.size(); ++i) {
    const Collider &b = to[i], &a = moves ? from[i] : b;
    Obstacle& o = out[i];
    o.a = glm::mix(a.a, b.a, share);
    o.axis = glm::mix(a.b, b.b, share) - o.a;
    o.moveA = (b.a - a.a) * stepShare;
    o.moveAxis = (b.b - a.b) * stepShare - o.moveA;
    o.radius = glm::mix(a.radius, b.radius, share);
    const float squared = glm::dot(o.axis, o.axis);
    o.perAxis2 = squared > 1e-12f ? 1.0f / squared : 0.0f;
  }
  return out;
}

void findReached(std::span<const Obstacle> all, const Lanes3& roots, const Lanes& reach, std::vector<Obstacle>& reached) {
  reached.clear();
  for (const Obstacle& o : all) {
    const Lanes3 away = roots - nearestOf(o, roots).point;
    const Lanes far = reach + (o.radius + 2 * kSkin);
    if (any(dot(away, away) < far * far)) reached.push_back(o);
  }
}

void pushOut(std::span<const Obstacle> obstacles, int nodes, Lanes3* p) {
  for (const Obstacle& o : obstacles)
    for (int i = 2; i < nodes; ++i) {
      const Lanes3 centre = nearestOf(o, p[i]).point, away = p[i] - centre;
      const float radius = o.radius + kSkin;
      const LaneMask inside = dot(away, away) < radius * radius;
      if (!any(inside)) continue;
      p[i] = select(inside, centre + directionOr(away, p[i] - p[i - 1]) * splat(radius), p[i]);
    }
}

void placeSegments(std::span<const Obstacle> obstacles, const GuideBlocks& guides, std::size_t first, const FrameLanes& root, Lanes3* p,
                   Contacts& contacts) {
  std::vector<Obstacle>& near = contacts.near;
  Lanes3 before = directionOr(p[1] - p[0], root.y);
  for (int i = 2; i < guides.nodes; ++i) {
    const std::size_t at = first + static_cast<std::size_t>(i);
    Segment s{p[i - 1], unfolded(directionOr(p[i] - p[i - 1], before), before, guides.leastCosines[at], root), guides.lengths[at]};
    contacts.touched[i] = LaneMask{};
    near.clear();
    for (const Obstacle& o : obstacles)
      if (any(within(o, s.from, s.length + 2 * kSkin))) near.push_back(o);
    if (!near.empty()) {
      turnOutOfAll(near, before, s);
      noteContacts(near, s.at(1), contacts.touched[i], contacts.normal[i], contacts.surfaceMove[i]);
    }
    p[i] = s.at(1);
    before = s.along;
  }
}

void rub(const Contacts& contacts, int nodes, const Lanes3* p, Lanes3* from) {
  for (int i = 2; i < nodes; ++i) {
    const LaneMask touched = contacts.touched[i];
    if (!any(touched)) continue;
    const Lanes3 slip = p[i] - from[i] - contacts.surfaceMove[i];
    const Lanes3 slid = across(slip, contacts.normal[i]) * splat(1.0f - kFriction);
    from[i] = select(touched, p[i] - contacts.surfaceMove[i] - slid, from[i]);
  }
}

}  // namespace fur::hair
