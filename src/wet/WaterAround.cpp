#include "wet/WaterAround.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace fur::wet {

namespace {

// R, in widths of a cell: of the mean at a place, and of one turn of widening, which knows all cells that a place's mean is of.
constexpr float kReach = 1.4f, kWideReach = 2.2f;
constexpr int kWideTurns = 2, kTurns = 6;  // of widening
constexpr float kStep = 1.0f / 1024, kWideStep = 1.0f / 256;  // of water: near ones as Water::kLeast
constexpr float kMostFilm = 1.0f;
constexpr int kMostCubes = 32;        // along a side
constexpr std::uint32_t kNone = SurfaceTexels::kNone;

// No more than there is, less roundings of sums.
float inSteps(float water, float step) { return step * std::floor(water / step + 0.01f); }

float weightOf(const Vec3& way, float radius, const Vec3& normal, const Vec3& other) {
  const float left = 1.0f - glm::dot(way, way) / (radius * radius), faces = glm::dot(normal, other);
  return left > 0.0f && faces > 0.0f ? left * left * faces : 0.0f;
}

}  // namespace

WaterAround::WaterAround(int size, std::span<const SurfaceTexels::Place> places, std::span<const std::uint32_t> placeOf, float width)
    : size_(size), cellTexels_(std::clamp(static_cast<int>(std::lround(kCell / std::max(width, 1e-6f))), 1, size)),
      width_(width), radius_(kReach * static_cast<float>(cellTexels_) * width), placeOf_(placeOf.begin(), placeOf.end()), changed_(size) {
  makeCells(places);
  findNear();
  share(places);
  spreadBeside(placeOf);
  water_.assign(cells_.size(), {});
}

// Squares of texels; where charts meet in one each has its own, as it has wherever normals turn away.
void WaterAround::makeCells(std::span<const SurfaceTexels::Place> places) {
  const int side = (size_ + cellTexels_ - 1) / cellTexels_;
  cellOf_.reserve(places.size());
  std::vector<std::uint32_t> first(static_cast<std::size_t>(side * side), kNone), next;  // the cells of each square
  for (const SurfaceTexels::Place& place : places) {
    const int x = static_cast<int>(place.texel) % size_, y = static_cast<int>(place.texel) / size_;
    std::uint32_t& head = first[static_cast<std::size_t>(y / cellTexels_ * side + x / cellTexels_)];
    std::uint32_t here = head;
    for (; here != kNone; here = next[here]) {
      const Vec3 way = cells_[here].centre / cells_[here].area - place.position;
      if (glm::dot(way, way) < radius_ * radius_ && glm::dot(cells_[here].normal, place.normal) > 0.0f) break;
    }
    if (here == kNone) {
      here = static_cast<std::uint32_t>(cells_.size());
      next.push_back(std::exchange(head, here));
      cells_.emplace_back();
    }
    cellOf_.push_back(here);
    Cell& cell = cells_[here];
    cell.centre += place.area * place.position;
    cell.normal += place.area * place.normal;
    cell.area += place.area;
    cell.rect.include(x, y);
  }
  firstTexel_.assign(cells_.size() + 1, 0);
  for (const std::uint32_t c : cellOf_) ++firstTexel_[c + 1];
  for (std::size_t c = 0; c < cells_.size(); ++c) firstTexel_[c + 1] += firstTexel_[c];
  texels_.resize(places.size());
  std::vector<std::uint32_t> to(firstTexel_.begin(), firstTexel_.end() - 1);
  for (std::size_t i = 0; i < places.size(); ++i) texels_[to[cellOf_[i]]++] = {places[i].texel, places[i].area};
  constexpr int kRim = geometry::AtlasTexels::kGutter + kBeside;
  for (Cell& cell : cells_) {
    cell.centre /= cell.area;
    cell.normal = glm::normalize(cell.normal + Vec3(0, 1e-12f, 0));
    cell.rect = {std::max(cell.rect.x0 - kRim, 0), std::max(cell.rect.y0 - kRim, 0), std::min(cell.rect.x1 + kRim, size_), std::min(cell.rect.y1 + kRim, size_)};
  }
}

void WaterAround::findNear() {
  const float radius = radius_ * (kWideReach / kReach);
  // Cells by the cube of space that they lie in. The model is 2 wide; what lies beyond is in the outermost cubes.
  const int side = std::clamp(static_cast<int>(2 / radius), 1, kMostCubes);
  const auto cubeOf = [&](float at) { return std::clamp(static_cast<int>(std::floor((0.5f + 0.5f * at) * static_cast<float>(side))), 0, side - 1); };
  const auto indexOf = [&](int x, int y, int z) { return static_cast<std::size_t>((z * side + y) * side + x); };
  std::vector<std::uint32_t> first(indexOf(0, 0, side), kNone), next;
  for (const Cell& cell : cells_) {
    std::uint32_t& head = first[indexOf(cubeOf(cell.centre.x), cubeOf(cell.centre.y), cubeOf(cell.centre.z))];
    next.push_back(std::exchange(head, static_cast<std::uint32_t>(next.size())));
  }
  const auto add = [&](std::uint32_t c, float weight) {
    // Shares name them by a byte.
    if (!(weight > 0.0f) || near_.size() - nearStart_.back() > 0xff) return;
    near_.push_back(c);
    nearWeight_.push_back(weight);
  };
  nearStart_ = {0};
  for (std::uint32_t own = 0; own < cells_.size(); ++own) {
    const Cell& cell = cells_[own];
    // Itself, however many others there are, and where it has no normal.
    add(own, cell.area);
    const int x = cubeOf(cell.centre.x), y = cubeOf(cell.centre.y), z = cubeOf(cell.centre.z);
    for (int w = std::max(z - 1, 0); w <= std::min(z + 1, side - 1); ++w)
      for (int v = std::max(y - 1, 0); v <= std::min(y + 1, side - 1); ++v)
        for (int u = std::max(x - 1, 0); u <= std::min(x + 1, side - 1); ++u)
          for (std::uint32_t c = first[indexOf(u, v, w)]; c != kNone; c = next[c])
            if (c != own) add(c, cells_[c].area * weightOf(cells_[c].centre - cell.centre, radius, cell.normal, cells_[c].normal));
    float all = 0;
    for (std::size_t k = nearStart_.back(); k < near_.size(); ++k) all += nearWeight_[k];
    for (std::size_t k = nearStart_.back(); k < near_.size(); ++k) nearWeight_[k] /= all;
    nearStart_.push_back(static_cast<std::uint32_t>(near_.size()));
  }
}

// Of the cells near its own those that weigh most, the heaviest first.
void WaterAround::share(std::span<const SurfaceTexels::Place> places) {
  shares_.reserve(places.size());
  for (std::size_t i = 0; i < places.size(); ++i) {
    const std::uint32_t own = cellOf_[i];
    float weights[kShares] = {}, all = 0;
    Share& share = shares_.emplace_back(Share{});
    for (std::uint32_t k = nearStart_[own]; k < nearStart_[own + 1]; ++k) {
      const Cell& cell = cells_[near_[k]];
      float weight = cell.area * weightOf(cell.centre - places[i].position, radius_, cell.normal, places[i].normal);
      if (near_[k] == own) weight = std::max(weight, 1e-3f * cell.area);
      auto which = static_cast<std::uint8_t>(k - nearStart_[own]);
      for (int slot = 0; slot < kShares; ++slot)
        if (weight > weights[slot]) std::swap(weight, weights[slot]), std::swap(which, share.which[slot]);
    }
    for (const float weight : weights) all += weight;
    for (int k = 0; k < kShares; ++k) share.weight[k] = static_cast<std::uint8_t>(weights[k] / all * 255 + 0.5f);
  }
}

// Texels beside the charts know of the water next to them, for look-ups between texels.
void WaterAround::spreadBeside(std::span<const std::uint32_t> placeOf) {
  for (int y = 0; y < size_; ++y)
    for (int x = 0; x < size_; ++x) {
      std::uint32_t& here = placeOf_[static_cast<std::size_t>(y * size_ + x)];
      int nearest = 2 * kBeside * kBeside + 1;
      if (here != kNone) continue;
      for (int v = std::max(y - kBeside, 0); v <= std::min(y + kBeside, size_ - 1); ++v)
        for (int u = std::max(x - kBeside, 0); u <= std::min(x + kBeside, size_ - 1); ++u) {
          const int squared = (u - x) * (u - x) + (v - y) * (v - y);
          const std::uint32_t place = placeOf[static_cast<std::size_t>(v * size_ + u)];
          if (place != kNone && squared < nearest) nearest = squared, here = place;
        }
    }
}

WaterAround::Water WaterAround::sum(const WetnessMask& mask, std::size_t cell) const {
  float held = 0, film = 0;
  for (std::uint32_t k = firstTexel_[cell]; k < firstTexel_[cell + 1]; ++k) {
    const auto [texel, area] = texels_[k];
    const float water = mask.texels()[texel].w + mask.filmAt(texel);
    held += area * std::min(water, 1.0f);
    film += area * glm::clamp(water - 1.0f, 0.0f, kMostFilm);
  }
  return {.held = inSteps(held / cells_[cell].area, kStep), .film = inSteps(film / cells_[cell].area, kStep)};
}

void WaterAround::update(const WetnessMask& mask, std::span<const geometry::TexelRect> changed) {
  std::vector<geometry::TexelRect> parts(changed.begin(), changed.end());
  if (std::exchange(fresh_, false)) parts = {{0, 0, size_, size_}};
  if (parts.empty()) return;
  std::vector<Water> before = water_;
  for (std::size_t c = 0; c < cells_.size(); ++c)
    if (std::any_of(parts.begin(), parts.end(), [&](const geometry::TexelRect& part) { return part.meets(cells_[c].rect); })) water_[c] = sum(mask, c);
  widen();
  for (const geometry::TexelRect& part : parts) changed_.note(part);
  for (std::size_t c = 0; c < cells_.size(); ++c) {
    if (water_[c] == before[c]) continue;
    for (std::uint32_t k = nearStart_[c]; k < nearStart_[c + 1]; ++k) changed_.note(cells_[near_[k]].rect);
  }
}

void WaterAround::widen() {
  std::vector<float> from(cells_.size()), to(cells_.size());
  for (std::size_t c = 0; c < cells_.size(); ++c) from[c] = water_[c].held;
  for (int turn = 0; turn < kTurns; ++turn) {
    for (std::size_t c = 0; c < cells_.size(); ++c) {
      float mean = 0;
      for (std::uint32_t k = nearStart_[c]; k < nearStart_[c + 1]; ++k) mean += nearWeight_[k] * from[near_[k]];
      to[c] = mean;
      if (turn == kWideTurns - 1) water_[c].wide = inSteps(mean, kWideStep);
      if (turn == kTurns - 1) water_[c].widest = inSteps(mean, kWideStep);
    }
    std::swap(from, to);
  }
}

WaterAround::Means WaterAround::at(std::size_t texel) const {
  const std::uint32_t place = placeOf_[texel];
  if (place == kNone) return {};
  const Share& share = shares_[place];
  const std::uint32_t* const near = &near_[nearStart_[cellOf_[place]]];
  float held = 0, film = 0, wide = 0, widest = 0, all = 0;
  for (int k = 0; k < kShares && share.weight[k] > 0; ++k) {
    const Water& water = water_[near[share.which[k]]];
    const float weight = share.weight[k];
    held += weight * water.held;
    film += weight * water.film;
    wide += weight * water.wide;
    widest += weight * water.widest;
    all += weight;
  }
  return {held / all, film / all, wide / all, widest / all};
}

}  // namespace fur::wet
