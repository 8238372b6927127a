// The half of App that plays a model's animations.
#include <algorithm>
#include <cmath>
#include <cstdint>

#include "app/AppState.h"
#include "core/Numbering.h"
#include "geometry/Weld.h"

namespace fur::app {

namespace {

// Values of the mesh's vertices as values of the surface's.
void spread(const std::vector<std::uint32_t>& sources, const Vec3* source, std::vector<Vec3>& to) {
  to.resize(sources.size());
  Vec3* out = to.data();
  for (const std::uint32_t i : sources) *out++ = source[i];
}

// The same with those of the vertices between them.
void spread(const geometry::Surface& surface, const std::vector<std::uint32_t>& sources, std::span<const Vec3> from,
            std::vector<Vec3>& to) {
  if (surface.inserted.empty()) return spread(sources, from.data(), to);
  std::vector<Vec3> all(from.begin(), from.end());
  for (const geometry::InsertedVertex& vertex : surface.inserted) all.push_back(vertex.of(all));
  spread(sources, all.data(), to);
}

// The part of a tangent that is across a normal.
Vec3 acrossOf(const Vec3& n, const Vec3& tangent) {
  const Vec3 other = std::abs(n.x) < 0.6f ? Vec3(1, 0, 0) : Vec3(0, 1, 0);
  return normalizeOr(tangent - n * glm::dot(n, tangent), normalizeOr(other - n * glm::dot(n, other), other));
}

// Square, also where it comes of normals and tangents between two vertices.
Mat3 frameOf(Vec3 normal, Vec3 tangent) {
  normal = normalizeOr(normal, Vec3(0, 1, 0));
  tangent = acrossOf(normal, tangent);
  return Mat3(normal, tangent, glm::cross(normal, tangent));
}

// Poses of an animation that are looked at for where it goes.
constexpr int kMeasuredPoses = 12;
constexpr float kSameView = 1e-3f;  // model units

}  // namespace

int App::State::animation() const {
  const int count = static_cast<int>(rig.animations.size());
  return settings.animation <= count ? settings.animation - 1 : -1;
}

bool App::State::animates() const { return animation() >= 0 && settings.animationSpeed > 0 && !reducedMotion; }

// The rig as it stands by itself; the surface is new.
void App::State::takeRig() {
  skin = {};
  pose.reset();
  firstTangents.clear();
  posedFor = {-1, 0};
  posedQueryStale = true;
  if (!rig.moves()) return;
  pose.emplace(rig);
  for (const geometry::SurfaceVertex& v : surface.vertices) skin.sources.push_back(v.source);
  takeSkin();
  std::vector<Vec3> positions, normals;
  for (const geometry::SurfaceVertex& v : surface.vertices) positions.push_back(v.position), normals.push_back(v.normal);
  const geometry::Weld places = geometry::weldPositions(positions), ways = geometry::weldPositions(normals);
  Numbering points;
  // What the importer has computed in double precision.
  for (std::size_t i = 0; i < surface.vertices.size(); ++i) {
    const Mat3 frame = frameOf(skin.normals[i], skin.tangents[i]);
    skin.positions[i] = positions[i];
    const Vec3 n = skin.normals[i] = normals[i];
    skin.tangents[i] = normalizeOr(skin.tangents[i] - n * glm::dot(n, skin.tangents[i]), Vec3(1, 0, 0));
    if (surface.turned)
      skin.leans.push_back({n * frame, skin.tangents[i] * frame, points.of(std::uint64_t{places.idOf[i]} << 32 | ways.idOf[i])});
  }
  firstTangents = skin.tangents;
}

void App::State::takeSkin() {
  spread(surface, skin.sources, pose->positions(), skin.positions);
  spread(surface, skin.sources, pose->normals(), skin.normals);
  spread(surface, skin.sources, pose->tangents(), skin.tangents);
  if (!skin.leans.empty()) leanAsMade();
}

// Fur that leans over hard edges does so from its faces as when the surface was made; where they bend apart, between them.
void App::State::leanAsMade() {
  std::vector<Vec3> sums(skin.leans.size(), Vec3(0));
  for (std::size_t i = 0; i < sums.size(); ++i) {
    const Mat3 frame = frameOf(skin.normals[i], skin.tangents[i]);
    skin.tangents[i] = frame * skin.leans[i].tangent;
    sums[skin.leans[i].point] += skin.normals[i] = frame * skin.leans[i].normal;
  }
  for (std::size_t i = 0; i < sums.size(); ++i) {
    const Vec3 n = skin.normals[i] = normalizeOr(sums[skin.leans[i].point], skin.normals[i]);
    skin.tangents[i] = acrossOf(n, skin.tangents[i]);
  }
}

void App::State::measure(bool atOnce) {
  const CameraOrbit before = startView();
  extent = {};
  groundHeight = 0;
  for (const geometry::SurfaceVertex& v : surface.vertices) groundHeight = std::min(groundHeight, v.position.y);
  measuredFor = animation();
  if (pose && measuredFor >= 0) {
    const float duration = rig.animations[static_cast<std::size_t>(measuredFor)].duration;
    for (int k = 0; k < kMeasuredPoses; ++k) {
      pose->set(measuredFor, duration * static_cast<float>(k) / kMeasuredPoses);
      for (const Vec3& p : pose->positions()) {
        groundHeight = std::min(groundHeight, p.y);
        const Vec3 away = p - extent.centre;
        const float distance = glm::length(away);
        if (distance <= extent.radius) continue;
        // The smallest sphere that holds it and the one before.
        const float further = 0.5f * (distance - extent.radius);
        extent.centre += away * (further / distance);
        extent.radius += further;
      }
    }
    pose->set(posedFor.first, static_cast<float>(posedFor.second));
  }
  CameraOrbit goal = camera.goal();
  const CameraOrbit now = startView();
  // To what a state in text keeps of it.
  if (std::abs(goal.distance - before.distance) > kSameView || glm::distance(goal.target, before.target) > kSameView) return;
  goal.distance = now.distance;
  goal.target = now.target;
  if (atOnce) camera.jump(goal);
  else camera.setGoal(goal);
}

bool App::State::refreshPose(float dt) {
  if (!pose) return false;
  const int wanted = animation();
  if (wanted != measuredFor) measure(false);
  if (wanted != posedFor.first) animationTime = 0;
  if (animates()) {
    const double duration = rig.animations[static_cast<std::size_t>(wanted)].duration;
    animationTime += static_cast<double>(dt * settings.animationSpeed);
    animationTime -= duration * std::floor(animationTime / duration);
  }
  const std::pair now(wanted, animationTime);
  if (now == posedFor) return false;
  posedFor = now;
  pose->set(wanted, static_cast<float>(animationTime));
  takeSkin();
  bends.setPose(skin.positions, skin.normals, skin.tangents);
  posedQueryStale = pictureChanged = true;
  uploadPose();
  return true;
}

void App::State::uploadPose() {
  if (!renderer || !pose) return;
  renderer->setSkin({skin.positions, skin.normals, skin.tangents});
  uploadWhiskers();
}

const geometry::SurfaceQuery& App::State::shownQuery() {
  if (!pose) return query;
  if (posedQueryStale) {
    posedQuery = query;
    posedQuery.follow(surface, skin.positions);
    posedQueryStale = false;
  }
  return posedQuery;
}

Vec3 App::State::shownPosition(const geometry::SurfacePoint& at) const {
  return pose ? valueAt(surface, at, skin.positions) : positionAt(surface, at);
}

Vec3 App::State::shownNormal(const geometry::SurfacePoint& at) const {
  if (!pose) return normalAt(surface, at);
  return normalizeOr(valueAt(surface, at, skin.normals), skin.normals[surface.indices[3 * std::size_t{at.triangle}]]);
}

// Hairs stand on the surface as it was made; they go along with their triangles.
void App::State::carry(std::vector<groom::WhiskerHair>& hairs) const {
  if (!pose) return;
  for (groom::WhiskerHair& hair : hairs) {
    const auto corner = [&](int k) { return static_cast<std::size_t>(hair.vertices[k]); };
    const std::size_t v = corner(0);
    const auto frame = [](const Vec3& n, const Vec3& t) { return Mat3(n, t, glm::cross(n, t)); };
    const Mat3 turn = frame(skin.normals[v], skin.tangents[v]) *
                      glm::transpose(frame(surface.vertices[v].normal, firstTangents[v]));
    hair.root = Vec3(0);
    for (int k = 0; k < 3; ++k) hair.root += skin.positions[corner(k)] * hair.weights[k];
    hair.direction = turn * hair.direction;
    hair.curve = turn * hair.curve;
    hair.normal = turn * hair.normal;
  }
}

std::string App::animations() const {
  std::string lines;
  for (const scene::Rig::Animation& animation : state_->rig.animations) lines += animation.name + '\n';
  return lines;
}

}  // namespace fur::app
