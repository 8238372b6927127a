#include "wet/MaskEncoding.h"

#include <algorithm>

#include "geometry/Adjacency.h"
#include "wet/Clump.h"
#include "wet/SurfaceWetting.h"

namespace fur::wet {

namespace {

// How far round a texel each step looks, in texels.
constexpr int kEvenedReach = 4;   // rows that the flow has missed become as wet as those round them
constexpr int kSheetReach = 12;   // over so many a sheet parts into clumps towards dry fur; no step looks further
constexpr int kFilmReach = 2;     // over so many the film on a sheet evens out
constexpr int kBesideReach = 3;   // so far from the charts texels know of the water there, for look-ups between texels
// A clump runs dry over this share of its radius: strands of both sides touch.
constexpr float kClumpReach = 0.6f;

// How far inside of wet fur a texel is, by the share of its own water that those round it hold in the mean. On a straight
// border with dry fur that share is a half.
struct Rise {
  float slope, offset;
  float at(float mean, float own) const { return slope * mean / own - offset; }
};
// Of clumps: 0.1 on a straight border, 1 from 7/8 on.
constexpr Rise kClumpRise{2.4f, 1.1f};
// What is left of a clump that is alone in dry fur: its texels keep a tenth of their water and stay wet.
constexpr float kAlone = 0.05f;
// Of sheets: 0 on a straight border, so that a streak is clumps and no sheet; 1 from 21/22 on.
constexpr Rise kSheetRise{2.2f, 1.1f};

// How much water stands on the triangles of a rectangle, summed up from its corner, so that the mean of any part of it is
// four look-ups. In 255ths: sums of whole numbers are exact, whatever the rectangle.
class WaterSums {
 public:
  WaterSums(const WetnessMask& mask, const TexelRect& rect, std::span<const std::uint32_t> triangles)
      : rect_(rect), width_(rect.x1 - rect.x0 + 1), sums_(static_cast<std::size_t>(width_ * (rect.y1 - rect.y0 + 1))) {
    for (int y = rect.y0; y < rect.y1; ++y) {
      Sum row;
      for (int x = rect.x0; x < rect.x1; ++x) {
        const auto i = static_cast<std::size_t>(y * mask.size() + x);
        if (triangles[i] != geometry::kNoTriangle) {
          const float water = mask.texels()[i].w + mask.filmAt(i);
          ++row.texels;
          row.held += static_cast<std::uint32_t>(255 * std::min(water, 1.0f));
          row.film += static_cast<std::uint32_t>(255 * glm::clamp(water - 1, 0.0f, kMostFilm));
        }
        const Sum& above = at(x + 1, y);
        at(x + 1, y + 1) = {above.texels + row.texels, above.held + row.held, above.film + row.film};
      }
    }
  }
  // The mean up to 1 over the square that reaches so far round the texel; `none` where no triangle is.
  float held(int x, int y, int reach, float none) const {
    const Sum sum = around(x, y, reach);
    return sum.texels ? static_cast<float>(sum.held) / (255.0f * static_cast<float>(sum.texels)) : none;
  }
  // Likewise of what there is above 1.
  float film(int x, int y, int reach) const {
    const Sum sum = around(x, y, reach);
    return static_cast<float>(sum.film) / (255.0f * static_cast<float>(std::max(sum.texels, 1u)));
  }

 private:
  static constexpr float kMostFilm = 1.0f;
  struct Sum {
    std::uint32_t texels = 0, held = 0, film = 0;
  };
  Sum around(int x, int y, int reach) const {
    const int x0 = std::max(x - reach, rect_.x0), x1 = std::min(x + reach + 1, rect_.x1);
    const int y0 = std::max(y - reach, rect_.y0), y1 = std::min(y + reach + 1, rect_.y1);
    const Sum &a = at(x0, y0), &b = at(x1, y0), &c = at(x0, y1), &d = at(x1, y1);
    return {d.texels - b.texels - c.texels + a.texels, d.held - b.held - c.held + a.held, d.film - b.film - c.film + a.film};
  }
  std::size_t indexOf(int x, int y) const { return static_cast<std::size_t>((y - rect_.y0) * width_ + x - rect_.x0); }
  const Sum& at(int x, int y) const { return sums_[indexOf(x, y)]; }
  Sum& at(int x, int y) { return sums_[indexOf(x, y)]; }

  TexelRect rect_;
  int width_;
  std::vector<Sum> sums_;
};

TexelRect widened(const TexelRect& rect, int by, int size) {
  return {std::max(rect.x0 - by, 0), std::max(rect.y0 - by, 0), std::min(rect.x1 + by, size), std::min(rect.y1 + by, size)};
}

// The water that a wet texel is shown with. `clumpReach`: that of its clump, in texels.
float shownWater(const WaterSums& water, int x, int y, float own, int clumpReach) {
  const float held = std::min(std::max(own, water.held(x, y, kEvenedReach, 0)), 1.0f);
  const float inside = std::clamp(kClumpRise.at(water.held(x, y, clumpReach, held), held), kAlone, 1.0f);
  const float shown = inside * (2 - inside) * held;  // comes to `held` without a bend
  if (shown < kSheetFrom) return shown;
  const float sheet = saturate(kSheetRise.at(water.held(x, y, kSheetReach, held), held));
  return glm::mix(kSheetFrom, shown, sheet) + sheet * sheet * water.film(x, y, kFilmReach);
}

}  // namespace

MaskTexels encodeMask(const WetnessMask& mask, const TexelRect& changed, const MaskAtlas& atlas, bool softened) {
  MaskTexels out{mask.size(), changed, {}};
  if (changed.empty()) return out;
  const int size = mask.size();
  out.rect = widened(changed, kSheetReach, size);
  const WaterSums water(mask, widened(out.rect, kSheetReach, size), atlas.triangles);
  out.texels.reserve(static_cast<std::size_t>(out.rect.x1 - out.rect.x0) * static_cast<std::size_t>(out.rect.y1 - out.rect.y0));
  for (int y = out.rect.y0; y < out.rect.y1; ++y)
    for (int x = out.rect.x0; x < out.rect.x1; ++x) {
      const std::size_t i = static_cast<std::size_t>(y) * static_cast<std::size_t>(size) + static_cast<std::size_t>(x);
      if (atlas.charts[i] == SurfaceWetting::kNoChart) {
        out.texels.emplace_back(0, 0, 0, -1 - water.held(x, y, kBesideReach, 0));
        continue;
      }
      Vec4 texel = mask.texels()[i];
      const float chart = static_cast<float>(atlas.charts[i] % FUR_CHART_NUMBERS);
      texel.x += static_cast<float>(FUR_CHART_STEP) * (chart + 0.5f);
      if (texel.w > 0 && softened) {
        const int clumpReach = static_cast<int>(std::clamp(kClumpReach * texel.z * static_cast<float>(size), 1.0f, float{kSheetReach}));
        texel.w = shownWater(water, x, y, texel.w + mask.filmAt(i), clumpReach);
      }
      out.texels.push_back(texel);
    }
  return out;
}

}  // namespace fur::wet
