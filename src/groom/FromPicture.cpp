#include "groom/FromPicture.h"

#include <algorithm>
#include <cmath>

#include "groom/GroomFilters.h"

namespace fur::groom {

namespace {

using Corners = const geometry::SurfaceVertex* [3];

void cornersOf(const geometry::Surface& surface, std::uint32_t triangle, Corners& corners) {
  for (std::size_t k = 0; k < 3; ++k) corners[k] = &surface.vertices[surface.indices[std::size_t{3} * triangle + k]];
}

// The model's own texture coordinates, or the atlas where it has none.
Vec2 geometry::SurfaceVertex::*coordinatesOf(const geometry::Surface& surface) {
  const bool hasUv = std::any_of(surface.vertices.begin(), surface.vertices.end(), [](const auto& v) { return v.uv != Vec2(0); });
  return hasUv ? &geometry::SurfaceVertex::uv : &geometry::SurfaceVertex::atlas;
}

// change(texel, the picture's pixel there); then the gutters.
template <class Change>
void forPicturedTexels(GroomMap& map, const GroomSurface& skin, const Picture& picture, Change change) {
  const auto coordinates = coordinatesOf(skin.surface);
  for (std::uint32_t t = 0; t < skin.surface.triangleCount(); ++t) {
    Corners corners;
    cornersOf(skin.surface, t, corners);
    skin.atlas.forTexelsOf(skin.surface, t, [&](std::uint32_t texel, const Vec3& weights) {
      const Vec2 uv = weights.x * (corners[0]->*coordinates) + weights.y * (corners[1]->*coordinates) + weights.z * (corners[2]->*coordinates);
      GroomMap::Texel value = map.texels()[texel];
      change(texel, value, picture.at(uv));
      map.set(texel, value);
    });
  }
  map.fillGutter(skin.atlas, {0, 0, map.size(), map.size()});
}

// The directions of u and v on a triangle, unit; none where it has no area there.
struct UvAxes {
  Vec3 u{0}, v{0};
};
UvAxes uvAxes(const Corners& corners, Vec2 geometry::SurfaceVertex::*coordinates) {
  const Vec3 ab = corners[1]->position - corners[0]->position, ac = corners[2]->position - corners[0]->position;
  const Vec2 uvB = corners[1]->*coordinates - corners[0]->*coordinates, uvC = corners[2]->*coordinates - corners[0]->*coordinates;
  const float area = uvB.x * uvC.y - uvC.x * uvB.y, side = area < 0 ? -1.0f : 1.0f;
  return {normalizeOr((ab * uvC.y - ac * uvB.y) * side, Vec3(0)), normalizeOr((ac * uvB.x - ab * uvC.x) * side, Vec3(0))};
}

}  // namespace

const std::uint8_t* Picture::at(const Vec2& uv) const {
  const auto texelAt = [](float c, int size) {
    const float part = c - std::floor(c);  // not of what is not finite
    return static_cast<std::size_t>(std::min(part >= 0 ? static_cast<int>(part * static_cast<float>(size)) : 0, size - 1));
  };
  return &rgba[4 * (texelAt(uv.y, height) * static_cast<std::size_t>(width) + texelAt(uv.x, width))];
}

void paintColors(Groom& groom, const GroomSurface& skin, const Picture& picture) {
  forPicturedTexels(groom.paint, skin, picture, [](std::uint32_t, GroomMap::Texel& texel, const std::uint8_t* pixel) {
    const int over = pixel[3];
    const int under = texel[3] * (255 - over) / 255, all = over + under;
    for (std::size_t k = 0; k < 3 && all > 0; ++k) texel[k] = static_cast<std::uint8_t>((pixel[k] * over + texel[k] * under) / all);
    texel[3] = static_cast<std::uint8_t>(all);
  });
}

bool isOpaque(const Picture& picture) {
  for (std::size_t i = 3; i < picture.rgba.size(); i += 4)
    if (picture.rgba[i] < 255) return false;
  return true;
}

void lengthFromAlpha(Groom& groom, const GroomSurface& skin, const Picture& picture) {
  forPicturedTexels(groom.map, skin, picture, [](std::uint32_t, GroomMap::Texel& texel, const std::uint8_t* pixel) { texel[0] = pixel[3]; });
}

void thinByPicture(Groom& groom, const GroomSurface& skin, const Picture& picture, int bald) {
  forPicturedTexels(groom.map, skin, picture, [bald](std::uint32_t, GroomMap::Texel& texel, const std::uint8_t* pixel) {
    const int dense = brightness(pixel);
    int others = 0;
    for (std::size_t k = 1; k < kTypes; ++k)
      if (static_cast<int>(k) != bald - 1) others += texel[k] = static_cast<std::uint8_t>(texel[k] * dense / 255);
    texel[static_cast<std::size_t>(bald) - 1] = static_cast<std::uint8_t>(std::min(255 - dense, 255 - others));
  });
}

void combFromPicture(Groom& groom, const GroomSurface& skin, const Picture& picture) {
  const auto coordinates = coordinatesOf(skin.surface);
  bool blue = false;
  for (std::size_t i = 2; i < picture.rgba.size(); i += 4) blue |= picture.rgba[i] != 0;
  std::vector<Vec3> sums(skin.points.count(), Vec3(0));
  std::vector<float> counts(sums.size(), 0);
  for (std::uint32_t t = 0; t < skin.surface.triangleCount(); ++t) {
    Corners corners;
    cornersOf(skin.surface, t, corners);
    const UvAxes axes = uvAxes(corners, coordinates);
    // A little inside of the triangle: its own chart of the picture.
    const Vec2 middle = (corners[0]->*coordinates + corners[1]->*coordinates + corners[2]->*coordinates) / 3.0f;
    for (std::size_t k = 0; k < 3; ++k) {
      const std::uint8_t* pixel = picture.at(glm::mix(corners[k]->*coordinates, middle, 0.1f));
      // 128 is 0 as well as a byte can be.
      const Vec2 way = glm::clamp(Vec2(pixel[0] - 128, pixel[1] - 128) / 127.0f, -1.0f, 1.0f);
      const float length = glm::length(way), size = blue ? static_cast<float>(pixel[2]) / 255 : std::min(length, 1.0f);
      const std::uint32_t point = skin.points.pointOf[skin.surface.indices[std::size_t{3} * t + k]];
      if (length > 1e-3f) sums[point] += (axes.u * way.x + axes.v * way.y) * (size / length);
      counts[point] += 1;
    }
  }
  for (std::size_t i = 0; i < sums.size(); ++i)
    if (counts[i] > 0) groom.comb[i] = combOf(sums[i] * (kMaxComb / counts[i]), skin.lie, i);
  groom.comb = soundComb(std::move(groom.comb), skin.points);
}

}  // namespace fur::groom
