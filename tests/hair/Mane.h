// A small mane for tests: guides that stand on a ball and fall to one side, the more the nearer to the tip.
#pragma once

#include <vector>

#include "core/Math.h"
#include "core/PortableMath.h"
#include "core/Random.h"
#include "hair/Simulation.h"

namespace fur::hair {

struct Mane {
  Guides guides;
  std::vector<RootFrame> roots;
  float length = 0.6f;

  // `across` x `across` guides over the top of a ball of radius 0.5. `fall`: 0 straight out, 1 bent by 2 radians at the tip.
  explicit Mane(int across = 4, int nodes = 8, float fall = 0.7f) {
    guides.nodes = nodes;
    for (int k = 0; k < across * across; ++k) {
      const float x = (static_cast<float>(k % across) + 0.5f) / static_cast<float>(across) - 0.5f;
      const float z = (static_cast<float>(k / across) + 0.5f) / static_cast<float>(across) - 0.5f;
      RootFrame root;
      root.normal = glm::normalize(Vec3(x, 0.6f, z));
      root.tangent = glm::normalize(Vec3(1, 0, 0) - root.normal * root.normal.x);
      root.position = root.normal * 0.5f;
      roots.push_back(root);
      guides.flags.push_back(0);
      Vec3 at = root.position;
      guides.positions.push_back(at);
      for (int i = 1; i < nodes; ++i) {
        const float turn = 2.0f * fall * static_cast<float>(i - 1) / static_cast<float>(nodes - 1);
        const Vec3 way(0.5f, -0.3f, 0.2f), side = glm::normalize(way - root.normal * glm::dot(way, root.normal));
        const Vec3 along = root.normal * portableCos(turn) + side * portableSin(turn);
        at += along * (length / static_cast<float>(nodes - 1));
        guides.positions.push_back(at);
      }
    }
  }

  Simulation simulation() const {
    Simulation out;
    out.reset(guides, roots);
    return out;
  }
  std::vector<RootFrame> movedRoots(const Mat4& by) const {
    std::vector<RootFrame> out;
    for (const RootFrame& r : roots) out.push_back({Vec3(by * Vec4(r.position, 1)), Mat3(by) * r.normal, Mat3(by) * r.tangent});
    return out;
  }
};

// The mane while it is moved about. What acts on it may be set before each frame.
struct Shaken {
  Mane mane;
  Simulation simulation = mane.simulation();
  std::vector<RootFrame> roots = mane.roots;
  MotionValues values;
  dynamics::Wind wind;
  std::vector<Collider> colliders;
  std::vector<float> wetness;
  Vec3 up{0, 1, 0};

  explicit Shaken(const Mane& of = Mane()) : mane(of) {}
  Surroundings around() const { return {roots, up, &wind, wetness, colliders}; }
  bool advance(float seconds) { return simulation.advance(seconds, values, around()); }
  void run(float seconds, float frame = 1 / 60.0f) {
    for (int i = 0; i < static_cast<int>(seconds / frame + 0.5f); ++i) advance(frame);
  }
  void place(const Mat4& where) {
    roots = mane.movedRoots(where);
    up = Mat3(where) * Vec3(0, 1, 0);
  }
  std::span<const GuideNode> nodes() const { return simulation.nodes(); }
};

inline const Mat4 kHere(1.0f);

// The largest error of a segment's length, as a share of it.
inline float stretch(const Mane& mane, std::span<const GuideNode> nodes) {
  float worst = 0;
  for (std::size_t k = 0; k < nodes.size(); ++k) {
    if (k % static_cast<std::size_t>(mane.guides.nodes) == 0) continue;
    const float rest = glm::length(mane.guides.positions[k] - mane.guides.positions[k - 1]);
    const float length = glm::length(nodes[k].position - nodes[k - 1].position);
    if (!(std::abs(length / rest - 1) <= worst)) worst = std::abs(length / rest - 1);
  }
  return worst;
}

// The farthest that a node is from where the rest shape has it, with roots moved so.
inline float farFromRest(const Mane& mane, std::span<const GuideNode> nodes, const Mat4& where = kHere) {
  float worst = 0;
  for (std::size_t k = 0; k < nodes.size(); ++k) {
    const float apart = glm::length(nodes[k].position - Vec3(where * Vec4(mane.guides.positions[k], 1)));
    if (!(apart <= worst)) worst = apart;
  }
  return worst;
}

inline float farApart(std::span<const GuideNode> a, std::span<const GuideNode> b) {
  float worst = 0;
  for (std::size_t k = 0; k < a.size(); ++k) {
    const float apart = glm::length(a[k].position - b[k].position);
    if (!(apart <= worst)) worst = apart;
  }
  return worst;
}

}  // namespace fur::hair
