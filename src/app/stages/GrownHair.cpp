#include "app/stages/GrownHair.h"

#include <algorithm>

#include "core/Fnv1a.h"
#include "core/NoteChange.h"
#include "hair/AmbientOcclusion.h"
#include "hair/BaseTangents.h"
#include "hair/PlantGuides.h"

namespace fur::app {

namespace {

hair::MotionValues motionValues(const hair::HairValues& values, const settings::Settings& settings) {
  hair::MotionValues out;
  out.model = static_cast<hair::Model>(settings.hairModel);
  out.stiffness = values.stiffness;
  out.softening = values.softening + 1;
  out.damping = values.damping;
  out.weight = values.weight;
  out.gravity = settings.gravity;
  out.volume = settings.hairVolume;
  return out;
}

// `asMade` where the skin is now: its tangent keeps its angle to the triangle's first edge.
hair::RootFrame frameAsShown(const ShapeStage& shape, const geometry::SurfacePoint& at, const hair::RootFrame& asMade) {
  const auto* skin = shape.skin();
  if (!skin) return asMade;
  const std::uint32_t* corner = &shape.surface().indices[std::size_t{3} * at.triangle];
  const auto& vertices = shape.surface().vertices;
  const auto edgeOn = [](const Vec3& edge, const Vec3& normal) { return normalizeOr(edge - normal * glm::dot(normal, edge), axesOn(normal).first); };
  const Vec3 before = edgeOn(vertices[corner[1]].position - vertices[corner[0]].position, asMade.normal);
  const Vec3 normal = shape.shownNormal(at), now = edgeOn(skin->positions[corner[1]] - skin->positions[corner[0]], normal);
  const float along = glm::dot(asMade.tangent, before), aside = glm::dot(asMade.tangent, glm::cross(asMade.normal, before));
  return {shape.shownPosition(at), normal, now * along + glm::cross(normal, now) * aside};
}

std::vector<hair::Collider> collidersOf(std::span<const hair::Body> bodies, const HairStage::Inputs& inputs) {
  std::vector<hair::Collider> all;
  const auto world = [&](const Vec3& p) { return Vec3(inputs.worldFromModel * Vec4(p, 1)); };
  for (const hair::Body& body : bodies) all.push_back({world(body.a), world(body.b), body.radius});
  for (const dynamics::Contact& contact : inputs.contacts)
    if (contact.radius > 0) all.push_back({contact.to, contact.to, contact.radius});
  if (inputs.settings.ground) {
    // A ball so large that it is level: 0.007 lower two units from the middle.
    constexpr float kLevel = 300;
    const Vec3 below(0, inputs.shape.groundHeight() - kLevel, 0);
    all.push_back({below, below, kLevel});
  }
  return all;
}

std::uint64_t rootsHash(const hair::Guides& guides) {
  Fnv1a hash;
  for (std::size_t g = 0; g < guides.count(); ++g) hash.add(guides.root(g));
  return hash.value();
}

}  // namespace

void GrownHair::reset() {
  selected_ = 0;
  selectedBody_ = -1;
  before_.reset();
  scalps_.clear();
  givenState_.reset();
  settled_ = false;
  setStyle({});
}

void GrownHair::setStyle(hair::Hairstyle style) {
  style_ = std::move(style);
  selectedBody_ = std::min(selectedBody_, static_cast<int>(style_.bodies.size()) - 1);
  takeWetness();
  touch();
}

void GrownHair::touch() {
  // None is left over that a picture would take for another.
  if (scalps_.size() > style_.scalps.size()) scalps_.clear();
  stale_ = true;
  growing_ = {};
  ++revision_;
}

bool GrownHair::growSome(const ShapeStage& shape) {
  if (noteChange(surfaceFor_, shape.surfaceRevision())) stale_ = true, growing_ = {};
  if (!stale_) return true;
  scalps_.resize(style_.scalps.size());
  if (growing_.scalp < scalps_.size()) {
    const hair::Scalp& scalp = style_.scalps[growing_.scalp];
    LiveScalp& live = scalps_[growing_.scalp];
    switch (growing_.part++) {
      case 0: growGuides(scalp, live, shape); break;
      case 1: growWisps(scalp, live, shape); break;
      case 2: growLight(scalp, live, shape); break;
      default:
        growStrands(scalp, live);
        growing_ = {growing_.scalp + 1};
    }
    return false;
  }
  takeState();
  stale_ = false;
  growing_ = {};
  return true;
}

bool GrownHair::workOnGrowth(const Inputs& inputs) {
  if (!growSome(inputs.shape)) return false;
  if (!settled_ && !scalps_.empty()) settle(inputs);
  return true;
}

void GrownHair::growGuides(const hair::Scalp& scalp, LiveScalp& live, const ShapeStage& shape) {
  live.asMade = hair::rootFrames(shape.surface(), shape.query(), scalp.guides);
  live.roots.clear();
  for (const hair::RootFrame& root : live.asMade) {
    constexpr float kReach = 1e-2f;  // the frames stand on the surface
    live.roots.push_back(geometry::nearestPoint(shape.surface(), shape.query(), root.position, kReach, root.normal).value_or(geometry::SurfacePoint{0, Vec3(1, 0, 0), 0}));
  }
  // Hair goes on swinging where only its looks have changed.
  growing_.otherSurface = noteChange(live.surfaceFor, shape.surfaceRevision());
  if (live.guides == scalp.guides && !growing_.otherSurface) return;
  live.guides = scalp.guides;
  live.simulation.reset(scalp.guides, live.asMade);
  settled_ = false;
}

void GrownHair::growWisps(const hair::Scalp& scalp, LiveScalp& live, const ShapeStage& shape) {
  // What the wisps were planted for: a comb changes none of it.
  const std::uint64_t roots = rootsHash(scalp.guides), map = scalp.map.hash();
  growing_.sameLooks = live.values == scalp.values && !live.growth.members.empty();
  const bool sameWisps = growing_.sameLooks && live.plantedFor == std::pair(roots, map) && !growing_.otherSurface;
  if (sameWisps) {
    hair::followGuides(live.growth.wisps, scalp.guides, live.asMade, hair::shapeOf(scalp.values));
  } else {
    live.growth.wisps = hair::plantWisps({shape.surface(), scalp.map}, scalp.guides, live.asMade, scalp.values);
    live.plantedFor = {roots, map};
  }
  // Dabs change little of the light: it waits for the stroke's end.
  live.lightStale = sameWisps && stroking();
}

void GrownHair::growLight(const hair::Scalp& scalp, LiveScalp& live, const ShapeStage& shape) {
  if (live.lightStale) return;
  const std::vector<hair::GuideNode> rest = hair::restNodes(scalp.guides, live.asMade);
  live.growth.ambient = hair::ambientVisibility(shape.surface(), live.growth.wisps, rest, scalp.guides.nodes, scalp.values);
  live.growth.baseTangents = hair::baseTangents({shape.surface(), scalp.map}, live.growth.wisps, rest, scalp.guides.nodes, scalp.values);
}

void GrownHair::growStrands(const hair::Scalp& scalp, LiveScalp& live) {
  if (!growing_.sameLooks) {
    live.growth.members = hair::memberStrands(scalp.values.strands, scalp.values);
    live.growth.strips = hair::drawStrips(live.growth.members, scalp.values.strandWidth, scalp.values.mostWidth, scalp.values.tipWidth);
  }
  live.values = scalp.values;
  growWater(live);
  ++live.grown;
}

std::vector<hair::RootFrame> GrownHair::rootsNow(const LiveScalp& live, const Inputs& inputs) const {
  std::vector<hair::RootFrame> roots;
  roots.reserve(live.roots.size());
  const Mat3 turn(inputs.worldFromModel);
  for (std::size_t i = 0; i < live.roots.size(); ++i) {
    const hair::RootFrame model = frameAsShown(inputs.shape, live.roots[i], live.asMade[i]);
    roots.push_back({Vec3(inputs.worldFromModel * Vec4(model.position, 1)), turn * model.normal, turn * model.tangent});
  }
  return roots;
}

void GrownHair::showNodes(LiveScalp& live, const Inputs& inputs) {
  const auto nodes = live.simulation.nodes();
  live.nodes.assign(nodes.begin(), nodes.end());
  const Mat4 modelFromWorld = glm::inverse(inputs.worldFromModel);
  const Quat turn = glm::quat_cast(Mat3(modelFromWorld));
  for (std::size_t i = 0; i < live.nodes.size(); ++i) {
    hair::GuideNode& node = live.nodes[i];
    node.position = Vec3(modelFromWorld * Vec4(node.position, 1));
    node.frame = turn * node.frame;
    node.wetness = live.seen.empty() ? 0 : live.seen[i];
  }
  ++live.moved;
}

bool GrownHair::active(const Inputs& inputs) const {
  if (stale_ || surfaceFor_ != inputs.shape.surfaceRevision()) return !style_.scalps.empty();
  return std::any_of(scalps_.begin(), scalps_.end(), [](const LiveScalp& live) { return !live.simulation.atRest(); });
}

void GrownHair::growWhereStale(const ShapeStage& shape) {
  while (!growSome(shape)) {}
}

// Calls work(scalp, values of its motion, what acts on it) for each.
template <class Work>
void GrownHair::forScalps(const Inputs& inputs, Work work) {
  placeBodies(inputs.shape);
  const std::vector<hair::Collider> colliders = collidersOf(bodies_, inputs);
  hair::Surroundings around;
  around.up = normalizeOr(Vec3(inputs.worldFromModel[1]), Vec3(0, 1, 0));
  around.wind = &inputs.wind;
  around.colliders = colliders;
  for (std::size_t i = 0; i < scalps_.size(); ++i) {
    const std::vector<hair::RootFrame> roots = rootsNow(scalps_[i], inputs);
    around.roots = roots;
    around.wetness = scalps_[i].felt;
    work(scalps_[i], motionValues(style_.scalps[i].values, inputs.settings), around);
  }
}

bool GrownHair::update(const Inputs& inputs) {
  const std::uint64_t before = revision_;
  growWhereStale(inputs.shape);
  worldFromModel_ = inputs.worldFromModel;
  if (!settled_ && !scalps_.empty()) settle(inputs);
  std::vector<bool> wetted;
  for (LiveScalp& live : scalps_) wetted.push_back(wetnessNow(live, inputs));
  forScalps(inputs, [&](LiveScalp& live, const hair::MotionValues& values, const hair::Surroundings& around) {
    const bool moved = live.simulation.advance(inputs.seconds, values, around);
    if (moved) live.water.move(live.simulation.nodes(), inputs.seconds);
    else if (inputs.seconds > 0) live.water.rest();
    if (!moved && !wetted[static_cast<std::size_t>(&live - scalps_.data())]) return;
    showNodes(live, inputs);
    ++revision_;
  });
  return revision_ != before;
}

void GrownHair::settle(const Inputs& inputs) {
  growWhereStale(inputs.shape);
  worldFromModel_ = inputs.worldFromModel;
  for (LiveScalp& live : scalps_) wetnessNow(live, inputs);
  forScalps(inputs, [&](LiveScalp& live, const hair::MotionValues& values, const hair::Surroundings& around) {
    live.simulation.settle(values, around);
    live.water.move(live.simulation.nodes(), 0);
    showNodes(live, inputs);
  });
  settled_ = true;
  revision_ += !scalps_.empty();
}

}  // namespace fur::app
