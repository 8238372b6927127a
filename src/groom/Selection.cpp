#include "groom/Selection.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <unordered_map>

#include "geometry/Adjacency.h"

namespace fur::groom {

namespace {

// Calls selected(texel, triangle), 0..255, for every texel of the surface; the mask protects the rest.
template <class Selected>
void select(Groom& groom, const GroomSurface& skin, Selected selected) {
  const auto& triangleOf = skin.atlas.triangleOf();
  for (std::uint32_t i = 0; i < triangleOf.size(); ++i)
    if (triangleOf[i] != geometry::kNoTriangle)
      groom.mask.set(i, {0, 0, 0, static_cast<std::uint8_t>(255 - selected(i, triangleOf[i]))});
  groom.mask.fillGutter(skin.atlas, {0, 0, groom.mask.size(), groom.mask.size()});
}

int allOrNothing(bool selected) { return selected ? 255 : 0; }

// --- the mask in space ---

struct Place {
  Vec3 position, normal;
  std::uint32_t texel;
};

class Neighbourhood {
 public:
  Neighbourhood(const Groom& groom, const GroomSurface& skin, float radius) : values_(groom.mask.texels()) {
    double area = 0;
    for (std::uint32_t t = 0; t < skin.surface.triangleCount(); ++t) {
      Vec3 p[3];
      for (std::size_t k = 0; k < 3; ++k) p[k] = skin.surface.vertices[skin.surface.indices[std::size_t{3} * t + k]].position;
      area += 0.5 * static_cast<double>(glm::length(glm::cross(p[1] - p[0], p[2] - p[0])));
      skin.atlas.forTexelsOf(skin.surface, t, [&](std::uint32_t texel, const Vec3& weights) {
        const geometry::SurfacePoint at{t, weights, 0};
        places_.push_back({positionAt(skin.surface, at), normalAt(skin.surface, at), texel});
      });
    }
    const float texel = std::sqrt(static_cast<float>(area) / static_cast<float>(std::max<std::size_t>(places_.size(), 1)));
    radius_ = std::max(std::isfinite(radius) ? radius : 0.0f, std::max(2 * texel, 1e-4f));
    for (std::uint32_t i = 0; i < places_.size(); ++i) {
      Cell& cell = cells_[keyOf(cellOf(places_[i].position))];
      const std::uint8_t value = values_[places_[i].texel][3];
      cell.least = std::min(cell.least, value);
      cell.most = std::max(cell.most, value);
      cell.places.push_back(i);
    }
  }

  // change(own value, visit) gives each texel's new value; visit(see) calls see(value, share) for all within the radius, itself
  // too: share falls from 1 to 0 there. Where all round is alike nothing changes.
  template <class Change>
  void apply(Groom& groom, const GroomSurface& skin, Change change) const {
    for (const auto& [key, cell] : cells_) {
      const IVec3 middle = cellOf(places_[cell.places.front()].position);
      const Cell* round[27];
      int count = 0;
      std::uint8_t least = 255, most = 0;
      for (int i = 0; i < 27; ++i) {
        const auto found = cells_.find(keyOf(middle + IVec3(i % 3 - 1, i / 3 % 3 - 1, i / 9 - 1)));
        if (found == cells_.end()) continue;
        round[count++] = &found->second;
        least = std::min(least, found->second.least);
        most = std::max(most, found->second.most);
      }
      if (least == most) continue;
      for (const std::uint32_t i : cell.places) {
        const Place& own = places_[i];
        const auto visit = [&](auto&& see) {
          for (int c = 0; c < count; ++c)
            for (const std::uint32_t j : round[c]->places) {
              const Vec3 way = places_[j].position - own.position;
              const float squared = glm::dot(way, way) / (radius_ * radius_);
              if (squared < 1 && glm::dot(places_[j].normal, own.normal) > 0) see(int{values_[places_[j].texel][3]}, 1 - squared);
            }
        };
        groom.mask.set(own.texel, {0, 0, 0, static_cast<std::uint8_t>(change(int{values_[own.texel][3]}, visit))});
      }
    }
    groom.mask.fillGutter(skin.atlas, {0, 0, groom.mask.size(), groom.mask.size()});
  }

 private:
  using IVec3 = glm::ivec3;
  struct Cell {
    std::uint8_t least = 255, most = 0;
    std::vector<std::uint32_t> places;
  };
  IVec3 cellOf(const Vec3& position) const { return IVec3(glm::floor(position / radius_)); }
  // 21 bits each: models are fitted to the unit sphere, whose cells are 1e-4 at least.
  static std::uint64_t keyOf(const IVec3& cell) {
    const auto part = [](int c) { return static_cast<std::uint64_t>(c + (1 << 20)) & 0x1fffffu; };
    return part(cell.x) << 42 | part(cell.y) << 21 | part(cell.z);
  }

  std::vector<GroomMap::Texel> values_;  // of the mask as it was
  std::vector<Place> places_;
  std::unordered_map<std::uint64_t, Cell> cells_;
  float radius_ = 0;
};

}  // namespace

void selectConnected(Groom& groom, const GroomSurface& skin, std::uint32_t triangle) {
  std::vector<std::uint32_t> parent(skin.points.count());
  std::iota(parent.begin(), parent.end(), 0u);
  const auto rootOf = [&](std::uint32_t point) {
    while (parent[point] != point) point = parent[point] = parent[parent[point]];
    return point;
  };
  const auto pointAt = [&](std::uint32_t of, std::size_t corner) { return skin.points.pointOf[skin.surface.indices[std::size_t{3} * of + corner]]; };
  for (std::uint32_t t = 0; t < skin.surface.triangleCount(); ++t)
    for (std::size_t k = 1; k < 3; ++k) parent[rootOf(pointAt(t, k))] = rootOf(pointAt(t, 0));
  const std::uint32_t chosen = rootOf(pointAt(triangle, 0));
  select(groom, skin, [&](std::uint32_t, std::uint32_t t) { return allOrNothing(rootOf(pointAt(t, 0)) == chosen); });
}

void selectType(Groom& groom, const GroomSurface& skin, int type) {
  const auto chosen = static_cast<std::size_t>(std::clamp(type, 1, kTypes) - 1);
  select(groom, skin, [&](std::uint32_t i, std::uint32_t) {
    const GroomMap::Texel& t = groom.map.texels()[i];
    return chosen == 0 ? 255 - t[1] - t[2] - t[3] : int{t[chosen]};
  });
}

void selectLength(Groom& groom, const GroomSurface& skin, float shortest, float longest) {
  const auto byteOf = [](float share) { return static_cast<int>(saturate(share) * 255 + 0.5f); };
  const int least = byteOf(shortest), most = byteOf(longest);
  select(groom, skin, [&](std::uint32_t i, std::uint32_t) {
    const int length = groom.map.texels()[i][0];
    return allOrNothing(length >= least && length <= most);
  });
}

void selectPaint(Groom& groom, const GroomSurface& skin, const Vec2& atlas, float tolerance) {
  const auto seen = [](const Vec4& paint) { return Vec4(Vec3(paint) * paint.w, paint.w); };  // the colour of none does not count
  const Vec4 like = seen(groom.paint.at(atlas));
  select(groom, skin, [&](std::uint32_t i, std::uint32_t) {
    const GroomMap::Texel& t = groom.paint.texels()[i];
    const Vec4 apart = glm::abs(seen(Vec4(t[0], t[1], t[2], t[3]) / 255.0f) - like);
    return allOrNothing(std::max(std::max(apart.x, apart.y), std::max(apart.z, apart.w)) <= tolerance);
  });
}

void growMask(Groom& groom, const GroomSurface& skin, float radius) {
  Neighbourhood(groom, skin, radius).apply(groom, skin, [](int most, auto&& visit) {
    visit([&](int value, float) { most = std::max(most, value); });
    return most;
  });
}

void shrinkMask(Groom& groom, const GroomSurface& skin, float radius) {
  Neighbourhood(groom, skin, radius).apply(groom, skin, [](int least, auto&& visit) {
    visit([&](int value, float) { least = std::min(least, value); });
    return least;
  });
}

void smoothMask(Groom& groom, const GroomSurface& skin, float radius) {
  Neighbourhood(groom, skin, radius).apply(groom, skin, [](int, auto&& visit) {
    float sum = 0, shares = 0;
    visit([&](int value, float share) {
      sum += static_cast<float>(value) * share;
      shares += share;
    });
    return static_cast<int>(sum / shares + 0.5f);
  });
}

}  // namespace fur::groom
