// How the fur of a model is dressed: how long it is, which way it is combed, and which kinds of it grow where.
//
// GroomMap: a square map over the atlas (geometry/Surface.h), 8 bits a channel:
//   r        length as a share of the settings' furLength; 0 is bald
//   g, b, a  presence of the fur types 2, 3 and 4. Type 1 has the rest, 1 - (g + b + a): presences add up to 1
//            as Sheppard's do (2004, 3.3.2), which are the weights of a triangle's corners. A strand of presence
//            e and dominance D exists up to h <= max(2 - 2 (1 - e) / D, 0) (furgen::strandExists): where two
//            types share the skin evenly, the dominant strands of both stand at full height and the others are
//            gone; of three types none reaches it. With 1 - max in place of 1 - sum three would crowd there.
// paint: a map of the same size over coat, skin and the model's own picture: r, g, b a colour (sRGB), a how much of it
// there is; where there is none, the colour of what is next to it. mask: likewise, a: how far the place is protected from
// brushes and edits; the rest is unused.
// shape: likewise, what brushes add to the shape of the coat's strands: r curl, g frizz, b how tightly they gather into locks;
// a the greatest of these.
//
// comb: where the fur leans at rest, as dynamics::BendField has bends: model space, radians, one a point of the
// surface (SurfacePoints). Vertices that lie together share it, whichever charts they were split for, so that
// another fur mapping keeps the groom; each shows the part across its own normal.
//
// whiskers: hairs that stand out of all that (Whiskers.h).
//
// GroomBrush.h and GroomFilters.h change a groom by + - * / and square roots alone: the same bytes everywhere.
// Knows no settings' length, no time and no picture.
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
// The most that a comb lays fur down; wind and gravity may take it further (BendField's kMaxBend is 1.35).
inline constexpr float kMaxComb = 1.15f;  // radians

class GroomMap {
 public:
  using Texel = std::array<std::uint8_t, 4>;
  static constexpr Texel kPlain{255, 0, 0, 0};  // full length, type 1
  static constexpr Texel kBlank{0, 0, 0, 0};    // of paint and mask: none
  static constexpr int kLeastSize = 16, kMostSize = 1024, kUsualSize = 256;

  explicit GroomMap(int size = kUsualSize, const Texel& plain = kPlain);  // clamped to the two above

  int size() const { return size_; }
  const std::vector<Texel>& texels() const { return texels_; }
  // Of lengths and types g + b + a over 255 is brought down to it.
  void set(std::uint32_t texel, Texel value);
  // size * size of them, or an assertion.
  void restore(std::vector<Texel> texels);
  // Copies the texels of charts into their gutters.
  void fillGutter(const geometry::AtlasTexels& atlas, const geometry::TexelRect& changed);

  bool isPlain() const;
  // Its four channels, 0..1, filtered as a shader does; and the first of them.
  Vec4 at(const Vec2& atlas) const;
  float lengthAt(const Vec2& atlas) const { return at(atlas).x; }
  // 1..kTypes: the one with the greatest presence.
  int typeAt(const Vec2& atlas) const;
  // FNV-1a over the bytes.
  std::uint64_t hash() const;
  // What changed since the last call: what the renderer uploads.
  geometry::TexelRect takeChanged();

 private:
  Texel sound(Texel texel) const;

  int size_;
  Texel plain_;
  std::vector<Texel> texels_;
  geometry::TexelRect changed_;
};

// The points of a surface: positions that differ, numbered as the triangles first meet them, which no
// fur mapping changes. Copies for overlapping fur charts belong to the points of what they copy.
struct SurfacePoints {
  explicit SurfacePoints(const geometry::Surface& surface);
  std::vector<std::uint32_t> pointOf;  // one a vertex
  std::vector<Vec3> positions, normals;  // one a point; normals are unit means
  std::size_t count() const { return positions.size(); }
  // The point at each of these, kNoPoint where there is none.
  std::vector<std::uint32_t> at(const std::vector<Vec3>& places) const;
  static constexpr std::uint32_t kNoPoint = 0xffffffffu;
};

struct Groom {
  GroomMap map;
  std::vector<Vec3> comb;  // one a point, across its normal, at most kMaxComb long
  std::vector<Whisker> whiskers{};
  GroomMap paint{map.size(), GroomMap::kBlank}, mask{map.size(), GroomMap::kBlank}, shape{map.size(), GroomMap::kBlank};

  bool isPlain() const;
};

// What a groom's maps have in common.
inline constexpr GroomMap Groom::*kMaps[] = {&Groom::map, &Groom::paint, &Groom::mask, &Groom::shape};
// Another size for all of them: nearest texels.
void resize(Groom& groom, int size);

// What an image that is painted onto the maps means, see paintFromImage() and readMapPicture(): the latter knows them all.
enum class ImageOf { Length, Types, Paint, Mask, Shape };

// What the functions of this module know of the model. The map has the size of `atlas`.
struct GroomSurface {
  const geometry::Surface& surface;
  const geometry::SurfaceQuery& query;
  const geometry::AtlasTexels& atlas;
  const SurfacePoints& points;
};

// A comb from anywhere: what is not finite becomes 0, the rest is brought across the normals and within kMaxComb.
std::vector<Vec3> soundComb(std::vector<Vec3> comb, const SurfacePoints& points);
Groom plainGroom(int mapSize, const SurfacePoints& points);

// One a vertex, for BendField::setRest.
std::vector<Vec3> restBends(const Groom& groom, const geometry::Surface& surface, const SurfacePoints& points);
// The longest strand of each type as a share of the coat's length; 0: the type is bald.
using TypeHeights = std::array<float, kTypes>;
inline constexpr TypeHeights kAllFull{1, 1, 1, 1};

// One a vertex, 0..1: how high the coat stands at most on the triangles round it by the map, the same for all vertices of a
// point: room for every strand between them. No strand of a type whose presence is e reaches beyond 2 e of its height.
std::vector<float> vertexLengths(const GroomMap& map, const geometry::Surface& surface, const SurfacePoints& points,
                                 const TypeHeights& heights = kAllFull);

// Those of the triangles (three indices each) over which a coat of these vertexLengths() stands: fur grows on them or, where
// it slopes down to the skin, beside them. What is left out costs nothing.
std::vector<std::uint32_t> furryTriangles(const std::vector<std::uint32_t>& indices, std::span<const float> vertexLengths);
// A bit for each type that is present anywhere: 1 for type 1 (always), 2, 4, 8.
unsigned typesPresent(const GroomMap& map);
// For people: brightness is length, types 2 to 4 are tinted red, green and blue, under the paint. size * size texels, opaque.
std::vector<GroomMap::Texel> picture(const Groom& groom);
// Share of the surface's texels that are bald, and their mean length, both 0..1.
struct Coverage {
  float bald = 0, length = 1;
  float types[kTypes] = {1, 0, 0, 0};  // of what is not bald
};
Coverage coverage(const GroomMap& map, const geometry::AtlasTexels& atlas);

}  // namespace fur::groom
