#include "app/stages/Repertoire.h"

#include <algorithm>
#include <string_view>

#include "scene/Pose.h"

namespace fur::app {

namespace {

constexpr int kLooks = 24;  // for where a gesture is furthest

int nodeNamed(const scene::Rig& rig, std::string_view name) {
  for (std::size_t i = 0; i < rig.nodes.size(); ++i)
    if (rig.nodes[i].name == name) return static_cast<int>(i);
  return -1;
}

// How far a channel is from the model at rest.
float awayFromRest(const scene::Rig& rig, const scene::Rig::Channel& channel, float seconds, std::vector<float>& value) {
  const scene::Rig::Node& node = rig.nodes[channel.node];
  value.resize(std::max<std::size_t>(channel.width, 4));
  scene::sample(channel, seconds, value.data());
  const Vec3 vector(value[0], value[1], value[2]);
  switch (channel.path) {
    case scene::Path::Translation: return rig.scale * glm::length(vector - node.translation);
    case scene::Path::Rotation: return 1 - std::abs(glm::dot(node.rotation, Quat(value[3], value[0], value[1], value[2])));
    case scene::Path::Scale: return glm::length(vector - node.scale);
    case scene::Path::Weights: return 0;
  }
  return 0;
}

float peakOf(const scene::Rig& rig, const scene::Rig::Animation& animation) {
  std::vector<float> value;
  float most = 0, peak = 0;
  for (int k = 1; k < kLooks; ++k) {
    const float seconds = animation.duration * static_cast<float>(k) / kLooks;
    float away = 0;
    for (const scene::Rig::Channel& channel : animation.channels) away += awayFromRest(rig, channel, seconds, value);
    if (away > most) most = away, peak = seconds;
  }
  return peak;
}

Repertoire::Clip clipNamed(const scene::Rig& rig, std::string_view name) {
  for (std::size_t i = 0; i < rig.animations.size(); ++i)
    if (rig.animations[i].name == name) return {static_cast<int>(i), rig.animations[i].duration, 0};
  return {};
}

// Nodes that are the head or hang on it; parents come first.
std::vector<bool> headOf(const scene::Rig& rig, int head) {
  std::vector<bool> held(rig.nodes.size());
  for (std::size_t i = 0; i < held.size(); ++i) {
    const int parent = rig.nodes[i].parent;
    held[i] = static_cast<int>(i) == head || (parent >= 0 && held[static_cast<std::size_t>(parent)]);
  }
  return held;
}

// A joint alone holds it, or a vertex most.
std::size_t holderOf(const scene::Rig& rig, const scene::Rig::Part& part, std::size_t vertex) {
  if (part.skin < 0) return part.node;
  int most = 0;
  for (int k = 1; k < 4; ++k)
    if (rig.weights[vertex][k] > rig.weights[vertex][most]) most = k;
  return rig.skins[static_cast<std::size_t>(part.skin)].joints[rig.joints[vertex][static_cast<std::size_t>(most)]];
}

std::vector<Repertoire::Part> partsOf(const scene::Rig& rig, int head) {
  const std::vector<bool> held = headOf(rig, head);
  const scene::Pose rest(rig);
  const Vec3 middle(rest.transform(static_cast<std::size_t>(head))[3]);
  std::vector<Repertoire::Part> parts(rig.positions.size(), Repertoire::Part::Body);
  for (const scene::Rig::Part& part : rig.parts)
    for (std::size_t i = part.firstVertex; i < std::size_t{part.firstVertex} + part.vertices; ++i)
      if (held[holderOf(rig, part, i)]) parts[i] = rest.positions()[i].x > middle.x ? Repertoire::Part::HeadLeft : Repertoire::Part::HeadRight;
  return parts;
}

}  // namespace

std::string Repertoire::names() const {
  std::string lines;
  for (std::size_t i = 0; i < kActionCount; ++i)
    if (behaves() && actions[i].there()) lines += std::string(traitsOf(static_cast<Action>(i)).name) + '\n';
  return lines;
}

Repertoire repertoireOf(const scene::Rig& rig) {
  Repertoire can;
  for (std::size_t i = 0; i < kActionCount; ++i) can.actions[i] = clipNamed(rig, traitsOf(static_cast<Action>(i)).name);
  for (std::size_t i = 0; i < kGestureCount; ++i) can.gestures[i] = clipNamed(rig, nameOf(static_cast<Gesture>(i)));
  can.neck = nodeNamed(rig, "neck");
  can.head = nodeNamed(rig, "head");
  can.eyes = {nodeNamed(rig, "eyeL"), nodeNamed(rig, "eyeR")};
  if (!can.behaves()) return can;
  for (Repertoire::Clip& clip : can.gestures)
    if (clip.there()) clip.peak = peakOf(rig, rig.animations[static_cast<std::size_t>(clip.animation)]);
  can.parts = partsOf(rig, can.head);
  return can;
}

}  // namespace fur::app
