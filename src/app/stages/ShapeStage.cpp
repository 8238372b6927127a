#include "app/stages/ShapeStage.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "core/NoteChange.h"
#include "core/Numbering.h"
#include "geometry/Weld.h"

namespace fur::app {

namespace {

// Poses of an animation that are looked at for how far it goes.
constexpr int kMeasuredPoses = 12;
constexpr int kMixed = -2;  // no animation: several

// Values of the mesh's vertices as values of the surface's.
void spread(const std::vector<std::uint32_t>& sources, const Vec3* source, std::vector<Vec3>& to) {
  to.resize(sources.size());
  Vec3* out = to.data();
  for (const std::uint32_t i : sources) *out++ = source[i];
}

// The same with those of the vertices that were inserted between them.
void spread(const geometry::Surface& surface, const std::vector<std::uint32_t>& sources, std::span<const Vec3> from,
            std::vector<Vec3>& to) {
  if (surface.inserted.empty()) return spread(sources, from.data(), to);
  std::vector<Vec3> all(from.begin(), from.end());
  for (const geometry::InsertedVertex& vertex : surface.inserted) all.push_back(vertex.of(all));
  spread(sources, all.data(), to);
}

// The part of a tangent that is across a normal, unit.
Vec3 tangentAcross(const Vec3& n, const Vec3& tangent) {
  const Vec3 other = std::abs(n.x) < 0.6f ? Vec3(1, 0, 0) : Vec3(0, 1, 0);
  return normalizeOr(tangent - n * glm::dot(n, tangent), normalizeOr(other - n * glm::dot(n, other), other));
}

// Square, also of normals and tangents between two vertices.
Mat3 frameOf(Vec3 normal, Vec3 tangent) {
  normal = normalizeOr(normal, Vec3(0, 1, 0));
  tangent = tangentAcross(normal, tangent);
  return Mat3(normal, tangent, glm::cross(normal, tangent));
}

// The smallest sphere that holds a point, or another sphere, and the sphere before.
void include(ShapeStage::Extent& extent, const Vec3& point, float radius = 0) {
  const Vec3 away = point - extent.centre;
  const float length = glm::length(away), distance = length + radius;
  if (distance <= extent.radius) return;
  if (length + extent.radius <= radius) return void(extent = {point, radius});
  const float further = 0.5f * (distance - extent.radius);
  extent.centre += away * (further / length);
  extent.radius += further;
}

}  // namespace

std::pair<Vec3, Vec3> axesOn(const Vec3& normal) {
  const Vec3 side = normalizeOr(glm::cross(normal, std::abs(normal.y) < 0.9f ? Vec3(0, 1, 0) : Vec3(1, 0, 0)), Vec3(1, 0, 0));
  return {side, glm::cross(normal, side)};
}

void ShapeStage::setModel(geometry::Mesh mesh, ShownSurface surface, scene::Rig rig, std::vector<std::uint8_t> materialOf) {
  mesh_ = std::move(mesh);
  ofMesh_ = std::move(materialOf);
  rig_ = std::move(rig);
  setSurface(std::move(surface));
}

void ShapeStage::setSurface(ShownSurface surface) {
  shown_ = std::move(surface);
  ++surfaceRevision_;
  spreadMaterials();
  bindRig();
  reaches_.clear();
  measure({});
}

// A vertex that was inserted lies on an edge of the mesh, which has one material.
void ShapeStage::spreadMaterials() {
  materialOf_.clear();
  if (ofMesh_.empty()) return;
  std::vector<std::uint8_t> all = ofMesh_;
  for (const geometry::InsertedVertex& vertex : surface().inserted) all.push_back(all[vertex.a]);
  for (const geometry::SurfaceVertex& vertex : surface().vertices) materialOf_.push_back(all[vertex.source]);
}

int ShapeStage::animationOf(int setting) const {
  return setting <= static_cast<int>(rig_.animations.size()) ? setting - 1 : -1;
}

// The rig as it stands by itself; the surface is new.
void ShapeStage::bindRig() {
  skin_ = {};
  sources_.clear();
  leans_.clear();
  pose_.reset();
  firstTangents_.clear();
  animation_ = -1;
  seconds_ = 0;
  lastPositions_.clear();
  lastSeconds_ = 0;
  if (!rig_.moves()) return;
  pose_.emplace(rig_);
  for (const geometry::SurfaceVertex& v : surface().vertices) sources_.push_back(v.source);
  readSkin();
  std::vector<Vec3> positions, normals;
  for (const geometry::SurfaceVertex& v : surface().vertices) positions.push_back(v.position), normals.push_back(v.normal);
  const geometry::Weld places = geometry::weldPositions(positions), ways = geometry::weldPositions(normals);
  Numbering points;
  // What the importer has computed in double precision.
  for (std::size_t i = 0; i < surface().vertices.size(); ++i) {
    const Mat3 frame = frameOf(skin_.normals[i], skin_.tangents[i]);
    skin_.positions[i] = positions[i];
    const Vec3 n = skin_.normals[i] = normals[i];
    skin_.tangents[i] = normalizeOr(skin_.tangents[i] - n * glm::dot(n, skin_.tangents[i]), Vec3(1, 0, 0));
    leans_.push_back({n * frame, skin_.tangents[i] * frame, points.of(std::uint64_t{places.idOf[i]} << 32 | ways.idOf[i])});
  }
  firstTangents_ = skin_.tangents;
}

void ShapeStage::readSkin() {
  spread(surface(), sources_, pose_->positions(), skin_.positions);
  spread(surface(), sources_, pose_->normals(), skin_.normals);
  spread(surface(), sources_, pose_->tangents(), skin_.tangents);
  if (!leans_.empty()) followSkin();
}

// Fur stands on the model's own normals as when the surface was made (geometry/FurDirections.h, HardEdges.h); where it leans over hard edges, and
// faces bend apart, between them.
void ShapeStage::followSkin() {
  if (!surface().turned) {
    // Those of a pose are unit and perpendicular.
    for (std::size_t i = 0; i < leans_.size(); ++i) {
      Vec3 &n = skin_.normals[i], &t = skin_.tangents[i];
      const Mat3 frame(n, t, glm::cross(n, t));
      n = frame * leans_[i].normal;
      t = frame * leans_[i].tangent;
    }
    return;
  }
  std::vector<Vec3> sums(leans_.size(), Vec3(0));
  for (std::size_t i = 0; i < sums.size(); ++i) {
    const Mat3 frame = frameOf(skin_.normals[i], skin_.tangents[i]);
    skin_.tangents[i] = frame * leans_[i].tangent;
    sums[leans_[i].point] += skin_.normals[i] = frame * leans_[i].normal;
  }
  for (std::size_t i = 0; i < sums.size(); ++i) {
    const Vec3 n = skin_.normals[i] = normalizeOr(sums[leans_[i].point], skin_.normals[i]);
    skin_.tangents[i] = tangentAcross(n, skin_.tangents[i]);
  }
}

void ShapeStage::measure(std::span<const int> animations) {
  measuredFor_.assign(animations.begin(), animations.end());
  extent_ = {};
  groundHeight_ = top_ = 0;
  for (const geometry::SurfaceVertex& v : surface().vertices) groundHeight_ = std::min(groundHeight_, v.position.y), top_ = std::max(top_, v.position.y);
  for (const int animation : animations) {
    const Reach& reach = reachOf(animation);
    if (animations.size() == 1) extent_ = reach.extent;
    else include(extent_, reach.extent.centre, reach.extent.radius);
    top_ = std::max(top_, reach.top);
    if (animation == animations.front()) groundHeight_ = std::min(groundHeight_, reach.ground);
  }
}

const ShapeStage::Reach& ShapeStage::reachOf(int animation) {
  const auto known = std::find_if(reaches_.begin(), reaches_.end(), [&](const Reach& reach) { return reach.animation == animation; });
  if (known != reaches_.end()) return *known;
  Reach reach{animation, {}, 0, 0};
  const float duration = rig_.animations[static_cast<std::size_t>(animation)].duration;
  for (int k = 0; k < kMeasuredPoses; ++k) {
    pose_->set(animation, duration * static_cast<float>(k) / kMeasuredPoses);
    for (const Vec3& p : pose_->positions()) {
      reach.ground = std::min(reach.ground, p.y);
      reach.top = std::max(reach.top, p.y);
      include(reach.extent, p);
    }
  }
  // The pose is what is shown.
  if (animation_ != kMixed) pose_->set(animation_, static_cast<float>(seconds_));
  else animation_ = -1;  // then it is set in this update
  return reaches_.emplace_back(reach);
}

bool ShapeStage::play(const Inputs& inputs) {
  if (inputs.mix) {
    if (animation_ == kMixed && mixShown_ == inputs.mixRevision) return false;
    animation_ = kMixed;
    mixShown_ = inputs.mixRevision;
    pose_->set(*inputs.mix);
    return true;
  }
  double seconds = inputs.animation == animation_ ? seconds_ : 0;
  if (active(inputs)) {
    const double duration = rig_.animations[static_cast<std::size_t>(inputs.animation)].duration;
    seconds += static_cast<double>(inputs.seconds * inputs.speed);
    seconds -= duration * std::floor(seconds / duration);
  }
  if (inputs.animation == animation_ && seconds == seconds_) return false;
  animation_ = inputs.animation;
  seconds_ = seconds;
  pose_->set(animation_, static_cast<float>(seconds_));
  return true;
}

bool ShapeStage::update(const Inputs& inputs) {
  if (!pose_) return false;
  const std::span<const int> one(&inputs.animation, inputs.animation >= 0 ? 1 : 0), plays = inputs.mix ? inputs.played : one;
  if (!std::equal(plays.begin(), plays.end(), measuredFor_.begin(), measuredFor_.end())) measure(plays);
  lastSeconds_ = 0;
  if (!play(inputs)) return false;
  std::swap(lastPositions_, skin_.positions);
  lastSeconds_ = inputs.seconds;
  readSkin();
  ++poseRevision_;
  return true;
}

const geometry::SurfaceQuery& ShapeStage::shownQuery() const {
  if (!pose_) return query();
  if (noteChange(posedQueryFor_, revision())) {
    if (noteChange(posedQueryOf_, surfaceRevision_)) posedQuery_ = query();
    posedQuery_.follow(surface(), skin_.positions);
  }
  return posedQuery_;
}

Vec3 ShapeStage::shownPosition(const geometry::SurfacePoint& at) const {
  return pose_ ? valueAt(surface(), at, skin_.positions) : positionAt(surface(), at);
}

Vec3 ShapeStage::shownNormal(const geometry::SurfacePoint& at) const {
  if (!pose_) return normalAt(surface(), at);
  return normalizeOr(valueAt(surface(), at, skin_.normals), skin_.normals[surface().indices[3 * std::size_t{at.triangle}]]);
}

std::optional<geometry::SurfacePoint> ShapeStage::nearest(const Vec3& place) const {
  // Either side will do: the point is on the surface, or nearly.
  for (const float radius : {0.01f, 0.1f, 4.0f})
    for (const Vec3& side : {Vec3(0, 1, 0), Vec3(0, -1, 0), Vec3(1, 0, 0), Vec3(-1, 0, 0), Vec3(0, 0, 1), Vec3(0, 0, -1)})
      if (const auto at = nearestPoint(surface(), query(), place, radius, side)) return at;
  return std::nullopt;
}

}  // namespace fur::app
