// Sheppard's model format .fo (2004, 4.3.1), exactly as it is in the file: text, one statement a line,
//
//   v x y z nx ny nz length fur_type        position, direction of the hair, its length in the units of x, y and z, its type
//   t colour_u colour_v fur_u fur_v         coordinates of the colour map and of the repeating fur tile
//   p v1/t1 v2/t2 v3/t3                     a triangle, by numbers counted from 1
//
// in this order. Not defined by the paper: colour_v counts from the bottom of the image, as in .obj, on which .fo is based;
// a fur tile spans 1 of fur_u and fur_v, its first row at fur_v 0, so that they are Mesh::furUv as they are.
//
// Hair grows straight along the normal (3.2.1): where fur is combed it is no normal of the surface. Types count from 1, and 4 is
// bald (5.1).
//
// importFo() reads it as a scene::Model, with furUv, Model::furLength, and lengths, types and comb as FurData has them. Where normals
// lean by more than 12 degrees off the surface somewhere all are combed fur, else the normals of the surface as they are. A file
// with a type that is none of 1 to 4 is none of FurGLe's: its lengths are shares of the longest, and no type is bald (this program
// once wrote types from 0).
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "core/Math.h"
#include "core/Result.h"
#include "geometry/Surface.h"

namespace fur::scene {

struct FoModel {
  struct Corner {
    std::uint32_t vertex, texcoord;  // from 0, unlike in the file
    bool operator==(const Corner&) const = default;
  };
  struct Texcoord {
    Vec2 colour, fur;
    bool operator==(const Texcoord&) const = default;
  };
  // For each vertex.
  std::vector<Vec3> positions, normals;
  std::vector<float> length;  // 0 is bald
  std::vector<int> furType;

  std::vector<Texcoord> texcoords;
  std::vector<std::array<Corner, 3>> faces;

  bool operator==(const FoModel&) const = default;
};

// Blank lines and comments (#) are allowed, too. Errors name file, line and reason. Limits: kMaxVertices vertices and as many
// texture coordinates, kMaxTriangles faces.
Result<FoModel> readFo(std::span<const std::uint8_t> bytes, const std::string& name);

// All numbers must be finite. readFo() of the result gives the same floats, bit for bit.
std::vector<std::uint8_t> writeFo(const FoModel& fo);

inline constexpr int kFoBald = 4;

// What grows at each vertex of a surface, to be saved; `types`: as the file has them. `bends`: the comb, radians; none where it is
// empty.
struct FoFur {
  std::vector<float> lengths;
  std::vector<int> types;
  std::vector<Vec3> bends{};
};

// A surface for saving; `repeat`: fur tiles along a model unit. Vertices with the same position, normal and direction of hair are
// merged.
FoModel foFromSurface(const geometry::Surface& surface, float repeat, const FoFur& fur);

}  // namespace fur::scene
