// Cem Yuksel's .hair files (www.cemyuksel.com/research/hairmodels): strands as rows of points, little-endian,
//
//   "HAIR"; number of strands, of points, flags, default segments: uint32; default thickness, transparency: float32;
//   default colour: 3 float32; 88 bytes of text                                                          (128 bytes)
//   segments of each strand    uint16    flag 1, else all have the default
//   points, x y z              float32   flag 2; strand after strand from root to tip, each one more than its segments
//   thickness of each point    float32   flag 4
//   transparency of each point float32   flag 8
//   colour of each point       3 float32 flag 16
//
// The format says nothing of units, of which way is up, and of what thickness and colours are in. The author's models have z up.
// Here thickness is a diameter in units of the points, and colours are sRGB, 0..1.
//
// It is no model: its strands become guides of the model that is open.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "core/Math.h"
#include "core/Result.h"
#include "hair/Guides.h"
#include "hair/PlantGuides.h"

namespace fur::scene {

inline constexpr std::size_t kHairHeaderBytes = 128, kHairInfoBytes = 88;
inline constexpr std::size_t kMaxStrands = 1'000'000;   // of a file
inline constexpr std::size_t kMaxHairPoints = 8'000'000;
inline constexpr std::uint32_t kMaxSegments = 65535;    // of a strand

// One vector may be empty: then the default is for all. Segments are always there.
struct HairFile {
  std::vector<std::uint16_t> segments;  // one a strand
  std::vector<Vec3> points;
  std::vector<float> thickness, transparency;  // one a point
  std::vector<Vec3> colors;                    // one a point
  float defaultThickness = 1, defaultTransparency = 0;
  Vec3 defaultColor{1};
  std::string info;  // up to its first zero byte
  bool operator==(const HairFile&) const = default;
};

// Errors name the file: bad-file for bytes that do not add up, or that are no numbers, too-large for more than the limits above
// and kMaxFileBytes, unsupported-version for flags that are not known. Takes memory by the file's size alone. Bytes after the
// last array are left out.
Result<HairFile> readHair(std::span<const std::uint8_t> bytes, const std::string& name);
// Whether and how its numbers are read again; `hair` is as readHair() gives it. A long info is cut.
std::vector<std::uint8_t> writeHair(const HairFile& hair);

enum class HairUp { Y, Z };  // of the file's axes; z: x stays and z becomes y
// What the strands of a file are to be as guides.
struct HairAsGuides {
  HairUp up = HairUp::Z;
  int nodes = 8;
  int count = 128;  // at most; more strands than that are represented by so many of them
};
// The strands as they lie in the file, but for `up`: in model units if the file has them. Of more strands than `as.count` one
// stands for each group of those whose roots and shapes are alike (k-means, of which each gives the strand nearest to its middle).
// Errors: bad-file where no strand has a length, too-large for a count that is not 1..kMostGuides.
Result<hair::Guides> guidesOf(const HairFile& hair, const HairAsGuides& as, const std::string& name);
// The same, each moved onto the skin; before, all moved and scaled so that their roots lie about the scalp as they did about their own,
// unless the scalp is the whole model and they are near its skin as they are.
// Bad-file also where the scalp covers nothing.
Result<hair::Guides> guidesOf(const HairFile& hair, const HairAsGuides& as, const std::string& name, const hair::ScalpSurface& scalp,
                              const geometry::SurfaceQuery& query);

// Guides as strands; `width`: of a strand.
HairFile hairOfGuides(const hair::Guides& guides, float width, HairUp up = HairUp::Z);
// All strands of these wisps, where the guides' nodes are now: `values.strands` of each, kStripSegments segments and more where
// they curl. Too-large for more than the limits above.
Result<HairFile> hairOfWisps(std::span<const hair::Wisp> wisps, std::span<const hair::GuideNode> nodes, int nodesEach,
                             const hair::HairValues& values, HairUp up = HairUp::Z);

}  // namespace fur::scene
