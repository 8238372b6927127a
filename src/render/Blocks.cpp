#include "render/Blocks.h"

#include <algorithm>
#include <cmath>

#include "core/Srgb.h"
#include "render/Samples.h"
#include "render/StrandTables.h"
#include "render/passes/background/BackgroundPass.h"
#include "render/passes/ball/BallPass.h"
#include "render/passes/ground/GroundPass.h"
#include "settings/FurTypes.h"

namespace fur::render {

namespace {

// From this share of its densest layer up a coat keeps the light from its roots.
constexpr float kCrowdedDensity = 0.35f;
// What the key light and the rim light are at the settings' 1.
constexpr float kKeyLight = 2.2f, kRimLight = 2.4f;
// Of the fill light that much comes from all round, which skin gets, too.
constexpr float kFillAround = 0.25f;

void fillCamera(const Frame& frame, shared::FrameBlock& block) {
  const Mat4 modelFromWorld = glm::inverse(frame.worldFromModel);
  block.clipFromWorld = clipFromWorld(frame);
  block.clipFromModel = block.clipFromWorld * frame.worldFromModel;
  block.worldFromModel = frame.worldFromModel;
  block.eye = modelFromWorld * Vec4(frame.camera.eye, 1);
  block.up = modelFromWorld * Vec4(0, 1, 0, 0);
  block.pixelsPerUnit = pixelsPerUnit(frame);
  block.pictureHeight = static_cast<float>(frame.height);
  block.bottomRow = static_cast<float>(frame.bottomRow);
  block.exposure = frame.settings.exposure;
  block.viewLayer = frame.settings.viewLayer;
  block.stepLength = frame.stepLength;
  block.drawnShare = std::min(frame.pixelScale, 1.0f);
  block.finer = isFiner(frame) ? kSampleLevels : 0;
  block.chance = sampleChance(frame.sample);
  block.sampleShare = 1 / static_cast<float>(frame.flows ? std::min(frame.sample + 1, kFlowingSamples) : frame.sample + 1);
  block.transparent = frame.transparent;
}

void fillLights(const Frame& frame, shared::FrameBlock& block) {
  const settings::Settings& s = frame.settings;
  block.lightWorld = Vec4(lightDirection(frame), 0);
  block.light = glm::inverse(frame.worldFromModel) * block.lightWorld;
  block.lightIntensity = kKeyLight * s.lightIntensity;
  block.keyLight = Vec4(linearColor(s.keyColor) * block.lightIntensity, 1);
  block.fillLight = (1 - kFillAround) * s.fillLight;
  block.backLight = Vec4(linearColor(s.rimColor) * (kRimLight * s.rimLight), 1);
  // The surroundings light the fur with their own colour, half of it taken out.
  const Vec3 top = linearColor(s.backgroundTop), bottom = linearColor(s.backgroundBottom);
  const Vec3 around(kFillAround * s.fillLight);
  block.sky = Vec4(s.ambient * glm::mix(Vec3(0.75f), top, 0.5f) * linearColor(s.skyColor) + around, 1);
  block.floorLight = Vec4(s.ambient * 0.55f * glm::mix(Vec3(0.6f), bottom, 0.5f) * linearColor(s.groundColor) + around, 1);
}

void fillTypes(const Frame& frame, const FurDensities& densities, const TypePictures& pictures, shared::FurBlock& coat) {
  const Vec3 factor(frame.baseColorFactor);
  coat.densest = *std::max_element(densities.begin(), densities.end());
  // Strands by a preset's name are lit as those of type 1: all by the greatest density.
  bool asOne = false;
  for (int type = 1; type < FUR_TYPES; ++type) asOne |= densities[static_cast<std::size_t>(type)] > 0 && !settings::isOwn(frame.settings, type);
  coat.skinPicture = static_cast<float>(pictures[FUR_TYPES]);
  for (int type = 0; type < FUR_TYPES; ++type) {
    const auto index = static_cast<std::size_t>(type);
    const settings::Settings look = settings::drawnCoat(frame.settings, type);
    coat.rootColors[type] = Vec4(linearColor(look.rootColor) * factor, 1);
    coat.tipColors[type] = Vec4(linearColor(look.tipColor) * factor, 1);
    coat.skinColors[type] = Vec4(linearColor(look.skinColor) * factor, 1);
    coat.typeGrows[type] = densities[index] > 0;
    coat.typeVariance[type] = look.variance;
    coat.typeRise[type] = 1 / std::max(frame.typeHeights[index], 1e-6f);
    coat.typeDensity[type] = asOne && (type == 0 || !settings::isOwn(frame.settings, type)) ? coat.densest : densities[index];
    // Where few strands stand, they hardly darken each other and the skin.
    const float crowding = saturate(coat.typeDensity[type] / kCrowdedDensity);
    coat.typeShadow[type] = look.strandShadow * crowding;
    coat.typeOcclusion[type] = look.occlusion * crowding;
    coat.typeSpecular[type] = look.specular;
    coat.typeShininess[type] = look.shininess;
    coat.typeDryShininess[type] = dryShininess(look);
    coat.typePicture[type] = static_cast<float>(pictures[index]);
  }
}

void fillShading(const Frame& frame, shared::FurBlock& coat) {
  const settings::Settings& s = frame.settings;
  coat.lobePeak = 0.39894228f / strandLobeWidth(s);
  coat.lambert = s.lambert;
  coat.textureAmount = s.textureAmount;
  coat.wetDarkening = s.wetDarkening;
  coat.wetGloss = s.wetGloss;
}

}  // namespace

Vec3 lightDirection(const Frame& frame) {
  const Vec3 view = frame.camera.eye - frame.camera.target;
  const float yaw = frame.settings.lightYaw + (frame.settings.lightFollowsCamera ? std::atan2(view.x, view.z) : 0), pitch = frame.settings.lightPitch;
  return {std::sin(yaw) * std::cos(pitch), std::sin(pitch), std::cos(yaw) * std::cos(pitch)};
}

// Below two texels a pixel; a strand is some four texels wide.
bool chartsOverlap(const Frame& frame) {
  const float distance = glm::length(frame.camera.eye - frame.camera.target);
  return frame.settings.repeat * 256.0f * distance < 2.0f * pixelsPerUnit(frame);
}

shared::FrameBlock frameBlock(const Frame& frame) {
  shared::FrameBlock block{};
  fillCamera(frame, block);
  fillLights(frame, block);
  fillBackground(frame, block);
  fillGround(frame, block);
  fillBall(frame, block);
  return block;
}

shared::FurBlock furBlock(const Frame& frame, const furgen::CoatShape& shape, const FurDensities& densities, int maskSize, const TypePictures& pictures) {
  const settings::Settings& s = frame.settings;
  shared::FurBlock coat{};
  coat.furLength = frame.coatLength;
  coat.tilesPerUnit = s.repeat * 256.0f / static_cast<float>(shape.size);
  coat.layers = static_cast<float>(s.layers);
  coat.tileTexels = static_cast<float>(shape.size);
  coat.storedLayers = static_cast<float>(shape.layers);
  coat.strandShare = shape.sharesStrands ? 0.5f : 1.0f;
  coat.chartsOverlap = chartsOverlap(frame);
  coat.clumpShape = s.clumpShape;
  coat.layersLog = std::log(coat.layers);
  coat.clumpRadius = s.clumpSize;
  coat.maskTexels = static_cast<float>(maskSize);
  fillTypes(frame, densities, pictures, coat);
  fillShading(frame, coat);
  return coat;
}

}  // namespace fur::render
