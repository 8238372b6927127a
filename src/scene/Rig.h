// Nodes, skins, morph targets and animations, as in glTF 2.0. Plain data, validated by the importer: indices are in range,
// parents come before their children, numbers are finite.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "core/Math.h"

namespace fur::scene {

enum class Interpolation { Step, Linear, Cubic };
enum class Path { Translation, Rotation, Scale, Weights };

struct Rig {
  struct Node {
    int parent = -1;
    std::uint32_t source = 0;  // its number in the file
    std::string name{};
    Vec3 translation{0};
    Quat rotation{1, 0, 0, 0};
    Vec3 scale{1};
    Mat4 matrix{1.0f};       // replaces the three above when `fixed`
    bool fixed = false;
    std::uint32_t firstWeight = 0, weights = 0;  // of its mesh's morph targets, in restWeights
  };
  struct Skin {
    std::vector<std::uint32_t> joints;  // nodes
    std::vector<Mat4> inverseBinds;
  };
  // Vertices of one primitive, which share node, skin and morph targets.
  struct Part {
    std::uint32_t firstVertex = 0, vertices = 0;
    std::uint32_t node = 0;
    int skin = -1;
    std::uint32_t targets = 0;      // morph targets; for each and each vertex there are two `deltas`: position, normal
    std::size_t firstDelta = 0;
  };
  struct Channel {
    std::uint32_t node = 0;
    Path path = Path::Translation;
    Interpolation interpolation = Interpolation::Linear;
    std::uint32_t width = 3;        // numbers in one value
    std::vector<float> times;       // ascending, s
    std::vector<float> values;      // one value for each time; for Cubic three: in-tangent, value, out-tangent
  };
  struct Animation {
    std::string name;               // one line
    float duration = 0;             // s
    std::vector<Channel> channels;
  };

  std::vector<Node> nodes;
  std::vector<Skin> skins;
  std::vector<Part> parts;
  std::vector<Animation> animations;
  std::vector<float> restWeights;
  // For each vertex of the mesh, in its node's space; joints are those of the part's skin.
  std::vector<Vec3> positions, normals;
  std::vector<std::array<std::uint16_t, 4>> joints;  // empty without skins, as weights
  std::vector<Vec4> weights;                         // with a sum of 1
  std::vector<Vec3> deltas;
  // From scene space to model space, the unit sphere.
  Vec3 centre{0};
  float scale = 1;

  bool moves() const { return !animations.empty(); }
};

}  // namespace fur::scene
