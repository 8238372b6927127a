// Long hair from and into .hair files (scene/HairFile.h).
#include <algorithm>

#include "app/stages/GrownHair.h"
#include "core/NumberText.h"
#include "scene/HairFile.h"

namespace fur::app {

namespace {

// Strands of a file become so many guides.
constexpr int kGuidesOfFile = 128;
constexpr int kMostWispsOfFile = 4000;
// Radius of the skin about a root on which hair grows, at least; model units.
constexpr float kLeastGround = 0.05f;

// Round each root, as far as the next one usually is.
std::vector<Vec4> groundOf(const hair::Guides& guides) {
  std::vector<float> nearest(guides.count(), 2.0f);
  for (std::size_t g = 0; g < guides.count(); ++g)
    for (std::size_t other = 0; other < guides.count(); ++other)
      if (other != g) nearest[g] = std::min(nearest[g], glm::distance(guides.root(g), guides.root(other)));
  std::vector<float> sorted = nearest;
  std::nth_element(sorted.begin(), sorted.begin() + static_cast<std::ptrdiff_t>(sorted.size() / 2), sorted.end());
  std::vector<Vec4> balls;
  for (std::size_t g = 0; g < guides.count(); ++g) balls.emplace_back(guides.root(g), std::max(sorted[sorted.size() / 2], kLeastGround));
  return balls;
}

bool covers(const groom::GroomMap& map) {
  return std::any_of(map.texels().begin(), map.texels().end(), [](const groom::GroomMap::Texel& texel) { return texel[0] > 0; });
}

}  // namespace

Status GrownHair::readFile(const ShapeStage& shape, const groom::GroomSurface& skin, std::span<const std::uint8_t> bytes, const std::string& name) {
  const auto file = scene::readHair(bytes, name);
  if (!file) return file.error();
  hair::Scalp scalp;
  // On the selected scalp, where that is painted; else on a new one all over the model.
  const bool onSelected = !style_.scalps.empty() && covers(style_.scalps[selected_].map);
  if (onSelected) scalp = style_.scalps[selected_];
  else if (style_.scalps.size() >= hair::kMostScalps)
    return Error{ErrorId::TooLarge, name + ": a model has at most " + decimal(hair::kMostScalps) + " scalps"};
  else scalp.map = groom::GroomMap(skin.atlas.size(), {255, 255, 255, 255});
  const scene::HairAsGuides as{.nodes = scalp.values.nodes, .count = kGuidesOfFile};
  auto guides = scene::guidesOf(file.value(), as, name, {shape.surface(), scalp.map}, shape.query());
  if (!guides) return guides.error();
  scalp.guides = std::move(*guides);
  if (onSelected) {
    style_.scalps[selected_] = std::move(scalp);
  } else {
    // It grows where the file's strands do, about as many.
    scalp.map = groom::GroomMap(skin.atlas.size(), kFreshScalp);
    hair::paintDensity(scalp.map, skin, groundOf(scalp.guides), 1);
    const int strands = static_cast<int>(std::min<std::size_t>(file.value().segments.size(), 1000000));
    scalp.values.wisps = std::clamp(strands / scalp.values.strands, scalp.values.wisps, kMostWispsOfFile);
    scalp.name = hair::soundName(std::string_view(name).substr(0, name.rfind('.')));
    style_.scalps.push_back(std::move(scalp));
    selected_ = style_.scalps.size() - 1;
  }
  touch();
  return Done{};
}

Result<std::vector<std::uint8_t>> GrownHair::writeFile() const {
  if (selected_ >= scalps_.size() || scalps_[selected_].growth.wisps.empty()) return Error{ErrorId::BadFile, "there is no hair to save: no scalp has wisps"};
  const hair::Scalp& scalp = style_.scalps[selected_];
  const LiveScalp& live = scalps_[selected_];
  const auto file = scene::hairOfWisps(live.growth.wisps, live.nodes, scalp.guides.nodes, scalp.values);
  if (!file) return file.error();
  return scene::writeHair(file.value());
}

}  // namespace fur::app
