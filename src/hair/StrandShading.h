// Light on one strand, as plain numbers: the C++ twins of what the shaders do.
// T is the unit tangent root to tip; L and V point away from the strand, towards light and eye.
#pragma once

#include "core/Math.h"

namespace fur::hair {

// sin(T, L), Kajiya & Kay 1989.
float kajiyaDiffuse(const Vec3& tangent, const Vec3& light);
// max(0, sin(T,L) sin(T,V) - (T.L)(T.V))^p. The printed forms (Halen 3.2.1, Silva Eq. 3) have L the
// way the light travels; this peaks on the cone T.V = -T.L (Sheppard Eq. 2.4).
float kajiyaSpecular(const Vec3& tangent, const Vec3& light, const Vec3& view, float exponent);
// Sheppard Eq. 3.3-3.4: F = 1 - N.L, S = clamp((4 h / d - 3 F) / F); F = 0 casts no shadow: 1.
float furShadow(float height, float density, float nDotL);

}  // namespace fur::hair
