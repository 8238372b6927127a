// The pony's mane, forelock and tail, while it shakes itself.
#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <iterator>

#include "app/stages/GrownHair.h"
#include "scene/Model.h"

namespace fur::app {
namespace {

struct Pony {
  Pony() {
    std::ifstream file(FUR_ASSETS "/pony.glb", std::ios::binary);
    const std::vector<std::uint8_t> bytes{std::istreambuf_iterator<char>(file), {}};
    scene::readLongHair();
    auto model = scene::importModel(bytes, "pony.glb");
    EXPECT_TRUE(model) << model.error().message;
    auto surface = geometry::buildSurface(model->mesh);
    style = model->fur.hair;
    shape.setModel(std::move(model->mesh), std::move(*surface), std::move(model->rig), model->materialOf);
    hair.setStyle(style);
  }
  int animation(std::string_view name) const {
    const auto& all = shape.rig().animations;
    return static_cast<int>(std::find_if(all.begin(), all.end(), [&](const auto& one) { return one.name == name; }) - all.begin());
  }
  void play(int one, float seconds) {
    shape.update({seconds, one, 1});
    hair.update({.shape = shape, .settings = settings, .wind = {}, .seconds = seconds});
  }
  // How far it is below the skin, of the skin within `reach`; model units.
  float depth(const Vec3& p, float reach) const {
    const auto& positions = shape.skin()->positions;
    const auto& indices = shape.surface().indices;
    float nearest = reach, below = 0;
    for (const std::uint32_t t : shape.shownQuery().trianglesWithin(p, reach)) {
      const Vec3 corners[3] = {positions[indices[3 * t]], positions[indices[3 * t + 1]], positions[indices[3 * t + 2]]};
      const Vec3 weights = geometry::nearestWeights(p, corners[0], corners[1], corners[2]);
      const Vec3 away = p - (weights.x * corners[0] + weights.y * corners[1] + weights.z * corners[2]);
      if (glm::length(away) >= nearest) continue;
      nearest = glm::length(away);
      below = -glm::dot(away, normalizeOr(glm::cross(corners[1] - corners[0], corners[2] - corners[0]), Vec3(0)));
    }
    return std::max(below, 0.0f);
  }

  ShapeStage shape;
  hair::Hairstyle style;
  settings::Settings settings;
  GrownHair hair;
};

// Model units: no more than the coat is high there, of which hair is seen to lie on the skin. Collision shapes are capsules, between which
// the skin bulges a little.
constexpr float kDepth = 0.02f;

TEST(PonyHair, StaysOutsideOfTheBodyOverAMinuteOfShaking) {
  Pony pony;
  const int shake = pony.animation("shake");
  ASSERT_LT(static_cast<std::size_t>(shake), pony.shape.rig().animations.size());
  ASSERT_EQ(pony.style.scalps.size(), 3u);
  float deepest = 0;
  for (int frame = 0; frame < 60 * 30; ++frame) {
    pony.play(shake, 1.0f / 30);
    if (frame % 15 != 0) continue;
    for (std::size_t scalp = 0; scalp < pony.hair.scalpCount(); ++scalp) {
      const auto nodes = pony.hair.nodes(scalp);
      const auto each = static_cast<std::size_t>(pony.style.scalps[scalp].guides.nodes);
      // The first two are at the root, within the coat. A third of the others, another one each time: looking takes longest.
      for (std::size_t i = static_cast<std::size_t>(frame) / 15 % 3; i < nodes.size(); i += 3)
        if (i % each >= 2) deepest = std::max(deepest, pony.depth(nodes[i].position, 0.15f));
    }
  }
  EXPECT_LT(deepest, kDepth);
}

}  // namespace
}  // namespace fur::app
