// An animal made of two balls, with the joints and animations by whose names a model moves by itself.
#pragma once

#include <string>

#include "app/stages/BehaviourStage.h"
#include "core/PortableMath.h"
#include "geometry/Primitives.h"

namespace fur::test {

class Animal {
 public:
  scene::Rig rig;
  geometry::Mesh mesh;

  // Of the actions that are named, beside standing; `head` and `breathe` may be left out.
  explicit Animal(const std::vector<std::string>& actions = {"sit", "groom", "shake", "walk", "swim"}, const std::string& head = "head",
                  const std::string& breathe = "breathe", int around = 32) {
    addNode("root", -1, {});
    addNode("chest", 0, {0, 0.1f, 0.1f});
    addNode("neck", 1, {0, 0.1f, 0.25f});
    addNode(head, 2, {0, 0.1f, 0.1f});
    addNode("eyeL", 3, {0.05f, 0.05f, 0.12f});
    addNode("eyeR", 3, {-0.05f, 0.05f, 0.12f});
    addNode("earL", 3, {0.1f, 0.12f, 0});
    bind();
    addBall({0, 0, -0.1f}, 0.4f, 1, around);
    addBall({0, 0.35f, 0.5f}, 0.2f, 3, around);
    addTurn("stand", 2, 1, {0, 0, 1}, 0.02f, 1);
    for (const std::string& action : actions) addTurn(action, action == "shake" ? 1.5f : 3, 1, action == "sit" ? Vec3(1, 0, 0) : Vec3(0, 0, 1), action == "shake" ? 0.4f : 0.3f, action == "shake" ? 8 : 1);
    addTurn(breathe, 3, 1, {1, 0, 0}, 0.05f, 0.5f);
    for (const char* name : {"blink", "squint", "earFlickL", "earFlickR"}) addTurn(name, 0.3f, 6, {1, 0, 0}, 0.5f, 0.5f);
    addTurn("tailSway", 2, 0, {0, 1, 0}, 0.05f, 1);
    addTurn("leanL", 1, 1, {0, 0, 1}, 0.2f, 0.5f);
    addTurn("leanR", 1, 1, {0, 0, 1}, -0.2f, 0.5f);
  }

  int nodeNamed(const std::string& name) const {
    for (std::size_t i = 0; i < rig.nodes.size(); ++i)
      if (rig.nodes[i].name == name) return static_cast<int>(i);
    return -1;
  }

 private:
  void addNode(const std::string& name, int parent, const Vec3& at) {
    scene::Rig::Node node;
    node.name = name;
    node.parent = parent;
    node.translation = at;
    rig.nodes.push_back(node);
  }

  void bind() {
    scene::Rig::Skin skin;
    std::vector<Vec3> places;
    for (std::uint32_t i = 0; i < rig.nodes.size(); ++i) {
      const scene::Rig::Node& node = rig.nodes[i];
      places.push_back(node.translation + (node.parent < 0 ? Vec3(0) : places[static_cast<std::size_t>(node.parent)]));
      skin.joints.push_back(i);
      Mat4 bind(1);
      bind[3] = Vec4(-places.back(), 1);
      skin.inverseBinds.push_back(bind);
    }
    rig.skins.push_back(skin);
    rig.parts.push_back({0, 0, 0, 0, 0, 0});
  }

  void addBall(const Vec3& centre, float radius, std::uint16_t joint, int around) {
    const geometry::Mesh ball = geometry::makeSphere(around, around / 2);
    const auto first = static_cast<std::uint32_t>(mesh.positions.size());
    for (std::size_t i = 0; i < ball.positions.size(); ++i) {
      mesh.positions.push_back(centre + radius * ball.positions[i]);
      mesh.normals.push_back(ball.normals[i]);
      rig.joints.push_back({joint, 0, 0, 0});
      rig.weights.push_back(Vec4(1, 0, 0, 0));
    }
    for (const std::uint32_t i : ball.indices) mesh.indices.push_back(first + i);
    rig.positions = mesh.positions;
    rig.normals = mesh.normals;
    rig.parts[0].vertices = static_cast<std::uint32_t>(mesh.positions.size());
  }

  // A joint turns to and fro by the angle, so many times.
  void addTurn(const std::string& name, float seconds, std::uint32_t node, const Vec3& axis, float angle, float times) {
    constexpr int kKeys = 48;
    scene::Rig::Channel channel;
    channel.node = node;
    channel.path = scene::Path::Rotation;
    channel.width = 4;
    for (int k = 0; k <= kKeys; ++k) {
      const float t = static_cast<float>(k) / kKeys, half = 0.5f * angle * portableSin(2 * kPi * times * t);
      channel.times.push_back(seconds * t);
      for (int i = 0; i < 3; ++i) channel.values.push_back(axis[i] * portableSin(half));
      channel.values.push_back(portableCos(half));
    }
    rig.animations.push_back({name, seconds, {channel}});
  }
};

// The stages that make it move, as the app updates them.
struct Zoo {
  explicit Zoo(const Animal& animal = Animal()) {
    auto surface = geometry::buildSurface(animal.mesh, geometry::FurMapping::Charts);
    shape.setModel(animal.mesh, std::move(*surface), animal.rig);
    step(0);
  }

  app::BehaviourStage::Inputs inputs(float seconds) {
    app::BehaviourStage::Inputs in{.shape = shape, .settings = settings};
    in.pointer = pointer;
    in.hand = hand;
    in.landed = landed;
    in.wetness = wetness;
    in.idleTime = idleTime;
    in.reducedMotion = reducedMotion;
    in.seconds = seconds;
    return in;
  }
  bool step(float seconds) {
    behaviour.update(inputs(seconds));
    landed.clear();
    idleTime += seconds;
    return shape.update({seconds, shape.animationOf(settings.animation), reducedMotion ? 0 : settings.animationSpeed, behaviour.mix(), behaviour.revision(), behaviour.played()});
  }
  void run(float seconds) {
    for (int i = 0; i < static_cast<int>(seconds * 60 + 0.5f); ++i) step(1 / 60.0f);
  }
  bool active() { return behaviour.active(inputs(0)) || shape.active({0, shape.animationOf(settings.animation), settings.animationSpeed, behaviour.mix(), behaviour.revision(), behaviour.played()}); }
  Vec3 placeOf(int node) const { return Vec3(shape.pose()->transform(static_cast<std::size_t>(node))[3]); }
  // The way in which a joint faces, unit.
  Vec3 facing(int node) const { return glm::normalize(Vec3(shape.pose()->transform(static_cast<std::size_t>(node))[2])); }
  // A triangle of the surface whose first corner is nearest to a place.
  std::uint32_t triangleAt(const Vec3& place) const {
    const geometry::Surface& surface = shape.surface();
    std::uint32_t best = 0;
    const auto away = [&](std::uint32_t t) { return glm::distance(surface.vertices[surface.indices[std::size_t{3} * t]].position, place); };
    for (std::uint32_t t = 1; t < surface.triangleCount(); ++t)
      if (away(t) < away(best)) best = t;
    return best;
  }

  settings::Settings settings;
  app::ShapeStage shape;
  app::BehaviourStage behaviour;
  std::optional<Vec3> pointer, hand;
  std::vector<std::uint32_t> landed;
  float wetness = 0, idleTime = 0;
  bool reducedMotion = false;
};

}  // namespace fur::test
