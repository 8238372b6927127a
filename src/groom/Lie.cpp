#include "groom/Lie.h"

#include <algorithm>
#include <cmath>

namespace fur::groom {

namespace {

// Patches are what of a cell's surface faces one of six ways, so that the two sides of an ear are apart.
constexpr int kCells = 24;                    // along the model
constexpr float kPatch = 2.0f / kCells;       // model units
constexpr std::size_t kMostNeighbours = 32;   // of a patch; surfaces have about eight
// Rounds of averaging: each goes on by 0.7 of a patch, and n rounds by the root of n times that.
constexpr int kAxisRounds = 24, kBodyRounds = 80, kWayRounds = 6, kPointRounds = 4;
// Of the model's length over its height, as second moments: from where on it has a back to follow, and where it does entirely.
constexpr float kRound = 1.05f, kLong = 1.8f;
constexpr Vec3 kBackwards(0, -0.35f, -1), kDown(0, -1, -0.35f);
// The way to the tip of a part that stands out, beside those; half of it where it stands out by so much.
constexpr float kOutwards = 3, kPart = 0.1f;  // model units
// Of a way along the skin: below this share fur leans less, down to none.
constexpr float kCrown = 0.35f;
// Of the mean of unit ways round a point: from there on fur lies entirely.
constexpr float kAgreed = 0.7f;

struct Patch {
  Vec3 place{0}, normal{0};
  float area = 0;
  Mat3 facing{0};  // the mean of n n^T
  std::vector<std::uint32_t> beside{};
};

Vec3 onSkin(const Vec3& way, const Vec3& normal) { return way - normal * glm::dot(way, normal); }

std::size_t cellOf(const Vec3& place, const Vec3& normal) {
  std::size_t cell = 0;
  for (int k = 0; k < 3; ++k) {
    // The same on both sides of the middle, as bodies are.
    const int away = std::min(static_cast<int>(std::min(std::abs(place[k]), 1.0f) / kPatch), kCells / 2 - 1);
    cell = cell * kCells + static_cast<std::size_t>(place[k] < 0 ? kCells / 2 - 1 - away : kCells / 2 + away);
  }
  const Vec3 size = glm::abs(normal);
  const int most = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
  return cell * 6 + static_cast<std::size_t>(2 * most + (normal[most] < 0));
}

struct Patches {
  Patches(const geometry::Surface& surface, const SurfacePoints& points) : of(points.count()), normals(points.count(), Vec3(0)), areas_(points.count(), 0.0f) {
    const std::vector<std::uint32_t>& indices = surface.indices;
    for (std::size_t i = 0; i + 2 < indices.size(); i += 3) {
      const auto at = [&](std::size_t k) { return points.positions[points.pointOf[indices[i + k]]]; };
      const Vec3 twice = glm::cross(at(1) - at(0), at(2) - at(0));
      for (std::size_t k = 0; k < 3; ++k) {
        areas_[points.pointOf[indices[i + k]]] += std::sqrt(glm::dot(twice, twice)) / 6;
        normals[points.pointOf[indices[i + k]]] += twice;
      }
    }
    for (std::size_t i = 0; i < normals.size(); ++i) normals[i] = normalizeOr(normals[i], points.normals[i]);
    gather(points);
    for (std::size_t i = 0; i + 2 < indices.size(); i += 3)
      for (std::size_t k = 0; k < 3; ++k) join(of[points.pointOf[indices[i + k]]], of[points.pointOf[indices[i + (k + 1) % 3]]]);
  }

  // The mean of what is round each patch, so many rounds on.
  template <class T>
  std::vector<T> averaged(std::vector<T> values, int rounds) const {
    std::vector<T> next = values;
    for (; rounds > 0; --rounds) {
      for (std::size_t i = 0; i < all.size(); ++i) {
        T sum = values[i] * all[i].area;
        float weight = all[i].area;
        for (const std::uint32_t j : all[i].beside) sum += values[j] * all[j].area, weight += all[j].area;
        next[i] = sum * (1 / weight);
      }
      std::swap(values, next);
    }
    return values;
  }

  std::vector<Patch> all;
  std::vector<std::uint32_t> of;  // of each point
  std::vector<Vec3> normals;      // likewise; of the faces there: over hard edges and rims fur leans

 private:
  std::vector<float> areas_;  // of each point

  void gather(const SurfacePoints& points) {
    constexpr std::uint32_t kNone = 0xffffffffu;
    std::vector<std::uint32_t> at(std::size_t{6} * kCells * kCells * kCells, kNone);
    for (std::size_t i = 0; i < of.size(); ++i) {
      const Vec3 &place = points.positions[i], &normal = normals[i];
      std::uint32_t& patch = at[cellOf(place, normal)];
      if (patch == kNone) {
        patch = static_cast<std::uint32_t>(all.size());
        all.emplace_back();
      }
      of[i] = patch;
      Patch& here = all[patch];
      const float area = std::max(areas_[i], 1e-12f);
      here.place += place * area;
      here.normal += normal * area;
      here.facing += glm::outerProduct(normal, normal) * area;
      here.area += area;
    }
    for (Patch& patch : all) {
      patch.place /= patch.area;
      patch.facing /= patch.area;
      patch.normal = normalizeOr(patch.normal, Vec3(0, 1, 0));
    }
  }

  void join(std::uint32_t a, std::uint32_t b) {
    if (a == b) return;
    std::vector<std::uint32_t> &ofA = all[a].beside, &ofB = all[b].beside;
    if (ofA.size() >= kMostNeighbours || ofB.size() >= kMostNeighbours || std::find(ofA.begin(), ofA.end(), b) != ofA.end()) return;
    ofA.push_back(b);
    ofB.push_back(a);
  }
};

// Where fur would like to go wherever it is: backwards on what is long, down on what is not.
Vec3 wayOfModel(const Patches& patches) {
  Vec3 mean(0), squares(0);
  float area = 0;
  for (const Patch& patch : patches.all) {
    mean += patch.place * patch.area;
    squares += patch.place * patch.place * patch.area;
    area += patch.area;
  }
  const Vec3 moments = squares / area - mean * mean / (area * area);
  const float share = saturate((moments.z - kRound * moments.y) / ((kLong - kRound) * moments.y + 1e-6f));
  return glm::mix(kDown, kBackwards, share);
}

float squaresOf(const Mat3& m) { return glm::dot(m[0], m[0]) + glm::dot(m[1], m[1]) + glm::dot(m[2], m[2]); }

// What runs along the axis of a part, by what its normals face; where there is none it stays as it is, along the skin.
Mat3 alongAxis(const Mat3& facing) {
  Mat3 out = Mat3(1.0f) - facing;
  out = out * out;
  out = out * out;
  return out / std::sqrt(squaresOf(out));
}

// Whether there is a part at all: 0 on a flat sheet, whose border draws together as well when it is averaged.
float roundness(const Mat3& facing) { return saturate(4 * (1 - squaresOf(facing))); }

// To the tip of the part that a place is of: away from where the body draws together when it is averaged. Nothing on what stands
// out to the front, as heads do: their fur goes the other way, from the nose. Feet go on down and to the front.
Vec3 outwards(const Vec3& way) {
  const float squares = glm::dot(way, way), front = way.z + std::min(way.y, 0.0f);
  return way * (saturate(1 - 2 * front / std::sqrt(squares + 1e-9f)) * std::sqrt(squares) * kOutwards / (squares + kPart * kPart));
}

std::vector<Vec3> waysOf(const Patches& patches) {
  std::vector<Mat3> facing;
  std::vector<Vec3> places, ways;
  for (const Patch& patch : patches.all) facing.push_back(patch.facing), places.push_back(patch.place);
  facing = patches.averaged(std::move(facing), kAxisRounds);
  const std::vector<Vec3> body = patches.averaged(places, kBodyRounds);
  const Vec3 liked = wayOfModel(patches);
  for (std::size_t i = 0; i < places.size(); ++i) {
    const Vec3& normal = patches.all[i].normal;
    const Vec3 way = onSkin(alongAxis(facing[i]) * (liked + roundness(facing[i]) * outwards(onSkin(places[i] - body[i], normal))), normal);
    ways.push_back(way / std::max(std::sqrt(glm::dot(way, way)), kCrown));
  }
  return patches.averaged(std::move(ways), kWayRounds);
}

// From the patches to the points: those near and facing the same way count for more, its own always does.
std::vector<Vec3> onPoints(const Patches& patches, const std::vector<Vec3>& ways, const SurfacePoints& points) {
  std::vector<Vec3> out;
  for (std::size_t i = 0; i < points.count(); ++i) {
    Vec3 sum(0);
    float weight = 0;
    const auto add = [&](std::uint32_t at, float least) {
      const Vec3 apart = (patches.all[at].place - points.positions[i]) / (2.2f * kPatch);
      const float near = std::max(1 - glm::dot(apart, apart), 0.0f);
      const float share = std::max(near * near * glm::dot(patches.all[at].normal, patches.normals[i]), least);
      sum += ways[at] * share;
      weight += share;
    };
    add(patches.of[i], 1e-3f);
    for (const std::uint32_t j : patches.all[patches.of[i]].beside) add(j, 0);
    out.push_back(onSkin(sum / weight, patches.normals[i]));
  }
  return out;
}

// Evens out what is left of the patches' borders.
std::vector<Vec3> smoothed(std::vector<Vec3> lie, const geometry::Surface& surface, const SurfacePoints& points, const std::vector<Vec3>& normals) {
  for (int round = 0; round < kPointRounds; ++round) {
    std::vector<Vec3> sums = lie;
    std::vector<float> counts(lie.size(), 1.0f);
    for (std::size_t i = 0; i + 2 < surface.indices.size(); i += 3)
      for (std::size_t k = 0; k < 3; ++k) {
        const std::uint32_t a = points.pointOf[surface.indices[i + k]], b = points.pointOf[surface.indices[i + (k + 1) % 3]];
        sums[a] += lie[b], sums[b] += lie[a];
        ++counts[a], ++counts[b];
      }
    for (std::size_t i = 0; i < lie.size(); ++i) lie[i] = onSkin(sums[i] / counts[i], normals[i]);
  }
  return lie;
}

}  // namespace

std::vector<Vec3> naturalLie(const geometry::Surface& surface, const SurfacePoints& points) {
  const Patches patches(surface, points);
  std::vector<Vec3> lie = smoothed(onPoints(patches, waysOf(patches), points), surface, points, patches.normals);
  for (std::size_t i = 0; i < lie.size(); ++i) {
    Vec3& way = lie[i];
    way = onSkin(way, points.normals[i]);
    const float length = std::sqrt(glm::dot(way, way)), share = std::min(length / kAgreed, 1.0f);
    way *= share * share * (3 - 2 * share) / std::max(length, 1e-6f);
  }
  return lie;
}

}  // namespace fur::groom
