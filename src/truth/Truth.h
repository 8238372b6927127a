// The reference renderer: the picture that shells, fins, strips and ribbons stand in for. It draws every strand of the coat and of
// long hair on the model as a thin tapered tube, supersampled, in seconds on the CPU, without layers and textures.
//
//   FurMap         from the tile's volume to space: the mapping of the shells
//   Wetting        where water takes a strand
//   Strands        one tube for each strand of the coat wherever its root falls on the model
//   Hair           one tube for each strand of long hair, and light on it
//   DeepShadow     how many strands the light crosses on its way to a point
//   Shading        light on the tubes' nodes and on the skin
//   Raster         tubes and skin to a picture
//   Flip           how different two pictures look
//
// It reads the shaders' own uniform blocks, so that camera, light and coat are the same.
//
// Samples lie on a regular grid in each pixel and are averaged (a box filter) in linear light, before the tone
// curve; strands and skin are then blended over the background by their coverage, in linear light, too.
// The real-time picture is blended and resolved in sRGB, after the tone curve: where bright tips stand before dark
// gaps it is therefore a little darker.
//
// Does not do: drops, wet ground, the model's own picture (white), the ground and its shadow, light scattered from strand to strand. Back faces of the skin are not drawn, as in the real-time picture.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/Math.h"
#include "dynamics/BendField.h"
#include "furgen/Coat.h"
#include "geometry/Surface.h"
#include "hair/MemberStrands.h"
#include "hair/Wisps.h"
#include "shared/Blocks.h"
#include "wet/MaskTexels.h"

namespace fur::truth {

// What grows on one scalp, as it hangs.
struct LongHair {
  std::span<const hair::Wisp> wisps;
  std::span<const hair::MemberStrand> members;  // as many of each kind
  std::span<const hair::GuideNode> nodes;       // model space, guide after guide
  int nodesEach = 0;
  const hair::HairValues& values;
  std::span<const std::uint8_t> ambient{};  // hair/AmbientOcclusion.h; none: all light comes everywhere
  float occlusion = 0;                      // the setting hairOcclusion
};

// What is drawn. `frame` and `coat` are the shaders' uniform blocks (shared/Blocks.h); the layers in `coat` are not used.
struct Scene {
  const geometry::Surface& surface;
  const furgen::Coat& strands;
  std::span<const Vec4> bends;  // one a vertex (BendField::bends())
  render::shared::FrameBlock frame;
  render::shared::FurBlock coat;
  dynamics::BendCurve curve = dynamics::BendCurve::Arc;
  std::span<const LongHair> hair{};
  const wet::MaskTexels* mask = nullptr;  // all of it, as the shaders read it; none: dry fur
};

enum class Light {
  // The formulas of the shaders, except for `lit`: instead of their one look-up, the true share of light that strands leave on
  // that part of its way (Shading.h).
  Formula,
  // The key light's visibility is traced through all strands and the skin, instead of Sheppard's shadow, the body's clamp and
  // `lit`. Light from the sky is the same.
  Traced,
};

struct Options {
  Light light = Light::Formula;
  int samples = 8;           // along each side of a pixel
  int shadowTexels = 2048;   // along the side of the light's map, which covers model and fur
};

// Rows from the top, sRGB in 0..1 as it is shown.
struct Picture {
  int width = 0, height = 0;
  std::vector<Vec3> pixels;
};

Picture render(const Scene& scene, int width, int height, const Options& options = {});

// The largest coverage of any horizontal section of the coat: `density` of the coat block, for any number of layers.
float densestSection(const furgen::Coat& coat);

}  // namespace fur::truth
