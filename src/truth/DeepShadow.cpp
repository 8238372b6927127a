#include "truth/DeepShadow.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "truth/Parallel.h"
#include "truth/Spans.h"

namespace fur::truth {

namespace {

constexpr int kBands = 16;
constexpr float kNothing = -std::numeric_limits<float>::infinity();
// How far apart, in radii, two crossings of one texel by the same strand are two.
constexpr float kSameCrossing = 4.0f;
// Towards the light a strand is at most this steep, in depth over a step across: else it would shade all of itself.
constexpr float kSteepest = 5.0f;

// The depths of a band of rows as they are drawn, strand after strand.
struct Crossing {
  std::uint32_t texel;
  float depth;
};

// Draws tubes into some rows of the map and keeps one depth for each time that a strand crosses a texel.
class BandPainter {
 public:
  BandPainter(int texels, int firstRow, int endRow)
      : texels_(texels), firstRow_(firstRow), endRow_(endRow),
        last_(static_cast<std::size_t>(texels) * static_cast<std::size_t>(endRow - firstRow), kNobody) {}

  void draw(const Disc& a, const Disc& b, std::uint32_t tube, float sameCrossing) {
    sweep(a, b, {0, firstRow_, texels_, endRow_}, [&](int x, int y, float t) {
      const float depth = glm::mix(a.depth, b.depth, t);
      std::uint32_t& last = last_[static_cast<std::size_t>(y - firstRow_) * static_cast<std::size_t>(texels_) + static_cast<std::size_t>(x)];
      const bool again = last != kNobody && tubes_[last] == tube && std::abs(crossings[last].depth - depth) < sameCrossing;
      if (again) {
        crossings[last].depth = std::max(crossings[last].depth, depth);
        return;
      }
      last = static_cast<std::uint32_t>(crossings.size());
      crossings.push_back({static_cast<std::uint32_t>(y * texels_ + x), depth});
      tubes_.push_back(tube);
    });
  }

  std::vector<Crossing> crossings;

 private:
  static constexpr std::uint32_t kNobody = 0xffffffffu;
  int texels_, firstRow_, endRow_;
  std::vector<std::uint32_t> last_, tubes_;
};

}  // namespace

DeepShadow::DeepShadow(const geometry::Surface& surface, const Tubes& tubes, const Vec3& light, int texels)
    : light_(light), texels_(texels) {
  right_ = normalizeOr(glm::cross(Vec3(0, 1, 0), light), Vec3(1, 0, 0));
  up_ = glm::cross(light, right_);
  float squared = 0;
  for (const auto& v : surface.vertices) squared = std::max(squared, glm::dot(v.position, v.position));
  for (const TubeNode& n : tubes.nodes) squared = std::max(squared, glm::dot(n.position, n.position));
  halfSide_ = std::sqrt(squared) * 1.01f + 1e-3f;
  drawSkin(surface);
  drawTubes(tubes);
}

Vec3 DeepShadow::toMap(const Vec3& p) const {
  const float scale = 0.5f * static_cast<float>(texels_) / halfSide_, middle = 0.5f * static_cast<float>(texels_);
  return {glm::dot(p, right_) * scale + middle, glm::dot(p, up_) * scale + middle, glm::dot(p, light_)};
}

void DeepShadow::drawSkin(const geometry::Surface& surface) {
  const auto side = static_cast<std::size_t>(texels_);
  skin_.assign(side * side, kNothing);
  for (std::size_t i = 0; i + 2 < surface.indices.size(); i += 3) {
    Vec3 c[3];
    for (std::size_t k = 0; k < 3; ++k) c[k] = toMap(surface.vertices[surface.indices[i + k]].position);
    fillTriangle(c, {0, 0, texels_, texels_}, [&](int x, int y, const Vec3& weights) {
      float& depth = skin_[static_cast<std::size_t>(y) * side + static_cast<std::size_t>(x)];
      depth = std::max(depth, weights.x * c[0].z + weights.y * c[1].z + weights.z * c[2].z);
    });
  }
}

void DeepShadow::drawTubes(const Tubes& tubes) {
  const float scale = 0.5f * static_cast<float>(texels_) / halfSide_;
  std::vector<std::vector<Crossing>> bands(kBands);
  inParallel(kBands, [&](std::size_t band) {
    const int firstRow = static_cast<int>(band) * texels_ / kBands, endRow = (static_cast<int>(band) + 1) * texels_ / kBands;
    BandPainter painter(texels_, firstRow, endRow);
    for (std::uint32_t t = 0; t < tubes.tubes.size(); ++t) {
      const Tube& tube = tubes.tubes[t];
      Disc before{};
      for (std::uint32_t k = 0; k < tube.nodeCount; ++k) {
        const TubeNode& node = tubes.nodes[tube.firstNode + k];
        const Vec3 place = toMap(node.position);
        const Disc disc{Vec2(place), node.radius * scale, place.z};
        if (k > 0) painter.draw(before, disc, t, kSameCrossing * node.radius + 2.0f / scale);
        before = disc;
      }
    }
    bands[band] = std::move(painter.crossings);
  });

  const std::size_t count = static_cast<std::size_t>(texels_) * static_cast<std::size_t>(texels_);
  first_.assign(count + 1, 0);
  for (const auto& band : bands)
    for (const Crossing& c : band) ++first_[c.texel + 1];
  for (std::size_t i = 0; i < count; ++i) first_[i + 1] += first_[i];
  depths_.resize(first_[count]);
  inParallel(kBands, [&](std::size_t band) {
    std::vector<std::uint32_t> filled;
    const std::size_t begin = band * static_cast<std::size_t>(texels_) / kBands * static_cast<std::size_t>(texels_);
    const std::size_t end = (band + 1) * static_cast<std::size_t>(texels_) / kBands * static_cast<std::size_t>(texels_);
    filled.assign(end - begin, 0);
    for (const Crossing& c : bands[band]) depths_[first_[c.texel] + filled[c.texel - begin]++] = c.depth;
    for (std::size_t i = begin; i < end; ++i)
      std::sort(depths_.begin() + first_[i], depths_.begin() + first_[i + 1], std::greater<>());
  });
}

int DeepShadow::countBetween(int x, int y, float low, float high) const {
  const std::size_t texel = static_cast<std::size_t>(y) * static_cast<std::size_t>(texels_) + static_cast<std::size_t>(x);
  const auto begin = depths_.begin() + first_[texel], end = depths_.begin() + first_[texel + 1];
  const auto nearer = std::lower_bound(begin, end, high, std::greater<>());
  return static_cast<int>(std::lower_bound(nearer, end, low, std::greater<>()) - nearer);
}

template <class Value>
float DeepShadow::smooth(const Vec3& place, const Value& value) const {
  const float x = place.x - 0.5f, y = place.y - 0.5f;
  const int left = static_cast<int>(std::floor(x)), below = static_cast<int>(std::floor(y));
  const float fx = x - std::floor(x), fy = y - std::floor(y);
  float sum = 0;
  for (int k = 0; k < 4; ++k) {
    const int tx = std::clamp(left + (k & 1), 0, texels_ - 1), ty = std::clamp(below + (k >> 1), 0, texels_ - 1);
    sum += (k & 1 ? fx : 1 - fx) * (k >> 1 ? fy : 1 - fy) * value(tx, ty);
  }
  return sum;
}

float DeepShadow::shareThrough(const Vec3& point, float radius, const Vec3& tangent, float through, float reach) const {
  const Vec3 place = toMap(point);
  const float texel = 2 * halfSide_ / static_cast<float>(texels_);
  const float along = std::abs(glm::dot(tangent, light_));
  const float steep = std::min(along / std::sqrt(std::max(1 - along * along, 1e-6f)), kSteepest);
  const float own = 1.5f * (radius + texel * steep);
  return smooth(place, [&](int x, int y) {
    return std::pow(through, static_cast<float>(countBetween(x, y, place.z + own, place.z + std::max(reach, own))));
  });
}

float DeepShadow::sharePastSkin(const Vec3& point, float bias) const {
  const Vec3 place = toMap(point);
  return smooth(place, [&](int x, int y) {
    return skin_[static_cast<std::size_t>(y) * static_cast<std::size_t>(texels_) + static_cast<std::size_t>(x)] > place.z + bias ? 0.0f : 1.0f;
  });
}

}  // namespace fur::truth
