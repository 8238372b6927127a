#include "scene/Pose.h"

#include <algorithm>

#include "core/PortableMath.h"
#include "dynamics/Lanes.h"

namespace fur::scene {

namespace {

using dynamics::Lanes;

// An affine map by its columns.
struct LaneMatrix {
  Lanes x, y, z, w;
  explicit LaneMatrix(const Mat4& m)
      : x(dynamics::load(&m[0].x)), y(dynamics::load(&m[1].x)), z(dynamics::load(&m[2].x)), w(dynamics::load(&m[3].x)) {}
  Vec3 direction(const Vec3& v) const { return vector(x * v.x + y * v.y + z * v.z); }
  Vec3 point(const Vec3& v) const { return vector(x * v.x + y * v.y + z * v.z + w); }
  static Vec3 vector(const Lanes& v) { return {v[0], v[1], v[2]}; }
};

LaneMatrix blended(const std::vector<Mat4>& joints, const std::array<std::uint16_t, 4>& of, const Vec4& weights) {
  LaneMatrix sum(joints[of[0]]);
  if (weights[0] == 1.0f) return sum;
  sum.x *= weights[0], sum.y *= weights[0], sum.z *= weights[0], sum.w *= weights[0];
  for (int k = 1; k < 4 && weights[k] > 0; ++k) {
    const LaneMatrix m(joints[of[static_cast<std::size_t>(k)]]);
    const float w = weights[k];
    sum.x += m.x * w, sum.y += m.y * w, sum.z += m.z * w, sum.w += m.w * w;
  }
  return sum;
}

Vec3 anyAcross(const Vec3& n) {
  return normalizeOr(glm::cross(n, std::abs(n.y) < 0.9f ? Vec3(0, 1, 0) : Vec3(1, 0, 0)), Vec3(1, 0, 0));
}

// From the rotation a on the shorter way to b, as glTF 2.0, appendix C.5 has it: the same bits everywhere.
Vec4 slerped(const Vec4& a, Vec4 b, float t) {
  if (glm::dot(a, b) < 0) b = -b;
  const float sum = glm::length(a + b);
  const float angle = sum > 0 ? 2 * portableAtan(glm::length(a - b) / sum) : 0;
  // Nearer to each other the chord is the arc to rounding.
  if (angle < 1e-3f) return a + (b - a) * t;
  return a * portableSin((1 - t) * angle) + b * portableSin(t * angle);  // of length sin(angle)
}

Quat normalized(const Quat& q) {
  const float length = glm::length(q);
  return length > 1e-12f ? q / length : Quat(1, 0, 0, 0);
}

Quat between(const Quat& a, const Quat& b, float share) {
  const Vec4 turned = slerped(Vec4(a.x, a.y, a.z, a.w), Vec4(b.x, b.y, b.z, b.w), share);
  return normalized(Quat(turned.w, turned.x, turned.y, turned.z));
}

}  // namespace

void sample(const Rig::Channel& channel, float seconds, float* out) {
  const std::size_t width = channel.width, count = channel.times.size();
  const bool cubic = channel.interpolation == Interpolation::Cubic;
  const auto valueAt = [&](std::size_t key) { return &channel.values[(cubic ? 3 * key + 1 : key) * width]; };
  const auto after = std::upper_bound(channel.times.begin(), channel.times.end(), seconds);
  const auto next = static_cast<std::size_t>(after - channel.times.begin());
  if (next == 0 || next == count || channel.interpolation == Interpolation::Step) {
    std::copy_n(valueAt(next == 0 ? 0 : next - 1), width, out);
  } else {
    const float span = channel.times[next] - channel.times[next - 1];
    const float t = span > 0 ? (seconds - channel.times[next - 1]) / span : 0;
    const float *a = valueAt(next - 1), *b = valueAt(next);
    if (cubic) {
      // glTF 2.0, appendix C.
      const float *leaving = a + width, *coming = b - width, t2 = t * t, t3 = t2 * t;
      for (std::size_t i = 0; i < width; ++i)
        out[i] = (2 * t3 - 3 * t2 + 1) * a[i] + span * (t3 - 2 * t2 + t) * leaving[i] + (3 * t2 - 2 * t3) * b[i] +
                 span * (t3 - t2) * coming[i];
    } else if (channel.path == Path::Rotation) {
      const Vec4 turned = slerped(Vec4(a[0], a[1], a[2], a[3]), Vec4(b[0], b[1], b[2], b[3]), t);
      for (int i = 0; i < 4; ++i) out[i] = turned[i];
    } else {
      for (std::size_t i = 0; i < width; ++i) out[i] = a[i] + (b[i] - a[i]) * t;
    }
  }
  if (channel.path != Path::Rotation) return;
  const float length = std::sqrt(out[0] * out[0] + out[1] * out[1] + out[2] * out[2] + out[3] * out[3]);
  for (int i = 0; i < 4; ++i) out[i] = length > 1e-12f ? out[i] / length : i == 3 ? 1.0f : 0.0f;
}

Pose::Pose(const Rig& rig) : rig_(&rig), positions_(rig.positions), normals_(rig.normals) {
  for (const Vec3& n : rig.normals) firstTangents_.push_back(anyAcross(n));
  tangents_ = firstTangents_;
  set(-1, 0);
}

// As the file has it.
void Pose::rest(Local& out) const {
  out.nodes.clear();
  for (const Rig::Node& node : rig_->nodes) out.nodes.push_back({node.translation, node.rotation, node.scale});
  out.weights = rig_->restWeights;
}

void Pose::play(const PlayedClip& clip, Local& out) {
  if (clip.animation < 0 || clip.animation >= static_cast<int>(rig_->animations.size())) return;
  for (const Rig::Channel& channel : rig_->animations[static_cast<std::size_t>(clip.animation)].channels) {
    value_.resize(std::max<std::size_t>(channel.width, 4));
    sample(channel, clip.seconds, value_.data());
    Local::Place& node = out.nodes[channel.node];
    const Vec3 vector(value_[0], value_[1], value_[2]);
    switch (channel.path) {
      case Path::Translation: node.translation = vector; break;
      case Path::Rotation: node.rotation = Quat(value_[3], value_[0], value_[1], value_[2]); break;
      case Path::Scale: node.scale = vector; break;
      case Path::Weights: std::copy_n(value_.begin(), channel.width, out.weights.begin() + rig_->nodes[channel.node].firstWeight); break;
    }
  }
}

void Pose::blend(Local& sum, const Local& other, float share) {
  for (std::size_t i = 0; i < sum.nodes.size(); ++i) {
    Local::Place& to = sum.nodes[i];
    const Local::Place& from = other.nodes[i];
    to.translation += (from.translation - to.translation) * share;
    to.scale += (from.scale - to.scale) * share;
    if (from.rotation != to.rotation) to.rotation = between(to.rotation, from.rotation, share);
  }
  for (std::size_t i = 0; i < sum.weights.size(); ++i) sum.weights[i] += (other.weights[i] - sum.weights[i]) * share;
}

void Pose::add(const PlayedClip& layer, Local& to) {
  rest(other_);
  play(layer, other_);
  for (std::size_t i = 0; i < to.nodes.size(); ++i) {
    const Rig::Node& still = rig_->nodes[i];
    const Local::Place& from = other_.nodes[i];
    to.nodes[i].translation += (from.translation - still.translation) * layer.weight;
    to.nodes[i].scale += (from.scale - still.scale) * layer.weight;
    if (from.rotation == still.rotation) continue;
    const Quat turn = glm::conjugate(still.rotation) * from.rotation;
    to.nodes[i].rotation = normalized(to.nodes[i].rotation * between(Quat(1, 0, 0, 0), turn, layer.weight));
  }
  for (std::size_t i = 0; i < to.weights.size(); ++i) to.weights[i] += (other_.weights[i] - rig_->restWeights[i]) * layer.weight;
}

// Parents come first.
void Pose::placeNodes() {
  const std::vector<Rig::Node>& nodes = rig_->nodes;
  Mat4 fit(rig_->scale);
  fit[3] = Vec4(-rig_->centre * rig_->scale, 1);
  transforms_.resize(nodes.size());
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    Mat4 local = nodes[i].matrix;
    if (!nodes[i].fixed) {
      const Local::Place& place = now_.nodes[i];
      local = glm::mat4_cast(place.rotation);
      for (int c = 0; c < 3; ++c) local[c] *= place.scale[c];
      local[3] = Vec4(place.translation, 1);
    }
    transforms_[i] = (nodes[i].parent < 0 ? fit : transforms_[static_cast<std::size_t>(nodes[i].parent)]) * local;
  }
}

void Pose::placePart(const Rig::Part& part) {
  const Rig& rig = *rig_;
  if (part.skin >= 0) {
    const Rig::Skin& skin = rig.skins[static_cast<std::size_t>(part.skin)];
    joints_.clear();
    for (std::size_t i = 0; i < skin.joints.size(); ++i) joints_.push_back(transforms_[skin.joints[i]] * skin.inverseBinds[i]);
  }
  const LaneMatrix rigid(transforms_[part.node]);
  const float* weights = now_.weights.data() + rig.nodes[part.node].firstWeight;
  for (std::size_t i = part.firstVertex; i < part.firstVertex + part.vertices; ++i) {
    Vec3 p = rig.positions[i], n = rig.normals[i], t = firstTangents_[i];
    for (std::uint32_t k = 0; k < part.targets; ++k) {
      if (weights[k] == 0) continue;
      const Vec3* delta = &rig.deltas[part.firstDelta + 2 * (std::size_t{k} * part.vertices + i - part.firstVertex)];
      p += delta[0] * weights[k];
      n += delta[1] * weights[k];
    }
    const LaneMatrix m = part.skin >= 0 ? blended(joints_, rig.joints[i], rig.weights[i]) : rigid;
    // Two tangents span the skin wherever the map takes them: right for any scale.
    if (part.targets) t -= n * (glm::dot(t, n) / std::max(glm::dot(n, n), 1e-12f));
    const Vec3 along = m.direction(t), aside = m.direction(glm::cross(n, t)), position = m.point(p);
    // A map that mirrors turns them over.
    const Vec3 facing = glm::cross(along, aside);
    const Vec3 up = normalizeOr(glm::dot(facing, m.direction(n)) < 0 ? -facing : facing, normals_[i]);
    positions_[i] = std::isfinite(position.x + position.y + position.z) ? position : positions_[i];
    normals_[i] = up;
    const Vec3 across = along - up * glm::dot(along, up);
    const float squared = glm::dot(across, across);
    tangents_[i] = squared > 1e-24f && squared < 1e24f ? across * (1.0f / std::sqrt(squared)) : anyAcross(up);
  }
}

void Pose::placeParts() {
  for (const Rig::Part& part : rig_->parts) placePart(part);
}

void Pose::set(int animation, float seconds) {
  rest(now_);
  play({animation, seconds}, now_);
  placeNodes();
  placeParts();
}

void Pose::set(const PoseMix& mix) {
  rest(now_);
  float sum = 0;
  for (const PlayedClip& clip : mix.bodies) {
    if (!(clip.weight > 0)) continue;
    const bool first = sum == 0;
    sum += clip.weight;
    Local& played = first ? now_ : other_;
    rest(played);
    play(clip, played);
    if (!first) blend(now_, other_, clip.weight / sum);
  }
  for (const PlayedClip& layer : mix.layers)
    if (layer.weight != 0) add(layer, now_);
  for (const JointTurn& one : mix.turns)
    if (one.node < now_.nodes.size()) now_.nodes[one.node].rotation = normalized(now_.nodes[one.node].rotation * one.turn);
  placeNodes();
  placeParts();
}

}  // namespace fur::scene
