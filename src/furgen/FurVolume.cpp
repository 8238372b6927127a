#include "furgen/FurVolume.h"

#include <algorithm>
#include <cmath>

#include "furgen/NearestFill.h"
#include "furgen/Strand.h"
#include "furgen/Strands.h"

namespace fur::furgen {

namespace {

constexpr float kOffsetScale = 64.0f;
constexpr float kFinStrip = 0.06f;  // share of the tile whose strands make the fin map (Sheppard 4.2.3)
constexpr int kFinRows = 64;

std::uint8_t unitByte(float x) { return static_cast<std::uint8_t>(saturate(x) * 255.0f + 0.5f); }

std::int8_t signedByte(float x) { return static_cast<std::int8_t>(std::floor(glm::clamp(x, -1.0f, 1.0f) * 127.0f + 0.5f)); }

// A disc blurred by about a texel, its sum over the texels kept at pi r^2: from r^2 = 1/3 up a
// truncated cone with edge slope 1, below a cone whose height falls instead of its width, so that a
// strand much finer than a texel still counts for what it covers.
struct SoftDisc {
  explicit SoftDisc(float radius) {
    const float squared = radius * radius;
    const bool wide = squared >= 1.0f / 3.0f;
    outer = wide ? std::sqrt(squared - 1.0f / 12.0f) + 0.5f : 1.0f;
    peak = wide ? 1.0f : 3.0f * squared;
  }
  float at(float distance) const { return peak * saturate(outer - distance); }
  float outer, peak;
};

// Where a strand stands on one layer.
struct Cut {
  Vec2 axis;
  Vec2 shift;  // from root to axis
  float radius;
  std::int8_t tangent[3];
};

void packTangent(const Vec2& shiftBelow, const Vec2& shift, float spacing, int size, std::int8_t* out) {
  const float scale = kTileAspect / static_cast<float>(size);
  const Vec3 step((shift.x - shiftBelow.x) * scale, (shift.y - shiftBelow.y) * scale, spacing);
  const float length = std::sqrt(step.x * step.x + step.y * step.y + step.z * step.z);
  out[0] = signedByte(step.x / length);
  out[1] = signedByte(step.y / length);
  out[2] = std::max<std::int8_t>(signedByte(step.z / length), 1);
}

// Every strand's cut with one layer; `below` is the shift on the layer below and is moved on.
std::vector<Cut> cutLayer(const std::vector<Strand>& strands, const FurParameters& p, int layer,
                          std::vector<Vec2>& below) {
  std::vector<Cut> cuts(strands.size());
  const float h = layerHeight(layer, p.layers);
  for (std::size_t i = 0; i < strands.size(); ++i) {
    const Strand& strand = strands[i];
    Cut& cut = cuts[i];
    cut.radius = strandRadius(strand, h);
    if (cut.radius <= 0.0f) continue;
    cut.shift = strandShift(strand, h);
    cut.axis = strand.root + cut.shift;
    packTangent(below[i], cut.shift, 1.0f / static_cast<float>(p.layers), p.size, cut.tangent);
    below[i] = cut.shift;
  }
  return cuts;
}

// Adds the disc to the coverage (0..1 sums, saturated later); a texel belongs to the strand that
// covers most of it.
void drawDisc(const Cut& cut, std::uint16_t id, int size, std::vector<float>& cover, std::vector<float>& strongest,
              std::uint16_t* ids) {
  const SoftDisc disc(cut.radius);
  const int mask = size - 1;
  const int y0 = static_cast<int>(std::ceil(cut.axis.y - disc.outer - 0.5f));
  const int y1 = static_cast<int>(std::floor(cut.axis.y + disc.outer - 0.5f));
  const int x0 = static_cast<int>(std::ceil(cut.axis.x - disc.outer - 0.5f));
  const int x1 = static_cast<int>(std::floor(cut.axis.x + disc.outer - 0.5f));
  for (int y = y0; y <= y1; ++y)
    for (int x = x0; x <= x1; ++x) {
      const float dx = static_cast<float>(x) + 0.5f - cut.axis.x, dy = static_cast<float>(y) + 0.5f - cut.axis.y;
      const float share = disc.at(std::sqrt(dx * dx + dy * dy));
      if (share <= 0.0f) continue;
      const std::size_t texel = static_cast<std::size_t>(y & mask) * size + (x & mask);
      cover[texel] += share;
      if (share > strongest[texel]) strongest[texel] = share, ids[texel] = id;
    }
}

std::int16_t packOffset(float texels) {
  return static_cast<std::int16_t>(std::floor(glm::clamp(texels * kOffsetScale, -32768.0f, 32767.0f) + 0.5f));
}

void writeTexels(FurVolume& volume, int layer, const std::vector<Strand>& strands, const std::vector<Cut>& cuts) {
  const int size = volume.size;
  const float extent = static_cast<float>(size);
  std::vector<std::uint8_t> dominance(strands.size()), variance(strands.size());
  for (std::size_t i = 0; i < strands.size(); ++i) {
    dominance[i] = unitByte(strands[i].dominance);
    variance[i] = unitByte(strands[i].variance);
  }
  std::size_t texel = static_cast<std::size_t>(layer) * size * size;
  for (int y = 0; y < size; ++y)
    for (int x = 0; x < size; ++x, ++texel) {
      const std::uint16_t id = volume.strandId[texel];
      if (id == 0) {
        volume.tangent[texel * 3 + 2] = 127;
        continue;
      }
      const Cut& cut = cuts[id - 1u];
      volume.dominance[texel] = dominance[id - 1u];
      volume.variance[texel] = variance[id - 1u];
      std::copy(cut.tangent, cut.tangent + 3, &volume.tangent[texel * 3]);
      volume.offset[texel * 2] =
          packOffset(torusDelta(cut.axis.x, static_cast<float>(x) + 0.5f, extent) - cut.shift.x);
      volume.offset[texel * 2 + 1] =
          packOffset(torusDelta(cut.axis.y, static_cast<float>(y) + 0.5f, extent) - cut.shift.y);
    }
}

// How much of the texel [x, x + 1] the interval [low, high] covers.
float overlap(float x, float low, float high) { return std::max(std::min(x + 1.0f, high) - std::max(x, low), 0.0f); }

struct FinRow {
  std::vector<float> cover, strongest;
  std::vector<int> owner;  // index of the strand, -1: none
  explicit FinRow(int size)
      : cover(static_cast<std::size_t>(size)), strongest(static_cast<std::size_t>(size)), owner(static_cast<std::size_t>(size), -1) {}
};

void drawFinStrand(const Strand& strand, int index, float height, int size, FinRow& row) {
  const float radius = strandRadius(strand, height);
  if (radius <= 0.0f) return;
  const float centre = strand.root.x + strandShift(strand, height).x;
  for (int x = static_cast<int>(std::floor(centre - radius)); static_cast<float>(x) < centre + radius; ++x) {
    const float share = overlap(static_cast<float>(x), centre - radius, centre + radius);
    if (share <= 0.0f) continue;
    const std::size_t texel = static_cast<std::size_t>(x & (size - 1));
    row.cover[texel] = std::min(row.cover[texel] + share, 1.0f);
    if (share > row.strongest[texel]) row.strongest[texel] = share, row.owner[texel] = index;
  }
}

// Empty texels take the nearest strand of their row, round the torus.
void fillFinRow(std::vector<int>& owner) {
  const std::vector<int> drawn = owner;
  const int size = static_cast<int>(owner.size());
  if (std::all_of(drawn.begin(), drawn.end(), [](int o) { return o < 0; })) return;
  for (int x = 0; x < size; ++x)
    for (int d = 0; owner[static_cast<std::size_t>(x)] < 0; ++d) {
      const int right = drawn[static_cast<std::size_t>((x + d) & (size - 1))];
      const int left = drawn[static_cast<std::size_t>((x - d) & (size - 1))];
      owner[static_cast<std::size_t>(x)] = right >= 0 ? right : left;
    }
}

void writeFinRow(FurVolume& volume, int rowIndex, const FinRow& row, const std::vector<Strand>& strands) {
  const float spacing = 1.0f / static_cast<float>(volume.finRows);
  const float height = (static_cast<float>(rowIndex) + 0.5f) * spacing;
  for (int x = 0; x < volume.size; ++x) {
    const std::size_t texel = static_cast<std::size_t>(rowIndex) * volume.size + x;
    volume.finCoverage[texel] = unitByte(row.cover[static_cast<std::size_t>(x)]);
    const int owner = row.owner[static_cast<std::size_t>(x)];
    if (owner < 0) {
      volume.finTangent[texel * 3 + 2] = 127;
      continue;
    }
    const Strand& strand = strands[static_cast<std::size_t>(owner)];
    volume.finVariance[texel] = unitByte(strand.variance);
    packTangent(strandShift(strand, height - 0.5f * spacing), strandShift(strand, height + 0.5f * spacing), spacing,
                volume.size, &volume.finTangent[texel * 3]);
  }
}

void drawFin(FurVolume& volume, const std::vector<Strand>& strands) {
  const float extent = static_cast<float>(volume.size);
  const std::size_t texels = static_cast<std::size_t>(volume.finRows) * volume.size;
  volume.finCoverage.assign(texels, 0);
  volume.finVariance.assign(texels, 0);
  volume.finTangent.assign(texels * 3, 0);
  for (int r = 0; r < volume.finRows; ++r) {
    FinRow row(volume.size);
    const float height = (static_cast<float>(r) + 0.5f) / static_cast<float>(volume.finRows);
    for (std::size_t i = 0; i < strands.size(); ++i)
      if (std::abs(strands[i].root.y - 0.5f * extent) < 0.5f * kFinStrip * extent)
        drawFinStrand(strands[i], static_cast<int>(i), height, volume.size, row);
    fillFinRow(row.owner);
    writeFinRow(volume, r, row, strands);
  }
}

float coatWeight(const std::vector<Strand>& strands, const FurParameters& p) {
  // A strand's volume goes with radius^2 * length; the densest straight coat is thickness 1, density 1.
  FurParameters densest = p;
  densest.density = densest.thickness = 1.0f;
  const float radius = meanRadius(1.0f);
  const float full = static_cast<float>(wantedStrands(densest)) * radius * radius;
  float sum = 0.0f;
  for (const Strand& strand : strands) sum += strand.radius * strand.radius * strand.length;
  return saturate(sum / full);
}

float meanCover(const FurVolume& volume) {
  const std::size_t texels = static_cast<std::size_t>(volume.size) * volume.size;
  std::uint32_t sum = 0;
  for (std::size_t i = 0; i < texels; ++i) sum += volume.coverage[i];
  return static_cast<float>(sum) / (255.0f * static_cast<float>(texels));
}

void allocateLayers(FurVolume& volume) {
  const std::size_t texels = static_cast<std::size_t>(volume.layers) * volume.size * volume.size;
  volume.coverage.assign(texels, 0);
  volume.dominance.assign(texels, 255);
  volume.variance.assign(texels, 0);
  volume.tangent.assign(texels * 3, 0);
  volume.offset.assign(texels * 2, 0);
  volume.strandId.assign(texels, 0);
}

std::vector<std::uint8_t> pack(const std::vector<std::uint8_t>& coverage, const std::vector<std::int8_t>& tangent,
                               const std::vector<std::uint8_t>& variance) {
  const auto packed = [](std::int8_t t) { return unitByte(static_cast<float>(t) / 254.0f + 0.5f); };
  std::vector<std::uint8_t> out(coverage.size() * 4);
  for (std::size_t i = 0; i < coverage.size(); ++i) {
    out[i * 4] = coverage[i];
    out[i * 4 + 1] = packed(tangent[i * 3]);
    out[i * 4 + 2] = packed(tangent[i * 3 + 1]);
    out[i * 4 + 3] = variance[i];
  }
  return out;
}

}  // namespace

FurVolume generateFur(const FurParameters& given) {
  const FurParameters p = clampedParameters(given);
  const std::vector<Strand> strands = growStrands(p);
  FurVolume volume;
  volume.size = p.size;
  volume.layers = p.layers;
  volume.strandCount = static_cast<int>(strands.size());
  volume.finRows = std::max(kFinRows, p.layers);
  allocateLayers(volume);
  const std::size_t texels = static_cast<std::size_t>(p.size) * p.size;
  std::vector<float> cover(texels), strongest(texels);
  std::vector<Vec2> below(strands.size(), Vec2(0));
  NearestFill nearest(p.size);
  for (int layer = 0; layer < p.layers; ++layer) {
    const std::vector<Cut> cuts = cutLayer(strands, p, layer, below);
    std::fill(cover.begin(), cover.end(), 0.0f);
    std::fill(strongest.begin(), strongest.end(), 0.0f);
    std::uint16_t* ids = &volume.strandId[layer * texels];
    for (std::size_t i = 0; i < cuts.size(); ++i)
      if (cuts[i].radius > 0.0f) drawDisc(cuts[i], static_cast<std::uint16_t>(i + 1), p.size, cover, strongest, ids);
    for (std::size_t i = 0; i < texels; ++i) volume.coverage[layer * texels + i] = unitByte(cover[i]);
    nearest.fill(ids);
    writeTexels(volume, layer, strands, cuts);
  }
  volume.density = meanCover(volume);
  volume.weight = coatWeight(strands, p);
  drawFin(volume, strands);
  return volume;
}

std::vector<std::uint8_t> packLayers(const FurVolume& volume) {
  return pack(volume.coverage, volume.tangent, volume.variance);
}

std::vector<std::uint8_t> packFin(const FurVolume& volume) {
  return pack(volume.finCoverage, volume.finTangent, volume.finVariance);
}

}  // namespace fur::furgen
