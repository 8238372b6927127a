#include "truth/Flip.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/Srgb.h"
#include "truth/Parallel.h"

namespace fur::truth {

namespace {

// Linear sRGB to CIE XYZ and back (IEC 61966-2-1); the white point is the picture of (1, 1, 1).
const Mat3 kXyzFromLinear = glm::transpose(Mat3(10135552.0 / 24577794, 8788810.0 / 24577794, 4435075.0 / 24577794,
                                                2613072.0 / 12288897, 8788810.0 / 12288897, 887015.0 / 12288897,
                                                1425312.0 / 73733382, 8788810.0 / 73733382, 70074185.0 / 73733382));
const Mat3 kLinearFromXyz = glm::inverse(kXyzFromLinear);
const Vec3 kWhite = kXyzFromLinear * Vec3(1);

// YCxCz (3.1): the linear version of CIELAB, in which filters keep the mean.
Vec3 yccFromLinear(const Vec3& linear) {
  const Vec3 r = kXyzFromLinear * linear / kWhite;
  return {116 * r.y - 16, 500 * (r.x - r.y), 200 * (r.y - r.z)};
}
Vec3 linearFromYcc(const Vec3& ycc) {
  const float y = (ycc.x + 16) / 116;
  return kLinearFromXyz * (Vec3(y + ycc.y / 500, y, y - ycc.z / 200) * kWhite);
}

Vec3 labFromLinear(const Vec3& linear) {
  const Vec3 r = kXyzFromLinear * linear / kWhite;
  constexpr float kEdge = 6.0f / 29;
  Vec3 f;
  for (int k = 0; k < 3; ++k) f[k] = r[k] > kEdge * kEdge * kEdge ? std::cbrt(r[k]) : r[k] / (3 * kEdge * kEdge) + 4.0f / 29;
  return {116 * f.y - 16, 500 * (f.x - f.y), 200 * (f.y - f.z)};
}

// The Hunt effect (4.1.2): colours of dark pixels differ less.
Vec3 huntLab(const Vec3& linear) {
  const Vec3 lab = labFromLinear(linear);
  return {lab.x, lab.y * 0.01f * lab.x, lab.z * 0.01f * lab.x};
}

// HyAB (4.1.3): made for large differences.
float hyab(const Vec3& a, const Vec3& b) { return std::abs(a.x - b.x) + std::hypot(a.y - b.y, a.z - b.z); }

// A filter that is the product of one along rows and one along columns.
struct Taps {
  std::vector<float> weights;  // an odd number, the middle at the pixel
  int reach() const { return static_cast<int>(weights.size() / 2); }
};

template <class Law>
Taps tapsOf(int reach, const Law& law) {
  Taps taps;
  for (int i = -reach; i <= reach; ++i) taps.weights.push_back(law(static_cast<float>(i)));
  return taps;
}

using Plane = std::vector<float>;

// Beyond the edge the outermost pixels go on.
Plane filtered(const Plane& in, int width, int height, const Taps& across, const Taps& down) {
  Plane half(in.size()), out(in.size());
  inParallel(static_cast<std::size_t>(height), [&](std::size_t row) {
    for (int x = 0; x < width; ++x) {
      float sum = 0;
      for (int k = -across.reach(); k <= across.reach(); ++k)
        sum += across.weights[static_cast<std::size_t>(k + across.reach())] * in[row * static_cast<std::size_t>(width) + static_cast<std::size_t>(std::clamp(x + k, 0, width - 1))];
      half[row * static_cast<std::size_t>(width) + static_cast<std::size_t>(x)] = sum;
    }
  });
  inParallel(static_cast<std::size_t>(height), [&](std::size_t row) {
    for (std::size_t x = 0; x < static_cast<std::size_t>(width); ++x) {
      float sum = 0;
      for (int k = -down.reach(); k <= down.reach(); ++k) {
        const auto from = static_cast<std::size_t>(std::clamp(static_cast<int>(row) + k, 0, height - 1));
        sum += down.weights[static_cast<std::size_t>(k + down.reach())] * half[from * static_cast<std::size_t>(width) + x];
      }
      out[row * static_cast<std::size_t>(width) + x] = sum;
    }
  });
  return out;
}

// Contrast sensitivity (4.1.1, table 1): a sum of two Gaussians for each channel,
// g(x) = a1 sqrt(pi/b1) exp(-pi^2 x^2/b1) + the same with a2, b2; x in degrees.
struct Sensitivity {
  float a1, b1, a2, b2;
};
constexpr Sensitivity kSensitivity[3] = {{1, 0.0047f, 0, 1e-5f}, {1, 0.0053f, 0, 1e-5f}, {34.1f, 0.04f, 13.5f, 0.025f}};

Plane seen(const Plane& in, int width, int height, const Sensitivity& s, float perDegree) {
  const int reach = static_cast<int>(std::ceil(3 * std::sqrt(std::max(s.b1, s.b2) / (2 * kPi * kPi)) * perDegree));
  Plane out(in.size(), 0.0f);
  float total = 0;
  for (const auto& [a, b] : {std::pair(s.a1, s.b1), std::pair(s.a2, s.b2)}) {
    if (a == 0) continue;
    const Taps taps = tapsOf(reach, [&, b = b](float i) { return std::exp(-kPi * kPi * (i / perDegree) * (i / perDegree) / b); });
    float sum = 0;
    for (const float w : taps.weights) sum += w;
    const float weight = a * std::sqrt(kPi / b);
    total += weight * sum * sum;
    const Plane part = filtered(in, width, height, taps, taps);
    for (std::size_t i = 0; i < out.size(); ++i) out[i] += weight * part[i];
  }
  for (float& value : out) value /= total;
  return out;
}

struct Planes {
  std::array<Plane, 3> ycc;
};

Planes planesOf(const Picture& picture) {
  Planes out;
  for (Plane& plane : out.ycc) plane.resize(picture.pixels.size());
  for (std::size_t i = 0; i < picture.pixels.size(); ++i) {
    const Vec3 ycc = yccFromLinear(decodeSrgb(picture.pixels[i]));
    for (std::size_t k = 0; k < 3; ++k) out.ycc[k][i] = ycc[static_cast<int>(k)];
  }
  return out;
}

// What the eye makes of a picture's colours.
std::vector<Vec3> seenColors(const Planes& planes, int width, int height, float perDegree) {
  Planes blurred;
  for (std::size_t k = 0; k < 3; ++k) blurred.ycc[k] = seen(planes.ycc[k], width, height, kSensitivity[k], perDegree);
  std::vector<Vec3> out(planes.ycc[0].size());
  for (std::size_t i = 0; i < out.size(); ++i) {
    const Vec3 ycc(blurred.ycc[0][i], blurred.ycc[1][i], blurred.ycc[2][i]);
    out[i] = huntLab(glm::clamp(linearFromYcc(ycc), 0.0f, 1.0f));
  }
  return out;
}

// 4.1.4: the differences of most pairs get most of the range. Below pc of the greatest, pt of the range.
float redistributed(float difference) {
  constexpr float kExponent = 0.7f, kPc = 0.4f, kPt = 0.95f;
  static const float greatest = std::pow(hyab(huntLab(Vec3(0, 1, 0)), huntLab(Vec3(0, 0, 1))), kExponent);
  const float d = std::pow(difference, kExponent), knee = kPc * greatest;
  if (d < knee) return kPt / knee * d;
  return std::min(kPt + (d - knee) / (greatest - knee) * (1 - kPt), 1.0f);
}

// Weights above 0 sum to 1, those below to -1.
Taps balanced(Taps taps) {
  float above = 0, below = 0;
  for (const float w : taps.weights) (w > 0 ? above : below) += std::abs(w);
  for (float& w : taps.weights) w /= w > 0 ? above : below;
  return taps;
}

// 4.2: how strong edges (first derivatives) and points (second derivatives) are at every pixel.
struct Features {
  Plane edges, points;
};

Features featuresOf(const Plane& y, int width, int height, float perDegree) {
  constexpr float kWidth = 0.082f;  // degrees
  const float sigma = 0.5f * kWidth * perDegree;
  const int reach = static_cast<int>(std::ceil(3 * sigma));
  const auto gauss = [&](float i) { return std::exp(-i * i / (2 * sigma * sigma)); };
  Taps smooth = tapsOf(reach, gauss);
  float sum = 0;
  for (const float w : smooth.weights) sum += w;
  for (float& w : smooth.weights) w /= sum;
  const Taps edge = balanced(tapsOf(reach, [&](float i) { return -i * gauss(i); }));
  const Taps point = balanced(tapsOf(reach, [&](float i) { return (i * i / (sigma * sigma) - 1) * gauss(i); }));
  Plane flat(y.size());
  for (std::size_t i = 0; i < y.size(); ++i) flat[i] = (y[i] + 16) / 116;
  const auto strength = [&](const Taps& taps) {
    Plane across = filtered(flat, width, height, taps, smooth);
    const Plane down = filtered(flat, width, height, smooth, taps);
    for (std::size_t i = 0; i < across.size(); ++i) across[i] = std::hypot(across[i], down[i]);
    return across;
  };
  return {strength(edge), strength(point)};
}

float featureDifference(const Features& a, const Features& b, std::size_t i) {
  const float greater = std::max(std::abs(a.edges[i] - b.edges[i]), std::abs(a.points[i] - b.points[i]));
  return std::sqrt(std::min(greater / std::sqrt(2.0f), 1.0f));
}

}  // namespace

Difference flip(const Picture& reference, const Picture& test, float pixelsPerDegree) {
  FUR_ASSERT(reference.width == test.width && reference.height == test.height, "truth::flip()", "pictures of one size", test.width);
  const int width = reference.width, height = reference.height;
  const Planes a = planesOf(reference), b = planesOf(test);
  const std::vector<Vec3> colorsA = seenColors(a, width, height, pixelsPerDegree), colorsB = seenColors(b, width, height, pixelsPerDegree);
  const Features featuresA = featuresOf(a.ycc[0], width, height, pixelsPerDegree);
  const Features featuresB = featuresOf(b.ycc[0], width, height, pixelsPerDegree);
  Difference out{width, height, {}, 0};
  double sum = 0;
  for (std::size_t i = 0; i < colorsA.size(); ++i) {
    const float color = redistributed(hyab(colorsA[i], colorsB[i]));
    out.map.push_back(std::pow(color, 1 - featureDifference(featuresA, featuresB, i)));  // 4.3
    sum += out.map.back();
  }
  out.mean = static_cast<float>(sum / static_cast<double>(std::max<std::size_t>(out.map.size(), 1)));
  return out;
}

std::vector<Vec3> labOf(const Picture& picture) {
  std::vector<Vec3> out;
  for (const Vec3& pixel : picture.pixels) out.push_back(labFromLinear(decodeSrgb(pixel)));
  return out;
}

Picture heatPicture(const Difference& difference) {
  // Five evenly spaced colours of the map "magma" (S. van der Walt and N. Smith 2015).
  static const Vec3 kStops[] = {{0, 0, 4}, {81, 18, 124}, {183, 55, 121}, {252, 137, 97}, {252, 253, 191}};
  Picture out{difference.width, difference.height, {}};
  for (const float value : difference.map) {
    const float at = 4 * saturate(value);
    const int below = std::min(static_cast<int>(at), 3);
    out.pixels.push_back(glm::mix(kStops[below], kStops[below + 1], at - static_cast<float>(below)) / 255.0f);
  }
  return out;
}

}  // namespace fur::truth
