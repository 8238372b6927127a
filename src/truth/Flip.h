// How different two pictures look: FLIP (Andersson, Nilsson, Akenine-Moller, Oskarsson, Astrom, Fairchild 2020,
// "FLIP: A Difference Evaluator for Alternating Images", Proc. ACM CGIT 3(2)), for pictures in sRGB. It predicts the difference
// that a person sees when flipping between the two on a screen. Section numbers are the paper's.
#pragma once

#include <vector>

#include "truth/Truth.h"

namespace fur::truth {

// The paper's screen: 0.7 m away, 3840 pixels on 0.7 m.
inline constexpr float kPixelsPerDegree = 67.0f;

struct Difference {
  int width = 0, height = 0;
  std::vector<float> map;  // 0..1, rows from the top
  float mean = 0;
};

// Both pictures have the same size.
Difference flip(const Picture& reference, const Picture& test, float pixelsPerDegree = kPixelsPerDegree);

// CIELAB (1976, D65) of every pixel: lightness 0..100, then a and b.
std::vector<Vec3> labOf(const Picture& picture);

// The map in colours from black (0) over violet and orange to a light yellow (1), as the paper shows it.
Picture heatPicture(const Difference& difference);

}  // namespace fur::truth
