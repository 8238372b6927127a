// Light on the tubes and on the skin, before the tone curve.
#pragma once

#include <algorithm>
#include <vector>

#include "hair/StrandShading.h"
#include "shared/Light.h"
#include "truth/DeepShadow.h"
#include "truth/Parallel.h"
#include "truth/Strands.h"
#include "truth/Truth.h"

namespace fur::truth {

// For Light::Formula: the shaders' `lit` is replaced by the true share of light that strands leave on the last part of its way,
// which rises by this share of the coat's height, as the shaders' look-up does (shell.frag, lightOn()). Shadow from above that
// is Sheppard's formula.
inline constexpr float kLook = float(FUR_SHADE_RISE);

// The share of light that one strand lets through: 1 - FUR_SHADE_OF_ONE times the setting strandShadow, as in shell.frag.
float shareOfOneStrand(const Scene& scene);

// What keeps the key light off.
struct Shadows {
  const DeepShadow& coat;            // and the skin's
  const DeepShadow* hair = nullptr;  // none without long hair

  // The share of light that long hair lets through to a place of a strand.
  float throughHair(const Scene& scene, const Vec3& point, float radius, const Vec3& tangent) const;
  // That which skin, coat and long hair leave on all of its way.
  float onAllTheWay(const Scene& scene, const TubeNode& node, const Vec3& tangent) const;
};

hair::StrandLook lookOf(const Scene& scene);
Vec3 skyLight(const Scene& scene, const Vec3& normal);
// Of a node by its number; unit.
Vec3 tangentAt(const Tubes& tubes, const Tube& tube, std::uint32_t node);
// work(tube) once for each, in any order, on all processors.
template <class Work>
void forTubes(const Tubes& tubes, const Work& work) {
  constexpr std::size_t kTubesAPiece = 1024;
  inParallel((tubes.tubes.size() + kTubesAPiece - 1) / kTubesAPiece, [&](std::size_t piece) {
    const std::size_t end = std::min((piece + 1) * kTubesAPiece, tubes.tubes.size());
    for (std::size_t t = piece * kTubesAPiece; t < end; ++t) work(tubes.tubes[t]);
  });
}

// Linear light from each node of the coat to the eye.
std::vector<Vec3> shadeNodes(const Scene& scene, const Tubes& tubes, const Shadows& shadows, Light light);

// Linear light from a point of the skin to the eye; diffuse. Pores are averaged: `roots` is the share of the skin that roots
// cover, `held` how wet it is.
Vec3 shadeSkin(const Scene& scene, const Vec3& point, const Vec3& normal, float roots, float held, const Shadows& shadows, Light light);

}  // namespace fur::truth
