#include "app/Picking.h"

#include <algorithm>
#include <cmath>

#include "geometry/CoatThickness.h"
#include "wet/Clump.h"

namespace fur::app {

namespace {

// Layers of less cover than this hide nothing, even along the outline.
constexpr float kTips = 0.002f;
// Where the strands are that one sees, looking into the coat: a share of its height.
constexpr float kSeen = 0.6f;
// Fur lengths that a ray goes on through the coat, at most, before strands have hidden what lies behind.
constexpr float kSeenThrough = 1.5f;

// Strands up to the height `h` of the coat: the C++ twin of where shell.vert puts them.
struct CoatShell final : geometry::SurfaceQuery::Lifted {
  CoatShell(const Picking& picking, float height)
      : s(picking), surface(picking.shape.surface()), skin(picking.shape.skin()), h(height), wet(!picking.mask.isDry()) {
    reach = s.coatLength * h;
  }
  Vec3 corner(std::uint32_t index) const override {
    const std::uint32_t v = surface.indices[index];
    const geometry::SurfaceVertex& vertex = surface.vertices[v];
    const Vec3 root = skin ? skin->positions[v] : vertex.position, normal = skin ? skin->normals[v] : vertex.normal;
    const Vec4 bent = s.bends[v];
    const Vec3 bend(bent);
    const float length = geometry::coatThickness(vertex, s.coatLength * bent.w);
    const auto curve = static_cast<dynamics::BendCurve>(s.settings.bendCurve);
    // Wet strands stand lower.
    const float stands = wet ? wet::standsTo(s.mask.at(vertex.atlas.x, vertex.atlas.y).w, dynamics::arcBend(glm::length(bend), 1).y) : 1;
    return dynamics::strandPoint(root, normal, bend, length, h * stands, curve);
  }
  Vec3 at(const geometry::SurfacePoint& point) const {
    Vec3 sum(0);
    for (int k = 0; k < 3; ++k) sum += corner(3 * point.triangle + static_cast<std::uint32_t>(k)) * point.weights[k];
    return sum;
  }
  // Whether strands stand about so high there: between vertices the map knows it.
  bool stands(const geometry::SurfacePoint& point) const {
    const std::vector<float>& lengths = s.groom.vertexLengths();
    if (lengths.empty()) return true;
    float length = 0;
    for (int k = 0; k < 3; ++k) length += lengths[surface.indices[3 * point.triangle + static_cast<std::uint32_t>(k)]] * point.weights[k];
    return s.groom.groom().map.lengthAt(atlasAt(surface, point)) > 0.5f * h * length;
  }

  const Picking& s;
  const geometry::Surface& surface;
  const ShapeStage::Skin* skin;
  float h;
  bool wet;
};

}  // namespace

// How high the coat stands, as a share of its longest strands, before tips let everything through.
float Picking::coatHeight() const {
  const std::vector<float>& cover = coat.coverage();
  std::size_t layer = cover.size();
  while (layer > 0 && cover[layer - 1] < kTips) --layer;
  return cover.empty() ? 1 : static_cast<float>(layer) / static_cast<float>(cover.size());
}

std::optional<geometry::SurfacePoint> Picking::at(const Ray& ray) const {
  const geometry::SurfaceQuery& on = shape.shownQuery();
  const auto skin = on.castRay(ray.origin, ray.direction);
  const float height = coatHeight();
  std::optional<geometry::SurfacePoint> seen;
  for (const float share : {1.0f, kSeen, 0.9f, 0.8f, 0.7f, 0.5f, 0.4f, 0.2f}) {
    // The others for what is seen past the skin, of strands of many lengths.
    if (share != 1 && share != kSeen && (seen || skin)) break;
    const CoatShell shell(*this, share * height);
    const auto hit = on.castRay(ray.origin, ray.direction, &shell);
    if (hit && shell.stands(*hit) && (!seen || hit->distance < seen->distance + kSeenThrough * coatLength)) seen = hit;
  }
  return !seen || (skin && skin->distance < seen->distance) ? skin : seen;
}

Vec3 Picking::seenAt(const geometry::SurfacePoint& root) const { return CoatShell(*this, kSeen * coatHeight()).at(root); }

}  // namespace fur::app
