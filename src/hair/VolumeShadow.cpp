#include "hair/VolumeShadow.h"

#include <algorithm>
#include <cmath>

namespace fur::hair {

float transmittance(float k, float sigma) { return std::exp(-k * sigma); }

float opacityLookup(std::span<const double> layerOpacities, float z, float dz) {
  if (layerOpacities.empty() || !(dz > 0)) return 0;
  const double at = std::clamp<double>(z / dz, 0, static_cast<double>(layerOpacities.size() - 1));
  double sum = 0;
  for (std::size_t i = 0; i < layerOpacities.size(); ++i)
    sum += layerOpacities[i] * std::max(0.0, 1 - std::abs(at - static_cast<double>(i)));
  return static_cast<float>(sum);
}

}  // namespace fur::hair
