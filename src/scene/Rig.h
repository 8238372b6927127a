// What moves a model by itself: nodes, skins, morph targets and animations, as glTF 2.0 has them. Plain data, checked by
// the importer: indices are within bounds, parents come before their children, numbers are finite.
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
    Vec3 translation{0};
    Quat rotation{1, 0, 0, 0};
    Vec3 scale{1};
    Mat4 matrix{1.0f};       // instead of the three, when `fixed`
    bool fixed = false;
    std::uint32_t firstWeight = 0, weights = 0;  // of its mesh's morph targets, in restWeights
  };
  struct Skin {
    std::vector<std::uint32_t> joints;  // nodes
    std::vector<Mat4> inverseBinds;
  };
  // Vertices of the mesh that move alike.
  struct Part {
    std::uint32_t firstVertex = 0, vertices = 0;
    std::uint32_t node = 0;
    int skin = -1;
    std::uint32_t targets = 0;      // morph targets; each has positions and normals of every vertex, in turn
    std::size_t firstDelta = 0;
  };
  struct Channel {
    std::uint32_t node = 0;
    Path path = Path::Translation;
    Interpolation interpolation = Interpolation::Linear;
    std::uint32_t width = 3;        // numbers of one value
    std::vector<float> times;       // ascending, s
    std::vector<float> values;      // one a time; three of Cubic: tangent in, value, tangent out
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
  // One a vertex of the mesh, in the space of its own node; joints of the part's skin.
  std::vector<Vec3> positions, normals;
  std::vector<std::array<std::uint16_t, 4>> joints;  // empty without skins, as weights
  std::vector<Vec4> weights;                         // they add up to 1
  std::vector<Vec3> deltas;
  // From the scene to the model, which fits the unit sphere.
  Vec3 centre{0};
  float scale = 1;

  bool moves() const { return !animations.empty(); }
};

}  // namespace fur::scene
