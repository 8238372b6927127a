// The fur of a mesh in a file.
//
// A .glb has it in the extension WETFUR_fur (WETFUR_fur.schema.json in this folder): the state of the program, groom and
// wetness as maps over the mesh's atlas, the comb for each vertex, and whiskers. A .fo has a length and a type for each vertex.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "core/Math.h"
#include "groom/Groom.h"
#include "hair/Scalp.h"

namespace fur::scene {

inline constexpr int kFurVersion = 1;  // of WETFUR_fur

struct FurData {
  std::string state;  // for readState(); "" when there is none
  std::vector<groom::GroomMap::Texel> map, paint{}, mask{}, shape{};  // mapSize * mapSize each, or none
  int mapSize = 0;
  // One for each vertex of the mesh, or empty.
  std::vector<Vec3> comb;      // model space, radians; not validated yet: see groom::soundComb()
  std::vector<float> lengths;  // share of the longest, 0..1
  std::vector<int> types;      // 1..groom::kTypes
  std::vector<groom::Whisker> whiskers{};  // roots in model space; not validated yet; at most kMostWhiskers
  std::vector<Vec4> wetness{};  // wetnessSize * wetnessSize texels as wet::WetnessMask has them, or empty
  int wetnessSize = 0;
  hair::Hairstyle hair{};  // positions in model space
};

}  // namespace fur::scene
