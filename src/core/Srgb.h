// sRGB (IEC 61966-2-1), 0..1 a channel. The shaders have fits of both ways: within 0.0015 and 0.003.
#pragma once

#include <cstdint>

#include "core/Math.h"

namespace fur {

Vec3 encodeSrgb(const Vec3& linear);
Vec3 decodeSrgb(const Vec3& srgb);
// Of a colour 0xRRGGBB in sRGB.
Vec3 linearColor(std::uint32_t srgb);

}  // namespace fur
