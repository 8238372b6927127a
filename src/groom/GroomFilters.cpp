#include "groom/GroomFilters.h"

#include <algorithm>
#include <cmath>

#include "core/Assert.h"
#include "groom/GroomBrush.h"
#include "groom/Noise.h"

namespace fur::groom {

namespace {

std::uint8_t toByte(float share) { return static_cast<std::uint8_t>(saturate(share) * 255.0f + 0.5f); }

template <class Change>
void forAllTexels(GroomMap& map, Change change) {
  for (std::uint32_t i = 0; i < map.texels().size(); ++i) {
    GroomMap::Texel texel = map.texels()[i];
    change(texel);
    map.set(i, texel);
  }
}

// change(texel, point of the surface); then the gutters.
template <class Change>
void forSurfaceTexels(GroomMap& map, const GroomSurface& skin, Change change) {
  for (std::uint32_t t = 0; t < skin.surface.triangleCount(); ++t)
    skin.atlas.forTexelsOf(skin.surface, t, [&](std::uint32_t i, const Vec3& weights) {
      GroomMap::Texel texel = map.texels()[i];
      change(texel, geometry::SurfacePoint{t, weights, 0.0f});
      map.set(i, texel);
    });
  map.fillGutter(skin.atlas, {0, 0, map.size(), map.size()});
}

const geometry::SurfaceVertex& cornerOf(const GroomSurface& skin, const geometry::SurfacePoint& at, int k) {
  return skin.surface.vertices[skin.surface.indices[std::size_t{3} * at.triangle + static_cast<std::size_t>(k)]];
}

}  // namespace

void setLength(GroomMap& map, float share) {
  forAllTexels(map, [byte = toByte(share)](GroomMap::Texel& texel) { texel[0] = byte; });
}

void setType(GroomMap& map, int type) {
  const auto chosen = static_cast<std::size_t>(std::clamp(type, 1, kTypes)) - 1;
  forAllTexels(map, [chosen](GroomMap::Texel& texel) {
    for (std::size_t k = 1; k < kTypes; ++k) texel[k] = k == chosen ? 255 : 0;
  });
}

void invertLength(GroomMap& map) {
  forAllTexels(map, [](GroomMap::Texel& texel) { texel[0] = static_cast<std::uint8_t>(255 - texel[0]); });
}

void varyLength(Groom& groom, const GroomSurface& skin, float amount, float grain, std::uint32_t seed) {
  const float perUnit = 1.0f / std::max(grain, 1e-3f);
  forSurfaceTexels(groom.map, skin, [&](GroomMap::Texel& texel, const geometry::SurfacePoint& at) {
    const float share = 1.0f - saturate(amount) * noiseAt(positionAt(skin.surface, at) * perUnit, seed);
    texel[0] = toByte(static_cast<float>(texel[0]) / 255.0f * share);
  });
}

void combAlong(Groom& groom, const SurfacePoints& points, const Vec3& direction, float amount, std::span<const Vec3> lie) {
  for (std::size_t i = 0; i < groom.comb.size(); ++i)
    groom.comb[i] = combOf(glm::mix(bendAt(groom, lie, i), combedTo(direction, points.normals[i]), saturate(amount)), lie, i);
}

void raiseAll(Groom& groom, std::span<const Vec3> lie) {
  for (std::size_t i = 0; i < groom.comb.size(); ++i) groom.comb[i] = combOf(Vec3(0), lie, i);
}

void letLie(Groom& groom) { std::fill(groom.comb.begin(), groom.comb.end(), Vec3(0)); }

void paintAll(Groom& groom, std::uint32_t color) {
  const auto channel = [color](unsigned shift) { return static_cast<std::uint8_t>(color >> shift); };
  forAllTexels(groom.paint, [&](GroomMap::Texel& texel) { texel = {channel(16), channel(8), channel(0), 255}; });
}

void invertMask(GroomMap& mask) {
  forAllTexels(mask, [](GroomMap::Texel& texel) { texel[3] = static_cast<std::uint8_t>(255 - texel[3]); });
}

void keepProtected(Groom& groom, const Groom& before, const GroomSurface& skin) {
  if (groom.mask.isPlain()) return;
  for (const auto map : {&Groom::map, &Groom::paint, &Groom::shape})
    for (std::uint32_t i = 0; i < groom.mask.texels().size(); ++i) {
      const int kept = groom.mask.texels()[i][3];
      const GroomMap::Texel& was = (before.*map).texels()[i];
      GroomMap::Texel is = (groom.*map).texels()[i];
      for (std::size_t k = 0; k < is.size(); ++k) is[k] = static_cast<std::uint8_t>((was[k] * kept + is[k] * (255 - kept) + 127) / 255);
      (groom.*map).set(i, is);
    }
  std::vector<float> kept(groom.comb.size(), 0.0f);
  for (std::size_t i = 0; i < skin.surface.trueVertexCount; ++i)
    kept[skin.points.pointOf[i]] = groom.mask.at(skin.surface.vertices[i].atlas).w;
  for (std::size_t i = 0; i < groom.comb.size(); ++i)
    if (kept[i] >= 1) groom.comb[i] = before.comb[i];
    else if (kept[i] > 0) groom.comb[i] = combOf(glm::mix(bendAt(groom, skin.lie, i), bendAt(before, skin.lie, i), kept[i]), skin.lie, i);
}

GroomMap paintUnderMask(const Groom& groom) {
  constexpr int kRed[3] = {225, 38, 30};
  GroomMap out = groom.paint;
  forAllTexels(out, [&, i = std::size_t{0}](GroomMap::Texel& texel) mutable {
    const int over = groom.mask.texels()[i++][3] * 3 / 5, under = texel[3] * (255 - over) / 255, all = over + under;
    for (std::size_t k = 0; k < 3 && all > 0; ++k) texel[k] = static_cast<std::uint8_t>((kRed[k] * over + texel[k] * under) / all);
    texel[3] = static_cast<std::uint8_t>(all);
  });
  return out;
}

// Rec. 709 weights in 8 bits.
std::uint8_t brightness(const std::uint8_t* pixel) { return static_cast<std::uint8_t>((54 * pixel[0] + 183 * pixel[1] + 19 * pixel[2] + 128) / 256); }

void paintFromVertices(Groom& groom, const GroomSurface& skin, std::span<const float> lengths, std::span<const int> types) {
  const std::size_t count = skin.surface.trueVertexCount;
  const auto fits = [count](std::size_t given) { return given == 0 || given == count; };
  FUR_ASSERT(fits(lengths.size()) && fits(types.size()), "groom::paintFromVertices()", "one a true vertex, or none",
             lengths.size());
  if (lengths.empty() && types.empty()) return groom.map.fillGutter(skin.atlas, {0, 0, groom.map.size(), groom.map.size()});
  forSurfaceTexels(groom.map, skin, [&](GroomMap::Texel& texel, const geometry::SurfacePoint& at) {
    float length = 0, presence[kTypes] = {};
    for (int k = 0; k < 3; ++k) {
      const std::uint32_t vertex = skin.surface.indices[std::size_t{3} * at.triangle + static_cast<std::size_t>(k)];
      if (!lengths.empty()) length += at.weights[k] * lengths[vertex];
      if (!types.empty()) presence[std::clamp(types[vertex], 1, kTypes) - 1] += at.weights[k];
    }
    if (!lengths.empty()) texel[0] = toByte(length);
    for (std::size_t k = 1; !types.empty() && k < kTypes; ++k) texel[k] = toByte(presence[k]);
  });
}

void paintFromImage(ImageOf what, Groom& groom, const GroomSurface& skin, int width, int height,
                    std::span<const std::uint8_t> rgba) {
  const std::size_t bytes = std::size_t{4} * static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
  FUR_ASSERT(width > 0 && height > 0 && rgba.size() == bytes, "groom::paintFromImage()",
             "4 bytes for each of width * height texels", rgba.size());
  const auto& vertices = skin.surface.vertices;
  const bool hasUv = std::any_of(vertices.begin(), vertices.end(), [](const auto& v) { return v.uv != Vec2(0); });
  const auto texelAt = [](float c, int size) {
    return std::min(static_cast<int>((c - std::floor(c)) * static_cast<float>(size)), size - 1);
  };
  forSurfaceTexels(groom.map, skin, [&](GroomMap::Texel& texel, const geometry::SurfacePoint& at) {
    Vec2 uv(0);
    for (int k = 0; k < 3; ++k) {
      const geometry::SurfaceVertex& corner = cornerOf(skin, at, k);
      uv += at.weights[k] * (hasUv ? corner.uv : corner.atlas);
    }
    const auto x = static_cast<std::size_t>(texelAt(uv.x, width)), y = static_cast<std::size_t>(texelAt(uv.y, height));
    const std::uint8_t* pixel = &rgba[4 * (y * static_cast<std::size_t>(width) + x)];
    if (what == ImageOf::Types) std::copy_n(pixel, 3, &texel[1]);
    else texel[0] = brightness(pixel);
  });
}

}  // namespace fur::groom
