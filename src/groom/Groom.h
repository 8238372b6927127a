// The groom of a model: how long its fur is, which way it is combed, and which fur types grow where.
//
// GroomMap: a square map over the atlas (geometry/Surface.h), 8 bits a channel:
//   r        length as a share of the settings' furLength; 0 is bald
//   g, b, a  presence of the fur types 2, 3 and 4. Type 1 has the rest, 1 - (g + b + a): presences add up to 1,
//            as Sheppard's (2004, 3.3.2), which are barycentric weights. A strand of presence e and dominance D exists
//            up to h <= max(2 - 2 (1 - e) / D, 0) (furgen::strandExists): where two types have a half each, the
//            dominant strands of both have their full height and the others are gone; where three types
//            have a third each, no strand reaches it.
// paint: a map of the same size. r, g, b: a colour (sRGB) over coat, skin and the model's own picture; a: its opacity. Texels
// of opacity 0 have the colour of those next to them, for filtering.
// mask: likewise. a: how far the place is protected from brushes and edits; the rest is unused.
// shape: likewise, added to the shape of the strands: r curl, g frizz, b locks; a the greatest of the three.
//
// comb: the bend of the fur at rest, as in dynamics::BendField: model space, radians, one for each point of the surface
// (SurfacePoints). Vertices of one position share it, so that it survives another fur mapping; each vertex uses the part
// perpendicular to its own normal. 0 is not combed: fur lies as it does by itself there (Lie.h), or stands. What is combed upright
// has a bend that nobody sees.
//
// whiskers: single hairs that stand out of the coat (Whiskers.h).
//
// bare: the materials on which no fur grows.
//
// GroomBrush.h and GroomFilters.h use + - * / and square roots only: the same bytes on every platform.
// Does not know the fur's length in model units, nor time.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "geometry/AtlasTexels.h"
#include "geometry/Surface.h"
#include "geometry/SurfaceQuery.h"
#include "groom/Whiskers.h"

namespace fur::groom {

inline constexpr int kTypes = 4;
// The largest bend of a comb; wind and gravity may bend fur further (up to dynamics::kMaxBend).
inline constexpr float kMaxComb = 1.15f;  // radians

class GroomMap {
 public:
  using Texel = std::array<std::uint8_t, 4>;
  static constexpr Texel kPlain{255, 0, 0, 0};  // full length, type 1
  static constexpr Texel kBlank{0, 0, 0, 0};    // no paint, no mask, no shape
  static constexpr int kLeastSize = 16, kMostSize = 1024, kUsualSize = 256;

  explicit GroomMap(int size = kUsualSize, const Texel& plain = kPlain);  // the size is clamped

  int size() const { return size_; }
  const std::vector<Texel>& texels() const { return texels_; }
  // In a map of lengths and types, g + b + a is limited to 255.
  void set(std::uint32_t texel, Texel value);
  // size * size texels.
  void restore(std::vector<Texel> texels);
  // Copies the texels of charts into their gutters.
  void fillGutter(const geometry::AtlasTexels& atlas, const geometry::TexelRect& changed);

  bool isPlain() const;
  // The four channels, 0..1, with bilinear filtering; and the first of them.
  Vec4 at(const Vec2& atlas) const;
  float lengthAt(const Vec2& atlas) const { return at(atlas).x; }
  // The type with the greatest presence, 1..kTypes.
  int typeAt(const Vec2& atlas) const;
  // FNV-1a over the bytes.
  std::uint64_t hash() const;
  // The rectangle that changed since the last call.
  geometry::TexelRect takeChanged();

 private:
  Texel sound(Texel texel) const;

  int size_;
  Texel plain_;
  std::vector<Texel> texels_;
  geometry::TexelRect changed_;
};

// The points of a surface: its distinct positions, in the order in which the triangles first use them, which does not depend
// on the fur mapping. Copies for overlapping fur charts belong to the point of the vertex that they copy.
struct SurfacePoints {
  explicit SurfacePoints(const geometry::Surface& surface);
  std::vector<std::uint32_t> pointOf;  // one a vertex
  std::vector<Vec3> positions, normals;  // one a point; normals are unit means
  std::size_t count() const { return positions.size(); }
  // The points at these positions; kNoPoint where there is none.
  std::vector<std::uint32_t> at(const std::vector<Vec3>& places) const;
  static constexpr std::uint32_t kNoPoint = 0xffffffffu;
};

struct Groom {
  GroomMap map;
  std::vector<Vec3> comb;  // one a point, across its normal, at most kMaxComb long
  std::vector<Whisker> whiskers{};
  std::vector<std::uint8_t> bare{};  // one a material of the model, 1: no fur grows on it; empty: the model has one
  GroomMap paint{map.size(), GroomMap::kBlank}, mask{map.size(), GroomMap::kBlank}, shape{map.size(), GroomMap::kBlank};

  bool isPlain() const;
};

// All maps of a groom.
enum MapKind : std::size_t { kLengthMap, kPaintMap, kMaskMap, kShapeMap };
inline constexpr GroomMap Groom::*kMaps[] = {&Groom::map, &Groom::paint, &Groom::mask, &Groom::shape};
// A map of another size, by nearest texels.
GroomMap resized(const GroomMap& map, int size);
// Resizes all maps so.
void resize(Groom& groom, int size);

// What an image means for a groom: readMapPicture() reads all of these, paintFromImage() the first two.
enum class ImageOf { Length, Types, Paint, Mask, Shape };

// What the functions of this module need of the model. The groom's maps have the size of `atlas`.
struct GroomSurface {
  const geometry::Surface& surface;
  const geometry::SurfaceQuery& query;
  const geometry::AtlasTexels& atlas;
  const SurfacePoints& points;
  std::span<const Vec3> lie{};  // as Groom::comb, where that is 0; empty: fur stands there
};

// Makes a comb from outside valid: bends that are not finite become 0, others perpendicular to the normals and at most kMaxComb.
std::vector<Vec3> soundComb(std::vector<Vec3> comb, const SurfacePoints& points);
Groom plainGroom(int mapSize, const SurfacePoints& points);

// The bend at a point: the comb, or where there is none how fur lies by itself. `lie`: as GroomSurface has it.
Vec3 bendAt(const Groom& groom, std::span<const Vec3> lie, std::size_t point);
// The comb that gives that bend: upright fur that would lie by itself keeps as much of a bend as nobody sees.
Vec3 combOf(const Vec3& bend, std::span<const Vec3> lie, std::size_t point);
// One a vertex, for BendField::setRest.
std::vector<Vec3> restBends(const Groom& groom, const geometry::Surface& surface, const SurfacePoints& points, std::span<const Vec3> lie = {});
// The length of each type's longest strand as a share of the coat's length; 0: the type is bald.
using TypeHeights = std::array<float, kTypes>;
inline constexpr TypeHeights kAllFull{1, 1, 1, 1};

// For each vertex, 0..1: the greatest height of the coat on the triangles round it, the same for all vertices of a point, so
// that no strand between them is cut off. A type of presence e has no strand above 2 e of its height.
std::vector<float> vertexLengths(const GroomMap& map, const geometry::Surface& surface, const SurfacePoints& points,
                                 const TypeHeights& heights = kAllFull);

// The same where no fur grows on some materials, nor on the points where they meet others. `materialOf`: one a vertex.
void keepBare(std::vector<float>& vertexLengths, const SurfacePoints& points, std::span<const std::uint8_t> materialOf, std::span<const std::uint8_t> bare);

// The triangles (three indices each) that carry a coat by these vertexLengths(): fur grows on them, or next to them where the
// coat slopes down to the skin.
std::vector<std::uint32_t> furryTriangles(const std::vector<std::uint32_t>& indices, std::span<const float> vertexLengths);
// A bit for each type that occurs: 1 for type 1 (always set), 2, 4, 8.
unsigned typesPresent(const GroomMap& map);
// A picture for people: brightness is length; types 2 to 4 are tinted red, green and blue; the paint is over it. size * size
// opaque texels.
std::vector<GroomMap::Texel> picture(const Groom& groom);
// The share of the surface's texels that are bald, and the mean length of all, both 0..1.
struct Coverage {
  float bald = 0, length = 1;
  float types[kTypes] = {1, 0, 0, 0};  // of what is not bald
};
Coverage coverage(const GroomMap& map, const geometry::AtlasTexels& atlas);

}  // namespace fur::groom
