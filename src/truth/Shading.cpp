#include "truth/Shading.h"

#include <cmath>

#include "shared/Wet.h"
#include "wet/Clump.h"

namespace fur::truth {

namespace {

// Whether skin shades a point is asked that far above it, model units, and skin counts that lies nearer to the light
// by that much: so the facets of the lit side do not shade themselves, and roots on the far side get no light.
constexpr float kSkinOffset = 0.01f, kSkinBias = 0.002f;
constexpr float kAllTheWay = 1e9f;

// The share of the key light that comes to a node, and that which what is next to it leaves (Formula).
struct Share {
  float key, lit;
};
Share keyAt(const Scene& scene, const hair::StrandLook& look, const TubeNode& node, float height, const Vec3& tangent, const Shadows& shadows, Light light) {
  if (light == Light::Traced) {
    const float share = shadows.onAllTheWay(scene, node, tangent);
    return {share, share};
  }
  const float nDotL = glm::dot(node.normal, Vec3(scene.frame.light)), rise = std::min(kLook, 1 - height) * scene.coat.furLength;
  float lit = shadows.coat.shareThrough(node.position, node.radius, tangent, shareOfOneStrand(scene), rise / std::max(nDotL, float(FUR_LOWEST_LIGHT)));
  lit *= shadows.throughHair(scene, node.position, node.radius, tangent);
  return {hair::keyShare(look, height, nDotL, lit), lit};
}

// From where that is the cosine to the way up.
Vec3 skyLight(const Scene& scene, float upness) { return glm::mix(Vec3(scene.frame.floorLight), Vec3(scene.frame.sky), 0.5f + 0.5f * upness); }

// The light `color` of a strand as that of one in a clump or in a sheet: clumpLight() of common_shading.glsl.
Vec3 wetLight(const Scene& scene, const hair::StrandLook& look, const Tube& tube, const TubeNode& node, float h, const Vec3& tangent, const Vec3& view, const Vec3& color, const Vec3& albedo, float lit) {
  const Wetness& water = tube.water;
  const Vec3 up = node.normal, right = normalizeOr(glm::cross(up, std::abs(up.y) < 0.9f ? Vec3(0, 1, 0) : Vec3(1, 0, 0)), Vec3(1, 0, 0)), on = glm::cross(up, right);
  const auto inFrame = [&](const Vec3& v) { return Vec3(glm::dot(v, right), glm::dot(v, on), glm::dot(v, up)); };
  const float sheet = water.sheet, held = std::min(water.held, 1.0f);
  const Vec3 light = inFrame(Vec3(scene.frame.light)), eye = inFrame(view), upwards = inFrame(Vec3(scene.frame.up)), along = inFrame(tangent);
  const Vec2 lies = Vec2(along) / std::max(glm::length(Vec2(along)), 1e-3f);
  const Vec3 n = glm::normalize(hair::clumpNormal(Vec2(inFrame(water.outward)), sheet) - Vec3(lies * (water.soaked * wet::liesBy(water.chance, tube.variance, water.shortness)), 0));
  const float clumps = held * (1 - 0.75f * sheet), number = static_cast<float>(FUR_WET_GLINTS) * tube.variance;
  const float keyed = lit * hair::glossShare(light.z), risen = glm::dot(n, upwards), above = 2 * glm::dot(n, eye) * risen - glm::dot(eye, upwards);
  Vec3 out = color * hair::passedOn(hair::clumpShade(glm::dot(n, light), risen - upwards.z, keyed, h, water.held, sheet), albedo);
  const Vec2 mirrored = hair::waterGloss(along, n, light, eye, water.held, sheet, look.wetGloss, look.shininess, number) * glm::mix(1.0f, h, clumps);
  out += 0.5f * held * hair::fringe(eye.z, h) * Vec3(scene.frame.backLight);
  return out + mirrored.x * lit * Vec3(scene.frame.keyLight) + mirrored.y * hair::mirroredSky(keyed) * skyLight(scene, above);
}

}  // namespace

float shareOfOneStrand(const Scene& scene) { return 1 - float(FUR_SHADE_OF_ONE) * scene.coat.typeShadow.x; }

hair::StrandLook lookOf(const Scene& scene) {
  const render::shared::FurBlock& c = scene.coat;
  return {.lambert = c.lambert, .specular = c.typeSpecular.x, .shininess = c.typeShininess.x, .dryShininess = c.typeDryShininess.x, .strandShadow = c.typeShadow.x,
          .occlusion = c.typeOcclusion.x, .wetDarkening = c.wetDarkening, .wetGloss = c.wetGloss, .density = c.typeDensity.x};
}

Vec3 skyLight(const Scene& scene, const Vec3& normal) { return skyLight(scene, glm::dot(normal, Vec3(scene.frame.up))); }

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
      const float height = node.height * wet::litLower(tube.water.held);
      Vec3 albedo = hair::strandColor(Vec3(scene.coat.rootColors[0]), Vec3(scene.coat.tipColors[0]), node.height, tube.variance, scene.coat.typeVariance.x);
      const auto [share, lit] = keyAt(scene, look, node, height, tangent, shadows, light);
      const float nDotV = glm::dot(node.normal, view), rho = std::min(tube.water.held, 1.0f);
      if (rho > 0) albedo = hair::wetCoatAlbedo(albedo, rho);
      hair::StrandLight lights;
      lights.key = Vec3(scene.frame.keyLight) * share;
      lights.through = lights.key * hair::rimLight(glm::dot(toLight, view), nDotV, height);
      lights.fill = scene.frame.fillLight;
      lights.rim = Vec3(scene.frame.backLight) * hair::fringe(nDotV, height);
      lights.sky = skyLight(scene, node.normal);
      out[k] = hair::shadeStrand(look, albedo, tangent, toLight, view, glm::dot(node.normal, toLight), nDotV, height, rho, lights, tube.variance);
      if (rho > 0) out[k] = wetLight(scene, look, tube, node, height, tangent, view, out[k], albedo, lit);
    }
  });
  return out;
}

Vec3 shadeSkin(const Scene& scene, const Vec3& point, const Vec3& normal, float roots, float held, const Shadows& shadows, Light light) {
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
  const float rho = std::min(held, 1.0f), height = furry ? static_cast<float>(FUR_WET_SKIN_HEIGHT) * rho : 1.0f;
  return color * hair::occlusionFactor(height, look.occlusion) * hair::wetDarkening(rho, look.wetDarkening);
}

}  // namespace fur::truth
