#include "truth/Shading.h"

#include <algorithm>
#include <cmath>

#include "hair/StrandShading.h"
#include "truth/Parallel.h"

namespace fur::truth {

namespace {

// Whether skin shades a point is asked that far above it, model units, and skin counts that lies nearer to the light
// by that much: so the facets of the lit side do not shade themselves, and roots on the far side get no light.
constexpr float kSkinOffset = 0.01f, kSkinBias = 0.002f;
constexpr float kAllTheWay = 1e9f;
constexpr std::size_t kTubesAPiece = 1024;

hair::StrandLook lookOf(const Scene& scene) {
  const render::shared::FurBlock& c = scene.coat;
  return {.lambert = c.lambert, .specular = c.specular, .shininess = c.shininess, .dryShininess = c.dryShininess, .strandShadow = c.strandShadow,
          .occlusion = c.occlusion, .wetDarkening = c.wetDarkening, .wetGloss = c.wetGloss, .density = c.density};
}

Vec3 skyLight(const Scene& scene, const Vec3& normal) {
  const float upness = glm::dot(normal, Vec3(scene.frame.up));
  return glm::mix(Vec3(scene.frame.floorLight), Vec3(scene.frame.sky), 0.5f + 0.5f * upness);
}

// The share of the key light that comes to a node.
float keyAt(const Scene& scene, const hair::StrandLook& look, const TubeNode& node, const Vec3& tangent,
            const DeepShadow& shadow, Light light) {
  const float through = shareOfOneStrand(scene), nDotL = glm::dot(node.normal, Vec3(scene.frame.light));
  if (light == Light::Traced) {
    const float past = shadow.sharePastSkin(node.position + node.normal * kSkinOffset, kSkinBias);
    return past > 0 ? past * shadow.shareThrough(node.position, node.radius, tangent, through, kAllTheWay) : 0.0f;
  }
  const float rise = std::min(kLook, 1 - node.height) * scene.coat.furLength;
  const float lit = shadow.shareThrough(node.position, node.radius, tangent, through, rise / std::max(nDotL, float(FUR_LOWEST_LIGHT)));
  return hair::keyShare(look, node.height, nDotL, lit);
}

}  // namespace

float shareOfOneStrand(const Scene& scene) { return 1 - float(FUR_SHADE_OF_ONE) * scene.coat.strandShadow; }

std::vector<Vec3> shadeNodes(const Scene& scene, const Tubes& tubes, const DeepShadow& shadow, Light light) {
  const hair::StrandLook look = lookOf(scene);
  const Vec3 toLight(scene.frame.light), eye(scene.frame.eye);
  std::vector<Vec3> out(tubes.nodes.size());
  const auto shadeTube = [&](const Tube& tube) {
    const TubeNode* nodes = &tubes.nodes[tube.firstNode];
    for (std::uint32_t k = 0; k < tube.nodeCount; ++k) {
      const TubeNode& node = nodes[k];
      const Vec3 way = nodes[std::min(k + 1, tube.nodeCount - 1)].position - nodes[k > 0 ? k - 1 : 0].position;
      const Vec3 tangent = normalizeOr(way, node.normal), view = normalizeOr(eye - node.position, node.normal);
      const Vec3 albedo = hair::strandColor(Vec3(scene.coat.rootColors[0]), Vec3(scene.coat.tipColors[0]), node.height, tube.variance, scene.coat.typeVariance.x);
      const float share = keyAt(scene, look, node, tangent, shadow, light), nDotV = glm::dot(node.normal, view);
      hair::StrandLight lights;
      lights.key = Vec3(scene.frame.keyLight) * share;
      lights.through = lights.key * hair::rimLight(glm::dot(toLight, view), nDotV, node.height);
      lights.fill = scene.frame.fillLight;
      lights.rim = Vec3(scene.frame.backLight) * hair::fringe(nDotV, node.height);
      lights.sky = skyLight(scene, node.normal);
      out[tube.firstNode + k] = hair::shadeStrand(look, albedo, tangent, toLight, view, glm::dot(node.normal, toLight), nDotV,
                                                  node.height, 0, lights, tube.variance);
    }
  };
  inParallel((tubes.tubes.size() + kTubesAPiece - 1) / kTubesAPiece, [&](std::size_t piece) {
    const std::size_t end = std::min((piece + 1) * kTubesAPiece, tubes.tubes.size());
    for (std::size_t t = piece * kTubesAPiece; t < end; ++t) shadeTube(tubes.tubes[t]);
  });
  return out;
}

Vec3 shadeSkin(const Scene& scene, const Vec3& point, const Vec3& normal, float roots, const DeepShadow& shadow, Light light) {
  const hair::StrandLook look = lookOf(scene);
  const bool furry = roots > 0;
  const float nDotL = glm::dot(normal, Vec3(scene.frame.light));
  float share = 1;
  if (light == Light::Traced)
    share = shadow.sharePastSkin(point + normal * kSkinOffset, kSkinBias) * shadow.shareThrough(point, 0, normal, shareOfOneStrand(scene), kAllTheWay);
  else if (furry)
    share = glm::mix(1.0f, hair::furShadow(0, look.density, nDotL), look.strandShadow);
  const Vec3 albedo = Vec3(scene.coat.skinColor) * (1 - 0.5f * roots);
  const Vec3 color = albedo * (Vec3(scene.frame.keyLight) * (std::max(nDotL, 0.0f) * share) + skyLight(scene, normal));
  return color * (furry ? 1 - look.occlusion : 1.0f);
}

}  // namespace fur::truth
