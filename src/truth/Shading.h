// Light on the tubes and on the skin, before the tone curve.
#pragma once

#include <vector>

#include "truth/DeepShadow.h"
#include "truth/Strands.h"
#include "truth/Truth.h"

namespace fur::truth {

// Light::Formula puts in place of the shaders' `lit` the share that strands leave on the last part of the way, which
// rises this part of the coat's height: the height of the shaders' own look (shell.frag, kRise). What lies
// above is Sheppard's formula's.
inline constexpr float kLook = 0.1f;

// The share of light that one strand lets through: 1 - 0.65 strand shadow, what shell.frag takes off at most.
float shareOfOneStrand(const Scene& scene);

// Linear light from every node to the eye.
std::vector<Vec3> shadeNodes(const Scene& scene, const Tubes& tubes, const DeepShadow& shadow, Light light);

// Linear light from a point of the skin to the eye; it scatters the same to all sides. The pores are those of a
// picture in which single roots cannot be told: `roots` is the share of the skin that they cover.
Vec3 shadeSkin(const Scene& scene, const Vec3& point, const Vec3& normal, float roots, const DeepShadow& shadow, Light light);

}  // namespace fur::truth
