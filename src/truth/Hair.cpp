#include "truth/Hair.h"

#include <algorithm>
#include <cmath>

#include "core/Srgb.h"
#include "hair/StrandShading.h"
#include "truth/Parallel.h"

namespace fur::truth {

namespace {

// Pieces of a strand: as many as waves of single strands need, and where its wisp bends more of them, as light is linear along each.
constexpr int kPieces = 2 * hair::kStripSegments, kMostInPiece = 12;
constexpr float kTurn = 0.04f;  // radians
constexpr std::size_t kWispsAPiece = 16;

struct Place {
  float t;
  hair::WispPoint point;
};

// Of a wisp's middle line, root to tip.
std::vector<Place> placesOf(const LongHair& hair, const hair::Wisp& wisp) {
  const hair::WispShape shape = hair::shapeOf(hair.values);
  const auto at = [&](float t) { return Place{t, hair::wispPoint(wisp, hair.nodes, hair.nodesEach, shape, t)}; };
  std::vector<Place> out{at(0)};
  for (int k = 1; k <= kPieces; ++k) {
    const Place from = out.back(), to = at(static_cast<float>(k) / kPieces);
    const float turn = glm::distance(from.point.along, to.point.along);
    const int parts = std::clamp(static_cast<int>(std::ceil(turn / kTurn)), 1, kMostInPiece);
    for (int i = 1; i < parts; ++i) out.push_back(at(glm::mix(from.t, to.t, static_cast<float>(i) / static_cast<float>(parts))));
    out.push_back(to);
  }
  return out;
}

// The light from all around that comes to a wisp's middle line.
float ambientAt(const LongHair& hair, std::size_t wisp, float t) {
  if (hair.ambient.empty()) return 1;
  const float at = t * hair::kStripSegments;
  const std::size_t below = std::min(static_cast<std::size_t>(at), static_cast<std::size_t>(hair::kStripSegments - 1));
  const std::uint8_t* points = &hair.ambient[wisp * (hair::kStripSegments + 1)];
  return glm::mix(static_cast<float>(points[below]), static_cast<float>(points[below + 1]), at - static_cast<float>(below)) / 255.0f;
}

void placeWisp(const Scene& scene, std::uint32_t scalp, std::size_t number, Tubes& out) {
  const LongHair& hair = scene.hair[scalp];
  const hair::Wisp& wisp = hair.wisps[number];
  const hair::WispShape shape = hair::shapeOf(hair.values);
  const std::vector<Place> places = placesOf(hair, wisp);
  const std::size_t each = hair.members.size() / hair::kWispKinds;
  for (const hair::MemberStrand& member : hair.members.subspan(static_cast<std::size_t>(hair::wispKind(wisp.random)) * each, each)) {
    const auto first = static_cast<std::uint32_t>(out.nodes.size());
    for (const Place& place : places) {
      const float t = std::min(place.t, member.length);
      const Vec2 offset = hair::memberOffset(member, t);
      Vec3 p = hair::memberPoint(place.point, offset, wisp.width, shape, t);
      const Vec3 toEye = normalizeOr(Vec3(scene.frame.eye) - p, place.point.out);
      const float front = 0.5f + 0.5f * glm::clamp(glm::dot(place.point.across * offset.x + place.point.out * offset.y, toEye), -1.0f, 1.0f);
      if (t < place.t) {  // its tip, on the way to there
        const TubeNode& last = out.nodes.back();
        p = glm::mix(last.position, p, (t - last.height) / (place.t - last.height));
      }
      out.nodes.push_back({p, 0.5f * hair.values.strandWidth * hair::memberWidth(member, t), wisp.normal, t,
                           glm::mix(0.55f, 1.0f, front) * glm::mix(1.0f, ambientAt(hair, number, t), hair.occlusion)});
      if (t == member.length) break;
    }
    out.tubes.push_back({first, static_cast<std::uint32_t>(out.nodes.size()) - first, member.random, scalp});
  }
}

Vec3 shadeNode(const Scene& scene, const hair::StrandLook& look, const LongHair& of, const TubeNode& node, const Vec3& tangent, float strand,
               float lit, Light light) {
  const Vec3 toLight(scene.frame.light), view = normalizeOr(Vec3(scene.frame.eye) - node.position, node.normal);
  // Turned the way of the skin that it grows from; where it stands up from it, towards the light.
  const Vec3 leant = node.normal + 0.35f * toLight + 1e-4f * view;
  const Vec3 z = normalizeOr(leant - tangent * glm::dot(tangent, leant), node.normal);
  const float nDotL = glm::dot(z, toLight), nDotV = glm::dot(z, view), height = node.share;
  const Vec3 albedo = hair::strandColor(linearColor(of.values.rootColor), linearColor(of.values.tipColor), node.height, strand, of.values.variance);
  hair::StrandLight lights;
  lights.key = Vec3(scene.frame.keyLight) * (light == Light::Traced ? lit : lit * hair::bodyShare(nDotL));
  lights.through = Vec3(scene.frame.keyLight) * (lit * hair::rimLight(glm::dot(toLight, view), nDotV, height));
  lights.fill = scene.frame.fillLight;
  lights.rim = Vec3(scene.frame.backLight) * hair::fringe(nDotV, height);
  lights.sky = skyLight(scene, z);
  const Vec3 tilted = glm::normalize(tangent + z * hair::strandTilt(strand, node.height));
  return hair::shadeStrand(look, albedo, tilted, toLight, view, nDotL, nDotV, height, 0, lights, strand);
}

}  // namespace

Tubes placeHair(const Scene& scene) {
  Tubes all;
  for (std::uint32_t scalp = 0; scalp < scene.hair.size(); ++scalp) {
    const std::span<const hair::Wisp> wisps = scene.hair[scalp].wisps;
    std::vector<Tubes> parts((wisps.size() + kWispsAPiece - 1) / kWispsAPiece);
    inParallel(parts.size(), [&](std::size_t piece) {
      const std::size_t end = std::min((piece + 1) * kWispsAPiece, wisps.size());
      for (std::size_t i = piece * kWispsAPiece; i < end; ++i) placeWisp(scene, scalp, i, parts[piece]);
    });
    for (const Tubes& part : parts) all.append(part);
  }
  return all;
}

std::vector<Vec3> shadeHair(const Scene& scene, const Tubes& tubes, const Shadows& shadows, Light light) {
  std::vector<Vec3> out(tubes.nodes.size());
  forTubes(tubes, [&](const Tube& tube) {
    const LongHair& of = scene.hair[tube.scalp];
    hair::StrandLook look = lookOf(scene);
    look.dryShininess = of.values.shininess;
    look.specular = of.values.gloss;
    for (std::uint32_t k = tube.firstNode; k < tube.firstNode + tube.nodeCount; ++k) {
      const TubeNode& node = tubes.nodes[k];
      const Vec3 tangent = tangentAt(tubes, tube, k);
      out[k] = shadeNode(scene, look, of, node, tangent, tube.variance, shadows.onAllTheWay(scene, node, tangent), light);
    }
  });
  return out;
}

}  // namespace fur::truth
