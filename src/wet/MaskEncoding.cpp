#include "wet/MaskEncoding.h"

#include <algorithm>
#include <cmath>

#include "wet/Clump.h"
#include "wet/SurfaceWetting.h"

namespace fur::wet {

namespace {

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
// Of sheets, in the widest means: 0 on a straight border and along a streak as wide as fur is long, so that it is clumps and no sheet;
// 1 from 24/25 on.
constexpr Rise kSheetRise{2.5f, 1.4f};

// Clumps of that radius (model units), and less, run dry over near means, large ones over wider ones: over half of them.
constexpr float kSmall = 0.05f, kLarge = 0.12f;

// The water that a wet texel is shown with. Rows that the flow has missed become as wet as those round them.
float shownWater(const WaterAround::Means& around, float own, float clumpRadius) {
  const float held = std::min(std::max(own, around.held), 1.0f);
  const float mean = glm::mix(around.held, around.wide, saturate((clumpRadius - kSmall) / (kLarge - kSmall)));
  const float inside = std::clamp(kClumpRise.at(mean, held), kAlone, 1.0f);
  const float shown = inside * (2 - inside) * held;  // comes to `held` without a bend
  if (shown < kSheetFrom) return shown;
  const float sheet = saturate(kSheetRise.at(around.widest, held));
  return glm::mix(kSheetFrom, shown, sheet) + sheet * sheet * around.film;
}

// A gutter has the clump of a texel that lies inside of it, and may be further off than that reaches: no strand would stand there. Its clump
// comes so much nearer.
void holdWithin(Vec4& texel, const Vec2& at) {
  const Vec2 way = Vec2(texel) - at;
  const float squared = glm::dot(way, way), most = texel.z * texel.z;
  if (!(texel.w > 0 && squared > most && most > 0)) return;
  const Vec2 nearer = at + way * std::sqrt(most / squared);
  texel.x = nearer.x;
  texel.y = nearer.y;
}

constexpr float kMostRadius = 0.999f * FUR_LYING_STEP;
// With the water that fur lies down by there.
float withLying(float radius, float water) {
  return std::min(radius, kMostRadius) + static_cast<float>(FUR_LYING_STEP) * std::floor(saturate(water) * static_cast<float>(FUR_LYING_STEPS) + 0.5f);
}

}  // namespace

MaskTexels encodeMask(const WetnessMask& mask, const TexelRect& rect, std::span<const std::uint16_t> charts, const WaterAround* around, const ChartBorders* borders) {
  MaskTexels out{mask.size(), rect, {}};
  if (rect.empty()) return out;
  out.texels.reserve(static_cast<std::size_t>(rect.x1 - rect.x0) * static_cast<std::size_t>(rect.y1 - rect.y0));
  for (int y = rect.y0; y < rect.y1; ++y)
    for (int x = rect.x0; x < rect.x1; ++x) {
      const std::size_t i = static_cast<std::size_t>(y) * static_cast<std::size_t>(mask.size()) + static_cast<std::size_t>(x);
      const WaterAround::Means means = around ? around->at(i) : WaterAround::Means{};
      if (charts[i] == SurfaceWetting::kNoChart) {
        out.texels.emplace_back(0, 0, withLying(0, means.wide), -1 - means.held);
        continue;
      }
      Vec4 texel = mask.texels()[i];
      holdWithin(texel, mask.texelCentre(i));
      texel.x += static_cast<float>(FUR_CHART_STEP) * (static_cast<float>(charts[i] % FUR_CHART_NUMBERS) + 0.5f);
      const float radius = texel.z;
      texel.z = withLying(texel.z, around ? means.wide : texel.w);
      if (texel.w > 0 && around) texel.w = shownWater(means, texel.w + mask.filmAt(i), around->onSkin(radius));
      out.texels.push_back(texel);
    }
  if (!borders) return out;
  // Rectangles are many and small while water runs: it divides only for the gutters of their rows.
  const auto begin = static_cast<std::uint32_t>(rect.y0 * mask.size()), end = static_cast<std::uint32_t>(rect.y1 * mask.size());
  for (const auto& [texel, border] : borders->gutter()) {
    if (texel < begin || texel >= end) continue;
    const int x = static_cast<int>(texel) % mask.size() - rect.x0, y = static_cast<int>(texel) / mask.size() - rect.y0, across = rect.x1 - rect.x0;
    if (x >= 0 && x < across) out.texels[static_cast<std::size_t>(y * across + x)].y += static_cast<float>(FUR_BORDER_STEP * border);
  }
  return out;
}

}  // namespace fur::wet
