#include "hair/StrandShading.h"

#include <algorithm>
#include <cmath>

namespace fur::hair {

namespace {
// sin of the angle whose cosine is `c`; rounding may carry |c| of unit vectors past 1.
float sineOf(float c) { return std::sqrt(std::max(1.0f - c * c, 0.0f)); }

// Water is as smooth on blunt fur as on sleek: what its film mirrors is no wider than at this exponent.
constexpr float kWaterShininess = 60;
// How far a sheet has closed when few of its strands glint: as far as one closes that is seen near to the eye (FUR_NEAR_SHEET).
constexpr float kFewGlint = 0.4f;
}  // namespace

float kajiyaDiffuse(const Vec3& tangent, const Vec3& light) { return sineOf(glm::dot(tangent, light)); }

float kajiyaSpecular(const Vec3& tangent, const Vec3& light, const Vec3& view, float exponent) {
  const float tl = glm::dot(tangent, light), tv = glm::dot(tangent, view);
  return kajiyaPower(sineOf(tl) * sineOf(tv) - tl * tv, exponent);
}

// pow(0, 0) is undefined in GLSL, whose twin this is.
float kajiyaPower(float cosine, float exponent) { return cosine > 0.0f ? std::pow(std::min(cosine, 1.0f), exponent) : 0.0f; }

float shiftedCosine(const Vec3& tangent, const Vec3& light, const Vec3& view, float shift) {
  const float tl = glm::dot(tangent, light), tv = glm::dot(tangent, view);
  const float sl = sineOf(tl), sv = sineOf(tv);
  return (sl * sv - tl * tv) * std::cos(shift) + (tl * sv + tv * sl) * std::sin(shift);
}

float kajiyaLobe(float cosine, float exponent) {
  float x = std::max(0.0f, 1.0f - exponent * (1.0f - cosine) / 8.0f);
  x *= x;
  x *= x;
  return x * x;
}

Vec2 lobeShifts(float strand) { return Vec2(-0.14f, 0.2f) + 0.3f * (strand - 0.5f); }

float rimLight(float lightDotView, float normalDotView, float height) {
  const float behind = std::max(-lightDotView, 0.0f), thin = saturate(1.0f - std::abs(normalDotView));
  return behind * behind * behind * behind * thin * thin * height;
}

float fringe(float normalDotView, float height) {
  const float edge = rimLight(-1, normalDotView, height);
  return edge * edge;
}

float furShadow(float height, float density, float nDotL) {
  const float f = 1.0f - saturate(nDotL);
  // Also where nothing stands to cast one.
  if (f <= 0.0f || density <= 0.0f) return 1.0f;
  return saturate((4.0f * height / density - 3.0f * f) / f);
}

float bodyShare(float nDotL) { return saturate(nDotL + 0.5f); }

float strandTilt(float strand, float height) { return 0.48f * std::abs(glm::fract(strand + 3 * height) - 0.5f) - 0.12f; }

float keyShare(const StrandLook& look, float height, float nDotL, float lit) {
  return lit * bodyShare(nDotL) * glm::mix(1.0f, furShadow(height, look.density, nDotL), look.strandShadow);
}

float glossShare(float nDotL) { return saturate(1.6f * nDotL + 0.6f); }

float whiteLobe(float wetness) {
  const float bare = 1 - std::min(wetness, 1.0f);
  return 0.09f + 0.61f * bare * bare * bare * bare;
}

Vec3 shadeStrand(const StrandLook& look, const Vec3& albedo, const Vec3& tangent, const Vec3& light, const Vec3& view,
                 float nDotL, float nDotV, float height, float wetness, const StrandLight& lights, float strand) {
  const float exponent = std::max(glm::mix(look.dryShininess, look.shininess, wetness), 1.0f);
  // A lobe's energy falls as its exponent rises; sqrt(p) keeps a strand's total about even.
  const float strength = look.specular * std::sqrt(exponent / look.shininess) * glossShare(nDotL);
  const Vec2 shifts = lobeShifts(strand);
  const auto lobe = [&](float shift, float p) { return kajiyaLobe(shiftedCosine(tangent, light, view, shift), p); };
  const Vec3 gloss = strength * lights.key * (whiteLobe(wetness) * lobe(shifts.x, exponent) + albedo * lobe(shifts.y, 0.5f * exponent));
  const float diffuse = glm::mix(kajiyaDiffuse(tangent, light), std::max(nDotL, 0.0f), look.lambert);
  const float filled = lights.fill * glm::mix(kajiyaDiffuse(tangent, view), std::max(nDotV, 0.0f), look.lambert);
  const Vec3 color = albedo * (lights.key * diffuse + 1.6f * lights.through + filled + lights.sky) + (albedo + 0.3f) * lights.rim + gloss;
  return color * occlusionFactor(height, look.occlusion) * strandDarkening(albedo, wetness, look.wetDarkening);
}

Vec3 printedLight(const StrandLook& look, const Vec3& albedo, const Vec3& key, const Vec3& around, float nDotL, float cosine, float height, float rho) {
  const float exponent = glm::mix(look.dryShininess, look.shininess, rho);
  const Vec3 color = albedo * (key * std::max(nDotL, 0.0f) + around) + key * (look.specular * kajiyaPower(cosine, exponent));
  return color * occlusionFactor(height, look.occlusion) * hair::wetDarkening(rho, look.wetDarkening);
}

Vec3 wetAlbedo(const Vec3& albedo, float wetness) {
  return glm::mix(albedo, albedo / glm::mix(Vec3(1.77f), Vec3(1.0f), albedo), wetness * (2 - wetness));
}

Vec3 wetCoatAlbedo(const Vec3& albedo, float wetness) {
  const Vec3 ofStrand = wetAlbedo(albedo, wetness);
  return ofStrand / (1.0f + 0.55f * wetness * (2 - wetness) * (1.0f - ofStrand) * ofStrand / (ofStrand + 0.08f));
}

Vec3 clumpNormal(const Vec2& outward, float sheet) {
  const float up = glm::mix(std::sqrt(std::max(1.0f - glm::dot(outward, outward), 0.0f)), 1.0f, sheet) + 0.25f;
  return glm::normalize(Vec3(outward * (1.0f - 0.85f * sheet), up));
}

float clumpShade(float facing, float risen, float keyed, float height, float wetness, float sheet) {
  const float held = std::min(wetness, 1.0f), clumps = held * (1 - 0.75f * sheet), shaded = 1 - keyed;
  const float turnedTo = glm::mix(glm::clamp(1.2f + 1.5f * risen, 0.3f, 2.1f), glm::clamp(0.6f + 0.8f * facing, 0.3f, 1.4f), keyed);
  const float around = shaded * (0.6f + 0.9f * shaded * shaded) - 0.3f * keyed;
  return glm::mix(1.0f, turnedTo, 0.7f * clumps) * glm::mix(1.0f, glm::smoothstep(-0.2f, 0.8f, height), 0.3f * clumps) * (1 + around * held * (2 - held)) *
         (1 - 0.16f * sheet * glm::smoothstep(0.3f, 0.85f, wetness));
}

Vec3 passedOn(float share, const Vec3& albedo) { return share / (1.0f - albedo * (1 - share)); }

float mirroredSky(float keyed) { return 1 + (1 - keyed) * (0.6f + 1.4f * (1 - keyed)); }

Vec2 waterGloss(const Vec3& tangent, const Vec3& n, const Vec3& light, const Vec3& view, float wetness, float sheet,
                float wetGloss, float exponent, float strand, float smoothness) {
  const Vec3 half = glm::normalize(light + view);
  const float away = 1 - saturate(glm::dot(n, view)), faces = std::max(glm::dot(n, half), 0.0f), slope = glm::dot(tangent, half);
  const float fresnel = 0.04f + 0.6f * away * away * away * away * away;
  const float shifted = slope + 0.5f * (1 - sheet) * (strand - 0.5f), few = std::min(sheet / kFewGlint, 1.0f);
  const float own = strand * strand * glm::mix(1.0f, strand * strand, few);
  const float water = smoothness * std::max(exponent, kWaterShininess);
  const float glint = kajiyaLobe(faces, 1.3f * water) * (1 - 0.7f * slope * slope) * (glm::mix(0.3f, 0.05f, few) + glm::mix(3.0f, 4.0f, few) * own) +
                      kajiyaLobe(sineOf(shifted), 5 * water) * faces * faces * (0.1f + glm::mix(1.2f, 2.1f, few) * own);
  const float film = std::min(wetness, 1.25f), wet = film * film * wetGloss;
  return wet * Vec2(smoothness * glossShare(light.z) * glint * glm::mix(1.0f, 0.5f, sheet), fresnel * glm::mix(0.5f, 0.1f + 3.0f * strand * strand, sheet));
}

Vec3 strandColor(const Vec3& root, const Vec3& tip, float height, float variance, float spread) {
  return glm::mix(root, tip, height) * (1.0f + spread * 1.3f * (variance - 0.5f));
}

Vec3 toneMap(const Vec3& linear, float exposure) {
  const Vec3 x = linear * exposure, over = glm::max(x - 0.6f, Vec3(0.0f));
  return glm::min(x, Vec3(0.6f)) + 0.4f * over / (over + 0.4f);
}

}  // namespace fur::hair
