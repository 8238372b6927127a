// Light on the tubes and on the skin, before the tone curve.
#pragma once

#include <vector>

#include "shared/Light.h"
#include "truth/DeepShadow.h"
#include "truth/Strands.h"
#include "truth/Truth.h"

namespace fur::truth {

// For Light::Formula: the shaders' `lit` is replaced by the true share of light that strands leave on the last part of its way,
// which rises by this share of the coat's height, as the shaders' look-up does (shell.frag, lightOn()). Shadow from above that
// is Sheppard's formula.
inline constexpr float kLook = float(FUR_SHADE_RISE);

// The share of light that one strand lets through: 1 - FUR_SHADE_OF_ONE times the setting strandShadow, as in shell.frag.
float shareOfOneStrand(const Scene& scene);

// Linear light from each node to the eye.
std::vector<Vec3> shadeNodes(const Scene& scene, const Tubes& tubes, const DeepShadow& shadow, Light light);

// Linear light from a point of the skin to the eye; diffuse. Pores are averaged: `roots` is the share of the skin that roots
// cover.
Vec3 shadeSkin(const Scene& scene, const Vec3& point, const Vec3& normal, float roots, const DeepShadow& shadow, Light light);

}  // namespace fur::truth
