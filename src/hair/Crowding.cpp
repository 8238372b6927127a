#include "hair/Crowding.h"

#include <algorithm>
#include <cmath>

namespace fur::hair {

namespace {

constexpr float kPush = 6;        // model units / s^2 where density changes by its usual value from cell to cell
constexpr float kMostPush = 12;   // model units / s^2
constexpr float kAhead = 2.5f;    // steps: the middle of the four that it holds for
constexpr float kSpan = 10;       // cells over the rest shape: the rest of the grid's side is room to move

}  // namespace

// The eight cells about a point and their shares of it.
struct Crowding::Corners {
  std::uint16_t cells[8];
  float shares[8];
  Corners(const Vec3& point, float perUnit) {
    std::uint32_t low[3], high[3];
    float share[3];
    for (int c = 0; c < 3; ++c) {
      const float x = point[c] * perUnit, whole = std::floor(x);
      const auto cell = static_cast<std::uint32_t>(static_cast<std::int32_t>(std::clamp(whole, -1e9f, 1e9f)));
      low[c] = cell % kSide;
      high[c] = (cell + 1) % kSide;
      share[c] = x - whole;
    }
    const std::uint32_t rows[4] = {(low[2] * kSide + low[1]) * kSide, (low[2] * kSide + high[1]) * kSide,
                                   (high[2] * kSide + low[1]) * kSide, (high[2] * kSide + high[1]) * kSide};
    const float y = share[1], z = share[2], rowShares[4] = {(1 - z) * (1 - y), (1 - z) * y, z * (1 - y), z * y};
    for (int r = 0; r < 4; ++r) {
      cells[2 * r] = static_cast<std::uint16_t>(rows[r] + low[0]);
      cells[2 * r + 1] = static_cast<std::uint16_t>(rows[r] + high[0]);
      shares[2 * r] = rowShares[r] * (1 - share[0]);
      shares[2 * r + 1] = rowShares[r] * share[0];
    }
  }
};

void Crowding::spread(const Corners& corners, float weight) {
  for (int k = 0; k < 8; ++k) density_[corners.cells[k]] += corners.shares[k] * weight;
}

void Crowding::reset(const GuideBlocks& guides) {
  Vec3 low(1e30f), high(-1e30f);
  for (std::size_t slot = 0; slot < guides.guides; ++slot)
    for (std::size_t i = guides.first(slot / kLanes); i < guides.first(slot / kLanes + 1); ++i) {
      const Vec3 p = laneOf(guides.goals[i], slot % kLanes);
      low = glm::min(low, p);
      high = glm::max(high, p);
    }
  const Vec3 span = high - low;
  perUnit_ = kSpan / std::max({span.x, span.y, span.z, 1e-3f});
  density_.assign(kCells, 0.0f);
  slopes_.assign(kCells, Vec3(0));
  double squares = 0, sum = 0;
  for (std::size_t slot = 0; slot < guides.guides; ++slot)
    for (std::size_t i = guides.first(slot / kLanes) + 2; i < guides.first(slot / kLanes + 1); ++i)
      spread(Corners(laneOf(guides.goals[i], slot % kLanes), perUnit_), 1.0f);
  for (const float density : density_) {
    sum += static_cast<double>(density);
    squares += static_cast<double>(density) * static_cast<double>(density);
  }
  usual_ = sum > 0 ? static_cast<float>(squares / sum) : 1.0f;
}

// Central differences.
void Crowding::findSlopes() {
  const auto at = [&](std::size_t z, std::size_t y, std::size_t x) { return density_[(z % kSide * kSide + y % kSide) * kSide + x % kSide]; };
  for (std::size_t z = 0; z < kSide; ++z)
    for (std::size_t y = 0; y < kSide; ++y)
      for (std::size_t x = 0; x < kSide; ++x)
        slopes_[(z * kSide + y) * kSide + x] = 0.5f * Vec3(at(z, y, x + 1) - at(z, y, x + kSide - 1), at(z, y + 1, x) - at(z, y + kSide - 1, x),
                                                          at(z + 1, y, x) - at(z + kSide - 1, y, x));
}

void Crowding::push(GuideBlocks& guides, float strength, const AdaptiveDetail& detail) {
  std::fill(density_.begin(), density_.end(), 0.0f);
  if (!(strength > 0)) {
    std::fill(guides.pushes.begin(), guides.pushes.end(), Lanes3{});
    return;
  }
  const auto eachNode = [&](auto work) {
    for (std::size_t slot = 0; slot < guides.guides; ++slot)
      for (std::size_t i = guides.first(slot / kLanes) + 2; i < guides.first(slot / kLanes + 1); ++i) work(i, slot % kLanes);
  };
  // Where they will be while this holds: pushes that came late would keep hair swinging.
  const auto ahead = [&](std::size_t i, std::size_t lane) {
    return laneOf(guides.positions[i] + (guides.positions[i] - guides.before[i]) * splat(kAhead), lane);
  };
  eachNode([&](std::size_t i, std::size_t lane) {
    spread(Corners(ahead(i, lane), perUnit_), 1.0f);
    spread(Corners(laneOf(guides.goals[i], lane), perUnit_), -1.0f);
  });
  findSlopes();
  const float perSlope = -strength * kPush / usual_;
  eachNode([&](std::size_t i, std::size_t lane) {
    if (detail.follows(i / static_cast<std::size_t>(guides.nodes))) return;
    const Corners corners(ahead(i, lane), perUnit_);
    Vec3 slope(0);
    for (int k = 0; k < 8; ++k) slope += slopes_[corners.cells[k]] * corners.shares[k];
    slope *= perSlope;
    const float squared = glm::dot(slope, slope);
    if (squared > kMostPush * kMostPush) slope *= kMostPush / std::sqrt(squared);
    setLane(guides.pushes[i], lane, slope);
  });
}

}  // namespace fur::hair
