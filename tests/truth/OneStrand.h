// Small worlds for the tests of the reference renderer: a square of skin, coats of a few strands, a camera.
#pragma once

#include <gtest/gtest.h>

#include <vector>

#include "truth/Truth.h"

namespace fur::test {

// A square in the plane y = `y` from -half to half, which faces +y. Its fur coordinates are (x, z).
inline geometry::Surface square(float half = 1, float y = 0) {
  geometry::Surface surface;
  for (const auto& [x, z] : {std::pair(-half, -half), {-half, half}, {half, half}, {half, -half}}) {
    geometry::SurfaceVertex v{};
    v.position = {x, y, z};
    v.normal = {0, 1, 0};
    v.fur = {x, z};
    surface.vertices.push_back(v);
  }
  surface.trueVertexCount = 4;
  surface.indices = surface.furIndices = {0, 1, 2, 0, 2, 3};
  return surface;
}

// A coat of a tile of 256 texels from the nodes of each strand, all rooted at `root`.
inline furgen::Coat coatOf(Vec2 root, const std::vector<std::vector<furgen::Node>>& strands) {
  furgen::Coat coat;
  coat.parameters.size = 256;
  for (const auto& nodes : strands) {
    coat.strands.push_back({root, 1, 1, 0.5f, static_cast<std::uint32_t>(coat.nodes.size()), static_cast<std::uint32_t>(nodes.size())});
    coat.nodes.insert(coat.nodes.end(), nodes.begin(), nodes.end());
  }
  return coat;
}

// An upright strand that thins from 8 texels to 2.
inline std::vector<furgen::Node> upright() { return {{Vec2(0), 0, 8}, {Vec2(0), 0.5f, 5}, {Vec2(0), 1, 2}}; }

// Camera and light of a frame: model space is the world.
inline render::shared::FrameBlock frameFrom(const Vec3& eye, const Vec3& target, const Vec3& upwards, int width, int height) {
  constexpr float kFovY = 0.6f;
  render::shared::FrameBlock block{};
  block.clipFromModel = block.clipFromWorld =
      glm::perspective(kFovY, static_cast<float>(width) / static_cast<float>(height), 0.1f, 20.0f) * glm::lookAt(eye, target, upwards);
  block.worldFromModel = Mat4(1);
  block.eye = Vec4(eye, 1);
  block.pixelsPerUnit = static_cast<float>(height) / (2 * std::tan(kFovY / 2));
  block.light = Vec4(glm::normalize(Vec3(1, 2, 1)), 0);
  block.lightIntensity = 2;
  block.keyLight = Vec4(2, 2, 2, 1);
  block.up = Vec4(0, 1, 0, 0);
  block.exposure = 1;
  block.sky = block.floorLight = Vec4(0.3f);
  block.backgroundTop = block.backgroundBottom = Vec4(0, 0, 1, 1);
  return block;
}

inline render::shared::FurBlock furOf(float length, float tiles) {
  render::shared::FurBlock block{};
  block.furLength = length;
  block.tilesPerUnit = tiles;
  block.layers = block.storedLayers = 16;
  block.tileTexels = 256;
  block.densest = block.typeDensity.x = 0.4f;
  block.rootColors[0] = block.tipColors[0] = Vec4(0.5f, 0.3f, 0.1f, 1);
  block.skinColors[0] = Vec4(0.1f, 0.6f, 0.1f, 1);
  block.typeVariance.x = 1;
  block.lambert = 0.4f;
  block.typeSpecular.x = 0.2f;
  block.typeShininess.x = 60;
  block.typeDryShininess.x = 12;
  block.typeShadow.x = 0.6f;
  block.typeOcclusion.x = 0.2f;
  block.clumpShape = 0.6f;
  block.wetDarkening = 0.4f;
  block.wetGloss = 0.8f;
  block.maskTexels = 256;
  return block;
}

inline std::vector<Vec4> straight(const geometry::Surface& surface) { return std::vector<Vec4>(surface.vertices.size(), Vec4(0)); }

inline Vec2 pixelOf(const render::shared::FrameBlock& frame, const Vec3& p, int width, int height) {
  const Vec4 clip = frame.clipFromModel * Vec4(p, 1);
  return Vec2(0.5f + 0.5f * clip.x / clip.w, 0.5f - 0.5f * clip.y / clip.w) * Vec2(width, height);
}

}  // namespace fur::test
