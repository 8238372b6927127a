// Strips of strands, row by row: in each, the strands are intervals, and those in front hide what is behind them.
#include <algorithm>
#include <cmath>

#include "core/Sort.h"
#include "hair/MemberStrands.h"

namespace fur::hair {

namespace {

using Texel = StripPicture::Texel;

constexpr int kLinesOfRow = 4;       // of a row of texels; within a line all is exact
constexpr float kMostSlope = 4.0f;   // that a texel can say
constexpr float kMostContrast = 6;   // that a level is sharpened by
// The narrowest that a wisp gets for the strands on it, as a share of its width: at a pointed tip they are as wide as it.
constexpr float kNarrowest = 0.05f;

// A strand on a line: from and to in texels.
struct Interval {
  float from, to;
  float z, slope, random;
};

// Sums over the visible strands of a texel, weighted by what they cover.
struct Ink {
  float coverage = 0, slope = 0, random = 0, z = 0;
};

// What is covered of a line, as intervals apart from each other in ascending order.
class Line {
 public:
  void clear() { covered_.clear(); }

  // Calls visit(from, to) for each part of [from, to) that is not covered, and covers it.
  template <class Visit>
  void cover(float from, float to, Visit visit) {
    auto first = std::find_if(covered_.begin(), covered_.end(), [&](const Vec2& c) { return c.y >= from; });
    auto end = first;
    float at = from;
    Vec2 whole(from, to);
    for (; end != covered_.end() && end->x <= to; ++end) {
      if (end->x > at) visit(at, end->x);
      at = std::max(at, end->y);
      whole = Vec2(std::min(whole.x, end->x), std::max(whole.y, end->y));
    }
    if (at < to) visit(at, to);
    first = covered_.erase(first, end);
    covered_.insert(first, whole);
  }

 private:
  std::vector<Vec2> covered_;
};

void spill(const Interval& strand, float from, float to, std::vector<Ink>& row) {
  const auto last = static_cast<int>(row.size()) - 1;
  for (int x = std::max(static_cast<int>(from), 0); x <= std::min(static_cast<int>(to), last); ++x) {
    const float left = static_cast<float>(x), part = std::min(to, left + 1) - std::max(from, left);
    if (part <= 0) continue;
    Ink& ink = row[static_cast<std::size_t>(x)];
    ink.coverage += part;
    ink.slope += part * strand.slope;
    ink.random += part * strand.random;
    ink.z += part * strand.z;
  }
}

std::uint8_t byteOf(float x) { return static_cast<std::uint8_t>(255 * saturate(x) + 0.5f); }

Texel texelOf(const Ink& ink, float lines) {
  const float each = 1 / ink.coverage;
  return {byteOf(ink.coverage / lines), byteOf(0.5f + ink.slope * each / (2 * kMostSlope)), byteOf(ink.random * each),
          byteOf(0.5f + 0.5f * ink.z * each / kStripReach)};
}

// Texels without a strand show the next one of their row, so that filtering mixes nothing else in; rows without any the row before.
void fillEmpty(std::span<Texel> row, std::span<const Texel> before) {
  std::vector<int> covered;
  for (int x = 0; x < static_cast<int>(row.size()); ++x)
    if (row[static_cast<std::size_t>(x)][0] > 0) covered.push_back(x);
  std::size_t next = 0;
  for (int x = 0; x < static_cast<int>(row.size()); ++x) {
    Texel& texel = row[static_cast<std::size_t>(x)];
    if (texel[0] > 0) continue;
    while (next + 1 < covered.size() && std::abs(covered[next + 1] - x) < std::abs(covered[next] - x)) ++next;
    if (!covered.empty()) texel = row[static_cast<std::size_t>(covered[next])];
    else if (!before.empty()) texel = before[static_cast<std::size_t>(x)];
    texel[0] = 0;
  }
}

struct Widths {
  float strand, wisp, tip;
  // Half the width of a strand at height t in texels.
  float halfTexels(float t) const {
    const float wide = wisp * std::max(wispWidth(tip, t), kNarrowest) * kStripReach;
    return 0.5f * StripPicture::kWidth * std::min(strand / std::max(wide, 1e-6f), 1.0f);
  }
};

// The strands that cross the line `share` of the way from `low` to `high`, front ones first.
void findIntervals(std::span<const MemberStrand> strands, std::span<const Vec2> low, std::span<const Vec2> high, float t0, float step,
                   float share, const Widths& widths, std::vector<Interval>& out) {
  out.clear();
  const float t = t0 + step * share, half = widths.halfTexels(t);
  for (std::size_t i = 0; i < strands.size(); ++i) {
    const float wide = half * memberWidth(strands[i], t);
    if (wide <= 0) continue;
    const Vec2 at = glm::mix(low[i], high[i], share);
    const float x = 0.5f * StripPicture::kWidth * (at.x / kStripReach + 1);
    out.push_back({x - wide, x + wide, at.y, (high[i].x - low[i].x) / step, strands[i].random});
  }
  sortStably(out.begin(), out.end(), [](const Interval& a, const Interval& b) { return a.z > b.z; });
}

StripPicture::Level drawKind(std::span<const MemberStrand> strands, const Widths& widths) {
  constexpr auto kWidth = static_cast<std::size_t>(StripPicture::kWidth), kHeight = static_cast<std::size_t>(StripPicture::kHeight);
  constexpr float kStep = 1.0f / kHeight;
  StripPicture::Level picture(kWidth * kHeight, Texel{0, 128, 128, 128});
  std::vector<Vec2> low(strands.size()), high(strands.size());
  for (std::size_t i = 0; i < strands.size(); ++i) high[i] = memberOffset(strands[i], 0);
  std::vector<Interval> intervals;
  Line line;
  for (std::size_t y = 0; y < kHeight; ++y) {
    const float t = static_cast<float>(y) * kStep;
    std::swap(low, high);
    for (std::size_t i = 0; i < strands.size(); ++i) high[i] = memberOffset(strands[i], t + kStep);
    std::vector<Ink> inks(kWidth);
    for (int k = 0; k < kLinesOfRow; ++k) {
      findIntervals(strands, low, high, t, kStep, (static_cast<float>(k) + 0.5f) / kLinesOfRow, widths, intervals);
      line.clear();
      for (const Interval& strand : intervals)
        line.cover(strand.from, strand.to, [&](float from, float to) { spill(strand, from, to, inks); });
    }
    const std::span<Texel> row(&picture[y * kWidth], kWidth);
    for (std::size_t x = 0; x < kWidth; ++x)
      if (inks[x].coverage > 0) row[x] = texelOf(inks[x], kLinesOfRow);
    fillEmpty(row, y == 0 ? std::span<Texel>() : std::span<Texel>(&picture[(y - 1) * kWidth], kWidth));
  }
  return picture;
}

// A level as floats: r is not sharpened there, so that each level is made of what was drawn.
struct Means {
  int width, height;
  std::vector<Vec4> texels;
};

Means halved(const Means& from) {
  Means to{from.width / 2, from.height / 2, {}};
  for (int y = 0; y < to.height; ++y)
    for (int x = 0; x < to.width; ++x) {
      Vec4 sum(0), plain(0);
      for (int k = 0; k < 4; ++k) {
        const Vec4& t = from.texels[static_cast<std::size_t>((2 * y + k / 2) * from.width + 2 * x + k % 2)];
        sum += Vec4(t.x, t.x * Vec3(t.y, t.z, t.w));
        plain += t;
      }
      const Vec3 rest = sum.x > 0 ? Vec3(sum.y, sum.z, sum.w) / sum.x : Vec3(plain.y, plain.z, plain.w) / 4.0f;
      to.texels.emplace_back(sum.x / 4, rest);
    }
  return to;
}

struct Contrast {
  float threshold = 0.5f, gain = 1;
  float of(float coverage) const { return saturate(0.5f + (coverage - threshold) * gain); }
};

float deviation(const std::vector<Vec4>& texels, const Contrast& contrast) {
  float sum = 0, squares = 0;
  for (const Vec4& t : texels) {
    const float c = contrast.of(t.x);
    sum += c;
    squares += c * c;
  }
  const auto count = static_cast<float>(texels.size());
  return std::sqrt(std::max(squares / count - sum * sum / (count * count), 0.0f));
}

float shareAboveHalf(const std::vector<Vec4>& texels) {
  return static_cast<float>(std::count_if(texels.begin(), texels.end(), [](const Vec4& t) { return t.x > 0.5f; })) /
         static_cast<float>(texels.size());
}

// As much of the level above a half as of level 0, and as uneven.
Contrast contrastOf(const Means& level, float share, float unevenness) {
  std::vector<float> sorted;
  for (const Vec4& t : level.texels) sorted.push_back(t.x);
  sortStably(sorted.begin(), sorted.end(), [](float a, float b) { return a > b; });
  const std::size_t above = static_cast<std::size_t>(share * static_cast<float>(sorted.size()) + 0.5f);
  Contrast contrast;
  const float least = above == 0 ? 1.0f : sorted[above - 1], next = above == sorted.size() ? 0.0f : sorted[above];
  contrast.threshold = 0.5f * (least + next);
  float low = 1, high = kMostContrast;
  for (int k = 0; k < 12; ++k) {
    contrast.gain = 0.5f * (low + high);
    (deviation(level.texels, contrast) < unevenness ? low : high) = contrast.gain;
  }
  return contrast;
}

StripPicture::Level bytesOf(const Means& level, const Contrast& contrast) {
  StripPicture::Level out;
  for (const Vec4& t : level.texels) {
    // Bytes above a half are those from 128 on.
    const float c = contrast.of(t.x);
    const std::uint8_t r = t.x > contrast.threshold ? std::max<std::uint8_t>(byteOf(c), 128) : std::min<std::uint8_t>(byteOf(c), 127);
    out.push_back({r, byteOf(t.y), byteOf(t.z), byteOf(t.w)});
  }
  return out;
}

}  // namespace

StripPicture drawStrips(std::span<const MemberStrand> strands, float strandWidth, float widthOfWisp, float tipWidth) {
  StripPicture out;
  const std::size_t each = strands.size() / kWispKinds;
  for (std::size_t kind = 0; kind < kWispKinds; ++kind) {
    auto& levels = out.levels[kind];
    levels[0] = drawKind(strands.subspan(kind * each, each), {strandWidth, widthOfWisp, tipWidth});
    Means means{StripPicture::kWidth, StripPicture::kHeight, {}};
    for (const Texel& t : levels[0]) means.texels.push_back(Vec4(t[0], t[1], t[2], t[3]) / 255.0f);
    const float share = shareAboveHalf(means.texels), unevenness = deviation(means.texels, {});
    for (std::size_t level = 1; level < levels.size(); ++level) {
      means = halved(means);
      levels[level] = bytesOf(means, contrastOf(means, share, unevenness));
    }
  }
  return out;
}

}  // namespace fur::hair
