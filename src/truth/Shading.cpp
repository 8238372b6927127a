#include "truth/Shading.h"

#include <cmath>


namespace fur::truth {

namespace {

// Whether skin shades a point is asked that far above it, model units, and skin counts that lies nearer to the light
// by that much: so the facets of the lit side do not shade themselves, and roots on the far side get no light.
constexpr float kSkinOffset = 0.01f, kSkinBias = 0.002f;
constexpr float kAllTheWay = 1e9f;

// The share of the key light that comes to a node.
float keyAt(const Scene& scene, const hair::StrandLook& look, const TubeNode& node, const Vec3& tangent, const Shadows& shadows, Light light) {
  if (light == Light::Traced) return shadows.onAllTheWay(scene, node, tangent);
  const float nDotL = glm::dot(node.normal, Vec3(scene.frame.light)), rise = std::min(kLook, 1 - node.height) * scene.coat.furLength;
  const float lit = shadows.coat.shareThrough(node.position, node.radius, tangent, shareOfOneStrand(scene), rise / std::max(nDotL, float(FUR_LOWEST_LIGHT)));
  return hair::keyShare(look, node.height, nDotL, lit * shadows.throughHair(scene, node.position, node.radius, tangent));
}

}  // namespace

float shareOfOneStrand(const Scene& scene) { return 1 - float(FUR_SHADE_OF_ONE) * scene.coat.typeShadow.x; }

hair::StrandLook lookOf(const Scene& scene) {
  const render::shared::FurBlock& c = scene.coat;
  return {.lambert = c.lambert, .specular = c.typeSpecular.x, .shininess = c.typeShininess.x, .dryShininess = c.typeDryShininess.x, .strandShadow = c.typeShadow.x,
          .occlusion = c.typeOcclusion.x, .wetDarkening = c.wetDarkening, .wetGloss = c.wetGloss, .density = c.typeDensity.x};
}

Vec3 skyLight(const Scene& scene, const Vec3& normal) {
  const float upness = glm::dot(normal, Vec3(scene.frame.up));
  return glm::mix(Vec3(scene.frame.floorLight), Vec3(scene.frame.sky), 0.5f + 0.5f * upness);
}

Vec3 tangentAt(const Tubes& tubes, const Tube& tube, std::uint32_t node) {
  const std::uint32_t next = std::min(node + 1, tube.firstNode + tube.nodeCount - 1), last = node > tube.firstNode ? node - 1 : node;
  return normalizeOr(tubes.nodes[next].position - tubes.nodes[last].position, tubes.nodes[node].normal);
}

float Shadows::throughHair(const Scene& scene, const Vec3& point, float radius, const Vec3& tangent) const {
  return hair ? hair->shareThrough(point, radius, tangent, shareOfOneStrand(scene), kAllTheWay) : 1.0f;
}

float Shadows::onAllTheWay(const Scene& scene, const TubeNode& node, const Vec3& tangent) const {
  const float past = coat.sharePastSkin(node.position + node.normal * kSkinOffset, kSkinBias);
  if (past <= 0) return 0;
  return past * coat.shareThrough(node.position, node.radius, tangent, shareOfOneStrand(scene), kAllTheWay) *
         throughHair(scene, node.position, node.radius, tangent);
}

std::vector<Vec3> shadeNodes(const Scene& scene, const Tubes& tubes, const Shadows& shadows, Light light) {
  const hair::StrandLook look = lookOf(scene);
  const Vec3 toLight(scene.frame.light), eye(scene.frame.eye);
  std::vector<Vec3> out(tubes.nodes.size());
  forTubes(tubes, [&](const Tube& tube) {
    for (std::uint32_t k = tube.firstNode; k < tube.firstNode + tube.nodeCount; ++k) {
      const TubeNode& node = tubes.nodes[k];
      const Vec3 tangent = tangentAt(tubes, tube, k), view = normalizeOr(eye - node.position, node.normal);
      const Vec3 albedo = hair::strandColor(Vec3(scene.coat.rootColors[0]), Vec3(scene.coat.tipColors[0]), node.height, tube.variance, scene.coat.typeVariance.x);
      const float share = keyAt(scene, look, node, tangent, shadows, light), nDotV = glm::dot(node.normal, view);
      hair::StrandLight lights;
      lights.key = Vec3(scene.frame.keyLight) * share;
      lights.through = lights.key * hair::rimLight(glm::dot(toLight, view), nDotV, node.height);
      lights.fill = scene.frame.fillLight;
      lights.rim = Vec3(scene.frame.backLight) * hair::fringe(nDotV, node.height);
      lights.sky = skyLight(scene, node.normal);
      out[k] = hair::shadeStrand(look, albedo, tangent, toLight, view, glm::dot(node.normal, toLight), nDotV, node.height, 0, lights, tube.variance);
    }
  });
  return out;
}

Vec3 shadeSkin(const Scene& scene, const Vec3& point, const Vec3& normal, float roots, const Shadows& shadows, Light light) {
  const hair::StrandLook look = lookOf(scene);
  const bool furry = roots > 0;
  const float nDotL = glm::dot(normal, Vec3(scene.frame.light));
  float share = 1;
  if (light == Light::Traced) {
    share = shadows.onAllTheWay(scene, {point, 0, normal, 0}, normal);
  } else {
    if (furry) share = glm::mix(1.0f, hair::furShadow(0, look.density, nDotL), look.strandShadow);
    share *= shadows.throughHair(scene, point, 0, normal);
  }
  const Vec3 albedo = Vec3(scene.coat.skinColors[0]) * (1 - 0.5f * roots);
  const Vec3 color = albedo * (Vec3(scene.frame.keyLight) * (std::max(nDotL, 0.0f) * share) + skyLight(scene, normal));
  return color * (furry ? 1 - look.occlusion : 1.0f);
}

}  // namespace fur::truth
