// The fur of a mesh in a file.
//
// A .glb has it in the extension WETFUR_fur (WETFUR_fur.schema.json in this folder): the state of the program, groom and
// wetness as maps over the mesh's atlas, the comb for each vertex, whiskers, long hair, water, and coats and colour maps of fur types that were read. A .fo has a length and a type for each vertex.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "core/Math.h"
#include "core/Result.h"
#include "groom/Groom.h"
#include "hair/Scalp.h"

namespace fur::scene {

inline constexpr int kFurVersion = 2;  // of WETFUR_fur

inline constexpr std::size_t kMostWaterBytes = 16u << 20;

struct EncodedImage {
  std::string mimeType;  // "image/png", "image/jpeg" or "image/webp"; empty: no image
  std::vector<std::uint8_t> bytes;
  int width = 0, height = 0;  // from its header
};
// The picture of those bytes. bad-file: `what` is of none of those formats; too-large: a side over kMaxImageSide (Model.h).
Result<EncodedImage> encodedImage(std::vector<std::uint8_t> bytes, const std::string& what);

// What a fur type has besides settings.
struct TypeFiles {
  std::vector<std::uint8_t> typeSet{};  // a .fts whose coat is drawn; not validated yet
  EncodedImage picture{};               // its colour map
  bool empty() const { return typeSet.empty() && picture.bytes.empty(); }
};

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
  std::vector<std::uint8_t> water{};    // all of it as app::WaterStage saves it; not validated yet; at most kMostWaterBytes
  // Of each type; the last: of the skin, which has a picture alone.
  std::array<TypeFiles, groom::kTypes + 1> coats{};
  hair::Hairstyle hair{};  // positions in model space
  std::vector<int> bare{};  // materials of the file without fur; -1: primitives without one
  bool hasBare = false;    // a document of several materials, of which `bare` tells
  bool isLying = false;    // fur lies by itself where the comb is 0; without a comb it does anyway
};

}  // namespace fur::scene
