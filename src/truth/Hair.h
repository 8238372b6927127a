// Long hair in the reference: every member strand of every wisp as a tube.
#pragma once

#include <vector>

#include "truth/Shading.h"

namespace fur::truth {

// Of all scalps. A node's normal is the skin's at the root, its height 0 at the wisp's root to 1 at its tip.
Tubes placeHair(const Scene& scene);

// Linear light from each node to the eye: the formulas of hair.frag, but for `lit`, which is the share of light that skin, coat and
// hair leave on all of its way.
std::vector<Vec3> shadeHair(const Scene& scene, const Tubes& tubes, const Shadows& shadows, Light light);

}  // namespace fur::truth
