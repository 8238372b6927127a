#include "hair/ViewLines.h"

#include <algorithm>
#include <cmath>

#include "core/PortableMath.h"
#include "hair/Wisps.h"

namespace fur::hair {

namespace {

constexpr int kCorners = 32;  // of a circle
// Guides of few nodes are drawn as the curves that they are.
constexpr int kPieces = 3, kFewNodes = 12;
// What stretches a spring by this share of its segment is red.
constexpr float kFullStretch = 0.3f;

// From a, all the way round or a half of it, towards b; both radius long.
void addArc(std::vector<ViewLine>& lines, const Vec3& centre, const Vec3& a, const Vec3& b, int corners, const ViewLine& style) {
  ViewLine line = style;
  for (int i = 0; i <= corners; ++i) {
    const float angle = 2 * kPi * static_cast<float>(i) / kCorners;
    line.a = line.b;
    line.b = centre + a * portableCos(angle) + b * portableSin(angle);
    if (i > 0) lines.push_back(line);
  }
}

}  // namespace

Vec3 heatColor(float x) {
  static constexpr Vec3 kColors[] = {{0.12f, 0.2f, 0.85f}, {0.0f, 0.65f, 0.75f}, {0.15f, 0.75f, 0.2f}, {0.95f, 0.85f, 0.1f}, {0.9f, 0.15f, 0.08f}};
  const float at = saturate(x) * 4;
  const auto first = static_cast<std::size_t>(std::min(at, 3.0f));
  return glm::mix(kColors[first], kColors[first + 1], at - static_cast<float>(first));
}

Vec3 colorOfNumber(std::uint32_t number) {
  // Hues by the golden ratio, in three brightnesses.
  const float hue = 6 * static_cast<float>(number * 2654435769u >> 8) / 16777216.0f;
  const auto part = [&](float shift) { return saturate(std::abs(std::fmod(hue + shift, 6.0f) - 3) - 1); };
  const float bright = 1 - 0.18f * static_cast<float>(number % 3);
  return glm::mix(Vec3(1), Vec3(part(0), part(4), part(2)), 0.72f) * bright;
}

ViewColor packColor(const Vec3& color, float alpha) {
  const auto byte = [](float x) { return static_cast<std::uint8_t>(saturate(x) * 255 + 0.5f); };
  return {byte(color.x), byte(color.y), byte(color.z), byte(alpha)};
}

void addGuide(std::vector<ViewLine>& lines, std::span<const GuideNode> chain, bool cubic, const GuideStyle& style) {
  const auto segments = static_cast<int>(chain.size()) - 1;
  const int pieces = cubic && segments < kFewNodes ? kPieces : 1;
  ViewLine line{.width = style.width, .lift = style.lift, .color = style.color};
  line.b = chain[0].position;
  for (int i = 1; i <= segments * pieces; ++i) {
    line.a = line.b;
    line.b = guidePoint(chain, static_cast<float>(i) / static_cast<float>(pieces), cubic).position;
    lines.push_back(line);
  }
  if (style.dots <= 0) return;
  line.width = style.dots;
  for (const GuideNode& node : chain) {
    line.a = line.b = node.position;
    lines.push_back(line);
  }
}

void addSprings(std::vector<ViewLine>& lines, std::span<const Vec3> nodes, std::span<const Vec3> references, float pixels) {
  constexpr float kLift = 0.03f;
  const Vec4 chain(0.75f, 0.77f, 0.8f, 0.7f), reference(0.4f, 0.65f, 1, 1);
  for (std::size_t i = 1; i < nodes.size(); ++i) {
    lines.push_back({nodes[i - 1], pixels, nodes[i], kLift, chain});
    const float stretch = glm::length(references[i] - nodes[i]) / std::max(glm::length(nodes[i] - nodes[i - 1]), 1e-6f);
    // The upper half of the scale: from green on.
    const Vec4 color(heatColor(0.5f + 0.5f * stretch / kFullStretch), 1);
    lines.push_back({nodes[i], 2 * pixels, references[i], kLift, color});
    lines.push_back({nodes[i], 5 * pixels, nodes[i], kLift, color});
    lines.push_back({references[i], 2.5f * pixels, references[i], kLift, reference});
  }
}

void addBody(std::vector<ViewLine>& lines, const Body& body, const Vec4& color, float width) {
  const ViewLine style{.width = width, .color = color};
  const Vec3 axis = normalizeOr(body.b - body.a, Vec3(0, 1, 0));
  const Vec3 side = normalizeOr(glm::cross(axis, std::abs(axis.z) < 0.9f ? Vec3(0, 0, 1) : Vec3(1, 0, 0)), Vec3(1, 0, 0));
  const Vec3 sides[] = {side * body.radius, glm::cross(axis, side) * body.radius};
  const Vec3 up = axis * body.radius;
  for (const Vec3& end : {body.a, body.b}) addArc(lines, end, sides[0], sides[1], kCorners, style);
  for (const Vec3& out : sides) {
    addArc(lines, body.b, out, up, kCorners / 2, style);
    addArc(lines, body.a, out, -up, kCorners / 2, style);
    if (body.a == body.b) continue;
    for (const float sign : {-1.0f, 1.0f}) lines.push_back({body.a + out * sign, width, body.b + out * sign, 0, color});
  }
}

}  // namespace fur::hair
