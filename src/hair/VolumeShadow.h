// Light that goes through fur as through a mist (Halen & Wester 2007, 3.3.2 and 5.7).
#pragma once

#include <span>

namespace fur::hair {

// T = exp(-k sigma), Eq. 3.1: of opacity sigma on the way, or of a way through even fur (the depth-difference
// map).
float transmittance(float k, float sigma);

// sigma(z) = sum over i of sigma(z_i) max(0, 1 - |z - z_i| / dz) with z_i = i dz: the opacity that lies
// before z, from that before each layer (Halen leaves the max() out where the weights are defined). Before
// the first layer it is the first's, behind the last the last's; 0 without layers or for dz <= 0.
float opacityLookup(std::span<const double> layerOpacities, float z, float dz);

}  // namespace fur::hair
