#include "groom/MapPictures.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/Assert.h"
#include "geometry/AtlasOutlines.h"
#include "groom/GroomFilters.h"

namespace fur::groom {

namespace {

constexpr const char* kReadBack[] = {"length", "types", "paint", "mask", "shape"};  // in the order of ImageOf
constexpr std::string_view kMark = "-map-";
// The outlines' half width in texels, and their colour.
constexpr float kHalfLine = 1.0f;
constexpr std::uint8_t kLine[] = {255, 96, 0};

std::uint8_t channelOf(float share) { return static_cast<std::uint8_t>(saturate(share) * 255.0f + 0.5f); }

// `count` channels of the map from `first` on.
MapPicture channelsOf(const char* name, const GroomMap& map, std::size_t first, std::size_t count) {
  MapPicture out{name, map.size(), static_cast<int>(count), {}};
  out.pixels.reserve(map.texels().size() * count);
  for (const GroomMap::Texel& texel : map.texels()) out.pixels.insert(out.pixels.end(), &texel[first], &texel[first] + count);
  return out;
}

// Unit vectors along the triangle that point the way in which u and v grow.
std::pair<Vec3, Vec3> atlasAxes(const geometry::SurfaceVertex& a, const geometry::SurfaceVertex& b, const geometry::SurfaceVertex& c) {
  const Vec3 ab = b.position - a.position, ac = c.position - a.position, normal = glm::cross(ab, ac);
  const Vec2 uvB = b.atlas - a.atlas, uvC = c.atlas - a.atlas;
  const float area = uvB.x * uvC.y - uvC.x * uvB.y;
  // Of the two tangents only the directions count, so that nothing is divided by the area.
  const Vec3 along = (ab * uvC.y - ac * uvB.y) * (area < 0 ? -1.0f : 1.0f);
  const Vec3 u = normalizeOr(along, Vec3(0)), v = glm::cross(normalizeOr(normal, Vec3(0)), u);
  return {u, area < 0 ? -v : v};
}

MapPicture combPicture(const Groom& groom, const GroomSurface& skin) {
  const int size = groom.map.size();
  const auto texels = static_cast<std::size_t>(size) * static_cast<std::size_t>(size);
  MapPicture out{"comb", size, 3, {}};
  out.pixels.reserve(3 * texels);
  for (std::size_t i = 0; i < texels; ++i) out.pixels.insert(out.pixels.end(), {128, 128, 0});
  const std::vector<Vec3> bends = restBends(groom, skin.surface, skin.points, skin.lie);
  for (std::uint32_t t = 0; t < skin.surface.triangleCount(); ++t) {
    const std::uint32_t* corners = &skin.surface.indices[std::size_t{3} * t];
    const auto vertex = [&](std::size_t k) -> const geometry::SurfaceVertex& { return skin.surface.vertices[corners[k]]; };
    const auto [u, v] = atlasAxes(vertex(0), vertex(1), vertex(2));
    skin.atlas.forTexelsOf(skin.surface, t, [&, u = u, v = v](std::uint32_t texel, const Vec3& weights) {
      Vec3 bend(0);
      for (int k = 0; k < 3; ++k) bend += weights[k] * bends[corners[k]];
      const float much = glm::length(bend);
      if (much <= 0.0f) return;
      const Vec3 way = normalizeOr(Vec3(glm::dot(bend, u), glm::dot(bend, v), 0), Vec3(0));
      std::uint8_t* pixel = &out.pixels[std::size_t{3} * texel];
      pixel[0] = channelOf(0.5f + 0.5f * way.x);
      pixel[1] = channelOf(0.5f + 0.5f * way.y);
      pixel[2] = channelOf(much / kMaxComb);
    });
  }
  for (const auto& [texel, source] : skin.atlas.gutter()) std::copy_n(&out.pixels[std::size_t{3} * source], 3, &out.pixels[std::size_t{3} * texel]);
  return out;
}

float distanceTo(const Vec2& at, const Vec2& a, const Vec2& b) {
  const Vec2 way = b - a;
  const float along = saturate(glm::dot(at - a, way) / std::max(glm::dot(way, way), 1e-12f));
  return glm::length(at - a - way * along);
}

}  // namespace

std::vector<MapPicture> mapPictures(const Groom& groom, const GroomSurface& skin) {
  FUR_ASSERT(skin.atlas.size() == groom.map.size(), "groom::mapPictures()", "an atlas of the map's size", skin.atlas.size());
  return {channelsOf("length", groom.map, 0, 1), channelsOf("types", groom.map, 1, 3), channelsOf("paint", groom.paint, 0, 4),
          channelsOf("mask", groom.mask, 3, 1), channelsOf("shape", groom.shape, 0, 3), combPicture(groom, skin)};
}

MapPicture layoutPicture(const geometry::Surface& surface, int size) {
  const auto side = static_cast<std::size_t>(size);
  MapPicture out{"layout", size, 4, std::vector<std::uint8_t>(4 * side * side)};
  for (std::size_t i = 0; i < side * side; ++i) std::copy_n(kLine, 3, &out.pixels[4 * i]);
  constexpr float kReach = kHalfLine + 1;
  const auto bound = [&](float at) { return static_cast<int>(glm::clamp(at, 0.0f, static_cast<float>(size))); };
  for (const Vec4& line : geometry::atlasOutlines(surface)) {
    const Vec2 a = Vec2(line.x, line.y) * static_cast<float>(size) - 0.5f, b = Vec2(line.z, line.w) * static_cast<float>(size) - 0.5f;
    const Vec2 low = glm::min(a, b) - kReach, high = glm::max(a, b) + kReach + 1.0f;
    for (int y = bound(low.y); y < bound(high.y); ++y)
      for (int x = bound(low.x); x < bound(high.x); ++x) {
        std::uint8_t& alpha = out.pixels[4 * (static_cast<std::size_t>(y) * side + static_cast<std::size_t>(x)) + 3];
        alpha = std::max(alpha, channelOf(kHalfLine + 0.5f - distanceTo(Vec2(x, y), a, b)));
      }
  }
  return out;
}

std::string mapFileName(std::string_view model, const char* picture) { return std::string(model).append(kMark).append(picture) + ".png"; }

std::optional<ImageOf> mapOfFile(std::string_view fileName) {
  const std::size_t mark = fileName.rfind(kMark);
  if (mark == std::string_view::npos) return std::nullopt;
  const std::string_view rest = fileName.substr(mark + kMark.size());
  for (std::size_t i = 0; i < std::size(kReadBack); ++i) {
    const std::string_view name = kReadBack[i];
    if (!rest.starts_with(name)) continue;
    const std::string_view end = rest.substr(name.size());
    if (end == ".png" || (end.starts_with(" (") && end.ends_with(").png"))) return static_cast<ImageOf>(i);
  }
  return std::nullopt;
}

void readMapPicture(ImageOf what, Groom& groom, int width, int height, std::span<const std::uint8_t> rgba) {
  const std::size_t bytes = std::size_t{4} * static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
  FUR_ASSERT(width > 0 && height > 0 && rgba.size() == bytes, "groom::readMapPicture()",
             "4 bytes for each of width * height texels", rgba.size());
  GroomMap& map = what == ImageOf::Paint ? groom.paint : what == ImageOf::Mask ? groom.mask : what == ImageOf::Shape ? groom.shape : groom.map;
  const auto size = static_cast<std::size_t>(map.size());
  const auto nearest = [&](std::size_t texel, int side) { return (2 * texel + 1) * static_cast<std::size_t>(side) / (2 * size); };
  for (std::size_t i = 0; i < size * size; ++i) {
    const std::uint8_t* pixel = &rgba[4 * (nearest(i / size, height) * static_cast<std::size_t>(width) + nearest(i % size, width))];
    GroomMap::Texel texel = map.texels()[i];
    switch (what) {
      case ImageOf::Length: texel[0] = brightness(pixel); break;
      case ImageOf::Types: std::copy_n(pixel, 3, &texel[1]); break;
      case ImageOf::Paint: std::copy_n(pixel, 4, &texel[0]); break;
      case ImageOf::Mask: texel[3] = brightness(pixel); break;
      case ImageOf::Shape:
        std::copy_n(pixel, 3, &texel[0]);
        texel[3] = std::max(std::max(texel[0], texel[1]), texel[2]);
        break;
    }
    map.set(static_cast<std::uint32_t>(i), texel);
  }
}

}  // namespace fur::groom
