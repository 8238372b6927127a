// What a file says about the fur of its mesh.
//
// A .glb does in the extension WETFUR_fur (WETFUR_fur.schema.json in this folder): the state of the program, and
// the groom and the wetness
// as maps in the mesh's atlas, a comb at its vertices and whiskers where they stand. A .fo has a length and a type at every vertex.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "core/Math.h"
#include "groom/Groom.h"

namespace fur::scene {

inline constexpr int kFurVersion = 1;  // of WETFUR_fur

struct FurData {
  std::string state;  // for readState(); "" when there is none
  std::vector<groom::GroomMap::Texel> map, paint{}, mask{}, shape{};  // mapSize * mapSize each, or none
  int mapSize = 0;
  // One a vertex of the mesh, or none.
  std::vector<Vec3> comb;      // model space, radians, as it was read: neither bounded nor across any normal
  std::vector<float> lengths;  // share of the longest, 0..1
  std::vector<int> types;      // 1..groom::kTypes
  std::vector<groom::Whisker> whiskers{};  // as they were read, their roots in model space; at most kMostWhiskers
  std::vector<Vec4> wetness{};  // wetnessSize * wetnessSize texels as wet::WetnessMask has them, or none
  int wetnessSize = 0;
};

}  // namespace fur::scene
