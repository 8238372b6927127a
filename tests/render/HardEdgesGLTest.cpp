// Fur on models with hard edges: no gap shows between the coats of their faces.
#include <algorithm>
#include <string>

#include "render/Blocks.h"
#include "scene/Model.h"
#include "settings/Presets.h"
#include "tests/geometry/Solids.h"
#include "tests/render/Picture.h"

namespace fur {
namespace {

using test::Picture;
using test::Scene;

struct Shown : Scene {
  explicit Shown(const geometry::Mesh& mesh) {
    EXPECT_TRUE(app.loadModel(scene::exportGlb(mesh, "solid"), "solid.glb"));
    for (const auto& [name, value] : {std::pair("backgroundTop", "#0000ff"), std::pair("backgroundBottom", "#0000ff"),
                                      std::pair("ground", "false"), std::pair("gravity", "0"), std::pair("fins", "false")})
      app.setField(name, value);
  }

  // The convex hull in the picture of what stands `share` of a fur length over the vertices.
  std::vector<Vec2> hull(float share) const {
    const render::Frame f = app.frame();
    const Mat4 clip = render::clipFromWorld(f) * f.worldFromModel;
    std::vector<Vec2> points, out;
    for (const auto& v : app.surface().vertices) {
      const Vec4 c = clip * Vec4(v.position + v.normal * (share * f.settings.furLength), 1);
      points.push_back(Vec2((0.5f + 0.5f * c.x / c.w) * static_cast<float>(f.width), (0.5f - 0.5f * c.y / c.w) * static_cast<float>(f.height)));
    }
    std::sort(points.begin(), points.end(), [](const Vec2& a, const Vec2& b) { return a.x != b.x ? a.x < b.x : a.y < b.y; });
    const auto turn = [](const Vec2& a, const Vec2& b, const Vec2& c) { return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x); };
    for (int side = 0; side < 2; ++side, std::reverse(points.begin(), points.end())) {
      const std::size_t first = out.size();
      for (const Vec2& p : points) {
        while (out.size() >= first + 2 && turn(out[out.size() - 2], out.back(), p) <= 0) out.pop_back();
        out.push_back(p);
      }
      out.pop_back();
    }
    return out;
  }

  // Share of the pixels within the hull, so far from its border, in which the background shows.
  static constexpr float kWithin = 1.5f;
  float gaps(float share) {
    const std::vector<Vec2> border = hull(share);
    const Picture picture = draw();
    int inside = 0, seen = 0;
    for (int y = 0; y < picture.height; ++y)
      for (int x = 0; x < picture.width; ++x) {
        const Vec2 p(static_cast<float>(x) + 0.5f, static_cast<float>(y) + 0.5f);
        bool in = true;
        for (std::size_t i = 0; i < border.size(); ++i) {
          const Vec2 a = border[i], b = border[(i + 1) % border.size()];
          in &= (b.x - a.x) * (p.y - a.y) - (b.y - a.y) * (p.x - a.x) > kWithin * glm::distance(a, b);
        }
        const std::uint8_t* pixel = picture.at(x, y);
        inside += in;
        seen += in && pixel[2] > 250 && pixel[0] < 5;
      }
    EXPECT_GT(inside, 2000);
    return static_cast<float>(seen) / static_cast<float>(inside);
  }
};

TEST(HardEdges, NoBackgroundShowsThroughTheCoatOfACubeDryOrWet) {
  Shown cube(geometry::test::makeCube());
  for (const char* preset : {"rabbit", "shag", "velvet"}) {
    auto settings = settings::applyPreset(cube.app.settings(), preset);
    ASSERT_TRUE(settings);
    settings->gravity = 0;
    cube.app.setSettings(*settings);
    for (const float wetness : {0.0f, 0.6f}) {
      cube.app.setWetness(wetness);
      for (const auto& [yaw, pitch, distance] : {std::tuple(0.6f, 0.45f, 4.0f), std::tuple(0.0f, 0.0f, 4.0f), std::tuple(2.1f, -0.5f, 6.0f)}) {
        cube.app.setCamera({yaw, pitch, distance});
        cube.app.settle();
        // Clumps stand half as high and split into locks, between which one sees far down at the outline; a pixel may show between two.
        EXPECT_LE(cube.gaps(wetness > 0 ? 0.1f : 0.5f), wetness > 0 ? 2e-4f : 0.0f) << preset << " wet " << wetness << " from " << yaw;
      }
    }
  }
}

}  // namespace
}  // namespace fur
