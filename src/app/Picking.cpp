// The half of App that knows what is under a pixel: the coat's outside, as it is drawn.
#include <algorithm>
#include <cmath>

#include "app/AppState.h"
#include "core/PortableMath.h"
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

}  // namespace

// Strands up to the height `h` of the coat: the C++ twin of where shell.vert puts them.
struct App::State::CoatShell final : geometry::SurfaceQuery::Lifted {
  CoatShell(const State& state, float height) : s(state), h(height), wet(!state.mask.isDry()) {
    reach = s.settings.furLength * h;
  }
  Vec3 corner(std::uint32_t index) const override {
    const std::uint32_t v = s.surface.indices[index];
    const geometry::SurfaceVertex& vertex = s.surface.vertices[v];
    const Vec3 root = s.pose ? s.skin.positions[v] : vertex.position, normal = s.pose ? s.skin.normals[v] : vertex.normal;
    const Vec4 bent = s.bends.bends()[v];
    const Vec3 bend(bent);
    const float length = geometry::coatThickness(vertex, s.settings.furLength * bent.w);
    const auto curve = static_cast<dynamics::BendCurve>(s.settings.bendCurve);
    // Wet strands stand lower.
    const float stands = wet ? wet::upright(s.mask.at(vertex.atlas.x, vertex.atlas.y).w) : 1;
    return dynamics::strandPoint(root, normal, bend, length, h * stands, curve);
  }
  Vec3 at(const geometry::SurfacePoint& point) const {
    Vec3 sum(0);
    for (int k = 0; k < 3; ++k) sum += corner(3 * point.triangle + static_cast<std::uint32_t>(k)) * point.weights[k];
    return sum;
  }
  // Whether strands stand about so high there: between vertices the map knows it.
  bool stands(const geometry::SurfacePoint& point) const {
    if (!s.groomed) return true;
    float length = 0;
    for (int k = 0; k < 3; ++k) length += s.vertexLengths[s.surface.indices[3 * point.triangle + static_cast<std::uint32_t>(k)]] * point.weights[k];
    return s.groom.map.lengthAt(atlasAt(s.surface, point)) > 0.5f * h * length;
  }

  const State& s;
  float h;
  bool wet;
};

// How high the coat stands, as a share of its longest strands, before tips let everything through.
float App::State::coatHeight() const {
  const std::vector<float>& cover = coat.coverage();
  std::size_t layer = cover.size();
  while (layer > 0 && cover[layer - 1] < kTips) --layer;
  return cover.empty() ? 1 : static_cast<float>(layer) / static_cast<float>(cover.size());
}

ModelRay App::State::rayThrough(Vec2 pixel) const {
  const render::Frame f = frame();
  const Mat4 modelFromClip = glm::inverse(render::clipFromWorld(f) * f.worldFromModel);
  const Vec2 ndc(2 * pixel.x / static_cast<float>(width) - 1, 1 - 2 * pixel.y / static_cast<float>(height));
  const Vec4 nearPoint = modelFromClip * Vec4(ndc, -1, 1), farPoint = modelFromClip * Vec4(ndc, 1, 1);
  const Vec3 origin = Vec3(nearPoint) / nearPoint.w;
  return {origin, normalizeOr(Vec3(farPoint) / farPoint.w - origin, Vec3(0, 0, -1))};
}

std::optional<geometry::SurfacePoint> App::State::pick(Vec2 pixel) {
  const ModelRay ray = rayThrough(pixel);
  const geometry::SurfaceQuery& on = shownQuery();
  const auto skin = on.castRay(ray.origin, ray.direction);
  const float height = coatHeight();
  std::optional<geometry::SurfacePoint> seen;
  for (const float share : {1.0f, kSeen, 0.9f, 0.8f, 0.7f, 0.5f, 0.4f, 0.2f}) {
    // The others for what is seen past the skin, of strands of many lengths.
    if (share != 1 && share != kSeen && (seen || skin)) break;
    const CoatShell shell(*this, share * height);
    const auto hit = on.castRay(ray.origin, ray.direction, &shell);
    if (hit && shell.stands(*hit) && (!seen || hit->distance < seen->distance + kSeenThrough * settings.furLength)) seen = hit;
  }
  return !seen || (skin && skin->distance < seen->distance) ? skin : seen;
}

Vec3 App::State::seenAt(const geometry::SurfacePoint& at) const { return CoatShell(*this, kSeen * coatHeight()).at(at); }

// --- App's side --------------------------------------------------------------------------------

std::optional<Vec2> App::pick(Vec2 pixel) const {
  const auto hit = state_->pick(pixel);
  if (!hit) return std::nullopt;
  return atlasAt(state_->surface, *hit);
}

std::vector<Vec2> App::brushRing(Vec2 pixel, bool ofMirror) const {
  constexpr int kCorners = 24;
  State& s = *state_;
  const float radius = s.settings.brushRadius * traitsOf(s.tool).reach;
  std::vector<Vec2> ring;
  if (radius <= 0) return ring;
  auto hit = s.pick(pixel);
  if (hit && ofMirror) hit = s.mirrored(*hit);
  if (!hit) return ring;
  const Vec3 centre = s.shownPosition(*hit), normal = s.shownNormal(*hit);
  const Vec3 lifted = s.seenAt(*hit) - centre;
  const auto [side, up] = axesOn(normal);
  const render::Frame f = s.frame();
  const Mat4 toClip = render::clipFromWorld(f) * f.worldFromModel;
  for (int k = 0; k < kCorners; ++k) {
    const float angle = 2 * kPi * static_cast<float>(k) / kCorners;
    Vec3 at = centre + radius * (portableCos(angle) * side + portableSin(angle) * up);
    // On the fur over the skin there.
    if (const auto skin = s.shownQuery().castRay(at + radius * normal, -normal); skin && skin->distance < 2 * radius) at = s.seenAt(*skin);
    else at += lifted;
    const Vec4 clip = toClip * Vec4(at, 1);
    ring.push_back((Vec2(clip.x, -clip.y) / clip.w * 0.5f + 0.5f) * Vec2(s.width, s.height));
  }
  return ring;
}

}  // namespace fur::app
