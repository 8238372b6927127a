// The reference renderer: the picture that shells and fins stand in for. It draws every strand of the coat on the
// model as a thin tapered tube, supersampled, in seconds on the CPU. It knows no layers, no textures, no slabs.
//
//   FurMap         where a point of the tile's volume stands in space: the map that the shells carry out
//   Strands        one tube for every strand of the coat wherever its root falls on the model
//   DeepShadow     how many strands the light crosses on its way to a point
//   Shading        light on the tubes' nodes and on the skin
//   Raster         tubes and skin to a picture
//   Flip           how far two pictures look alike
//
// It reads the very uniform blocks of the shaders, so that camera, light and coat are the same by construction.
//
// Samples lie on a regular grid in each pixel and are averaged (a box filter) in linear light, before the tone
// curve; the share of the pixel that strands and skin cover is then laid over the background, in linear light too.
// The real-time picture is blended and resolved in sRGB, after the tone curve: where bright tips stand before dark
// gaps it comes out a little darker for it.
//
// Does not do: wet fur (it stands as if dry), the model's own picture (white), the ground and its shadow, light that
// goes from strand to strand. Skin that faces away is not drawn, as in the real-time picture.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/Math.h"
#include "dynamics/BendField.h"
#include "furgen/Coat.h"
#include "geometry/Surface.h"
#include "shared/Blocks.h"

namespace fur::truth {

// What is drawn. Everything is only looked at. `frame` and `coat` hold the numbers that the shaders are given
// (shared/Blocks.h); of `coat` the layers are not read.
struct Scene {
  const geometry::Surface& surface;
  const furgen::Coat& strands;
  std::span<const Vec4> bends;  // one a vertex: model space, radians, across the normal (dynamics/BendField.h)
  render::shared::FrameBlock frame;
  render::shared::FurBlock coat;
  dynamics::BendCurve curve = dynamics::BendCurve::Arc;
};

enum class Light {
  // The formulas of the shaders. Only `lit`, for which they take one look into the texture, is the true share that
  // strands leave on the part of the way to the light that this look stands for (Shading.h).
  Formula,
  // The key light's visibility is traced all the way through the strands and the skin, in place of Sheppard's
  // shadow, the body's clamp and `lit`. Light of the sky stays what it is.
  Traced,
};

struct Options {
  Light light = Light::Formula;
  int samples = 8;           // along each side of a pixel
  int shadowTexels = 2048;   // along the side of the map of the light, which takes in model and fur
};

// Rows from the top, sRGB in 0..1 as it is shown.
struct Picture {
  int width = 0, height = 0;
  std::vector<Vec3> pixels;
};

Picture render(const Scene& scene, int width, int height, const Options& options = {});

// The share that strands cover of that horizontal section of the coat where they cover most: `density` of the coat
// block, for as many layers as one likes.
float densestSection(const furgen::Coat& coat);

}  // namespace fur::truth
