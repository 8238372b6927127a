// Wisps: clusters of hair that grow over the scalp by chance and follow three guides each (Halen & Wester 2007, 5.4).
//
// The scalp is a map over the model's atlas (groom/Groom.h, GroomMap, blank: no scalp), 8 bits a channel:
//   r  density of wisps, 0: no scalp      g  width of wisps, least to most
//   b  length, least to full              a  how much of the rotation variance wisps take
//
// Roots are found by relaxation dart throwing (Lagae & Dutre 2005) with a table of the triangles' areas times their density.
// Halen throws into each triangle by itself, as throwing is O(n^2), and keeps few darts near its middle so that those of
// neighbours do not meet. Here darts lie in a grid, and each is thrown at the whole scalp: they keep apart across borders, so
// that no triangle shows, and a scalp of many small triangles is covered as evenly as one of few.
//
// Deterministic: the same input gives the same bytes on every platform (+ - * /, sqrt and core/PortableMath only).
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "geometry/Surface.h"
#include "groom/Groom.h"
#include "hair/Guides.h"
#include "hair/HairValues.h"

namespace fur::hair {

inline constexpr int kStripSegments = 16;  // quads of a strip, root to tip
inline constexpr float kLeastWispLength = 0.02f;

struct Wisp {
  Vec3 root{0};                             // model space, on the skin as made
  Vec3 normal{0, 1, 0};                     // of the skin there
  Vec2 atlas{0};
  std::array<std::uint32_t, 3> guides{};    // those that it follows; one may stand there more than once
  Vec3 weights{1, 0, 0};                    // their shares, 0..1, of sum 1
  Vec3 magnet{0};                           // what is added to the weights at its tip; of sum 0, so that weights stay within 0..1
  Vec3 weightsByPlace{1, 0, 0}, magnetByPlace{0};  // the same by where guides stand (WispGuides.h), whatever their shape
  Vec3 offset{0};                           // its root less the weighted roots of its guides, in their blended frame at the root
  float rotation = 0;                       // radians about the hair: 0 has the strip's width along the frame's x
  float width = 0.05f;                      // at the root, model units
  float length = 1;                         // share of its guides that it reaches up to, kLeastWispLength..1
  float random = 0;                         // its random number, 0..1
  // Bit s: segment s is split from left root side to right tip side instead of from right to left (Figure 5.4.4); left is
  // against `across`. Of the two, the one that bends the strip's rest shape less.
  std::uint32_t splits = 0;
  bool operator==(const Wisp&) const = default;
};

// What is needed of the model to plant on it.
struct ScalpSurface {
  const geometry::Surface& surface;
  const groom::GroomMap& scalp;
};

// `count` roots; none where the scalp covers nothing. Denser where the scalp is; apart from each other by about
// 0.7 sqrt(2 / sqrt(3) area / count), over the square root of the density; on both sides of a thin sheet independently. The
// first few of them are those that a smaller count gives, so that fewer can be drawn at a distance, and more only add to them.
struct Dart {
  Vec3 position{0}, normal{0, 1, 0};
  Vec2 atlas{0};
  std::uint32_t triangle = 0;
  Vec3 weights{0};  // barycentric
};
std::vector<Dart> throwDarts(const ScalpSurface& scalp, int count, std::uint64_t seed);
// The surface's area times the density.
double areaOf(const ScalpSurface& scalp);

// What all wisps of a scalp share of their shape: the values of these names, as floats.
struct WispShape {
  bool cubic = true;
  float curl = 0, curls = 3;
  float tipWidth = 0.35f, depth = 0.5f;
};
WispShape shapeOf(const HairValues& values);

// The wisps of a scalp; none without guides. `roots`: one a guide (PlantGuides.h). Of more or fewer wisps the first are the same.
std::vector<Wisp> plantWisps(const ScalpSurface& scalp, const Guides& guides, std::span<const RootFrame> roots, const HairValues& values);
// After the same guides have got another shape: weights, offsets and splits anew, all else stays. The same as planting again,
// without it. Of guides that lean apart, as at a parting, a wisp follows those that lean as the nearest does.
void followGuides(std::span<Wisp> wisps, const Guides& guides, std::span<const RootFrame> roots, const WispShape& shape);

// A point of a wisp's middle line at height t, 0 at its root to 1 at its tip: the twin of wispPoint() in hair_points.frag, as
// the functions below it are of those of their names (memberPoint(): common_hair_member.glsl). `nodes`: those of all guides as shown, guide after guide.
struct WispPoint {
  Vec3 position{0};
  Vec3 across{1, 0, 0}, along{0, 1, 0}, out{0, 0, 1};  // unit, perpendicular: the strip's width, the hair, its face (across x along)
  float wetness = 0;
};
WispPoint wispPoint(const Wisp& wisp, std::span<const GuideNode> nodes, int nodesEach, const WispShape& shape, float t);

// One guide at `node`, 0..nodes - 1, between two of its nodes. Cubic: Hermite's curve, whose tangents are the nodes' y axes as
// long as the segment, so that it needs no more nodes than the line.
struct GuidePoint {
  Vec3 position{0}, step{0};  // and what one node more adds to it, there
  Quat frame{1, 0, 0, 0};
  float wetness = 0;
};
GuidePoint guidePoint(std::span<const GuideNode> chain, float node, bool cubic);
// a + share (b - a) on the shorter way, not unit.
Quat mixFrames(const Quat& a, const Quat& b, float share);
// The frame of three; unit.
Quat blendFrames(const Quat (&frames)[3], const Vec3& weights);
// The shares of three guides where hair is wet: water draws wisps together to their nearest guide, by kWetDraws at the tip.
Vec3 drawnWeights(const Vec3& weights);
inline constexpr float kWetDraws = 0.8f;
// The helix of a curl about the middle line, in the frame's x and z and in widths: where it is, and how that changes with t. Its
// radius grows from nothing at the root.
struct Curl {
  Vec2 offset{0}, step{0};
};
Curl curlAt(const WispShape& shape, float random, float t);
// Where a member strand (MemberStrands.h) is that runs at `member` there; the strip's sides are at x = -kStripReach and kStripReach.
Vec3 memberPoint(const WispPoint& point, const Vec2& member, float width, const WispShape& shape, float t);

}  // namespace fur::hair
