#include "hair/Marschner.h"

#include <algorithm>
#include <cmath>

namespace fur::hair {

namespace {

constexpr int kPaths = 128;          // rays over the strand's width: 0.05 apart in phi at most
constexpr float kSmoothing = 0.05f;  // standard deviation in phi, radians: as wide as rays are apart

// The strand in the plane across it, for one theta_d.
struct Section {
  float etaAcross, etaAlong;  // Bravais: eta' for the perpendicular, eta'' for the parallel part
  float cosInside;            // cos theta_t: rays run askew inside as well

  Section(float thetaD, float eta) {
    // At 90 degrees light runs along the strand and eta' is infinite.
    const float sine = std::sin(thetaD), cosine = std::max(std::abs(std::cos(thetaD)), 1e-3f);
    const float root = std::sqrt(std::max(eta * eta - sine * sine, 1e-6f));
    etaAcross = root / cosine;
    etaAlong = eta * eta * cosine / root;
    cosInside = root / eta;
  }

  // Of unpolarised light that meets the strand at gamma_i; inside, at gamma_t, the same share.
  float fresnel(float cosOutside, float cosWithin) const {
    cosOutside = std::max(cosOutside, 1e-6f);
    const float across = (cosOutside - etaAcross * cosWithin) / (cosOutside + etaAcross * cosWithin);
    const float along = (etaAlong * cosOutside - cosWithin) / (etaAlong * cosOutside + cosWithin);
    return 0.5f * (across * across + along * along);
  }
};

// A ray that meets the strand at gamma_i (sin gamma_i = h: Halen's arctan is a slip).
struct Path {
  float turn;    // phi(p, h) = 2 p gamma_t - 2 gamma_i + p pi
  float energy;  // 1/2 A(p, h) dh, without absorption
  float way;     // once through, in diameters
};

Path pathOf(const Section& s, int p, int i) {
  const float step = kPi / kPaths, gamma = -0.5f * kPi + (static_cast<float>(i) + 0.5f) * step;
  const float cosine = std::cos(gamma),
              inside = std::asin(std::clamp(std::sin(gamma) / s.etaAcross, -1.0f, 1.0f));
  const float f = s.fresnel(cosine, std::cos(inside)), n = static_cast<float>(p);
  const float attenuation = (1 - f) * (1 - f) * (p == 2 ? f : 1.0f);
  return {2 * n * inside - 2 * gamma + n * kPi, 0.5f * attenuation * cosine * step,
          std::cos(inside) / s.cosInside};
}

// A normal distribution of the angle between two directions round the strand.
float near(float phi) {
  phi -= 2 * kPi * std::round(phi / (2 * kPi));
  if (std::abs(phi) > 5 * kSmoothing) return 0;
  return marschnerM(phi, 0, kSmoothing);
}

// R has one root, gamma_i = -phi / 2, and |2 dphi/dh| = 4 / cos gamma_i.
float reflected(const Section& s, float phi) {
  const float half = 0.5f * (phi - 2 * kPi * std::round(phi / (2 * kPi)));
  const float cosine = std::max(std::cos(half), 0.0f), sine = std::sin(half) / s.etaAcross;
  return 0.25f * cosine * s.fresnel(cosine, std::sqrt(std::max(1 - sine * sine, 0.0f)));
}

Vec4 texelN(const std::vector<Path>& once, const std::vector<Path>& twice, const Section& s, float phi) {
  Vec4 n(reflected(s, phi), 0, 0, 0);
  float through = 0, way = 0;
  for (std::size_t i = 0; i < once.size(); ++i) {
    const float a = once[i].energy * near(phi - once[i].turn),
                b = twice[i].energy * near(phi - twice[i].turn);
    n += Vec4(0, a, b, 0);
    through += a + b;
    way += (a + b) * once[i].way;
  }
  n.w = through > 1e-6f ? way / through : 1.0f;
  return n;
}

// 0..1 over the texel centres.
float at(int i, int count) { return static_cast<float>(i) / static_cast<float>(count - 1); }

float gaussian(float thetaH, float alpha, float beta) {
  const float x = (thetaH - alpha) / beta;
  return std::exp(-0.5f * x * x);
}

}  // namespace

float lobeWidth(float exponent) {
  return glm::clamp(0.5f / std::sqrt(std::max(exponent, 1.0f)), 0.07f, 0.35f);
}

float marschnerM(float thetaH, float alpha, float beta) {
  return gaussian(thetaH, alpha, beta) / (beta * std::sqrt(2 * kPi));
}

float marschnerN(int p, float thetaD, float phiD, float eta, float absorption) {
  const Section s(thetaD, eta);
  if (p == 0) return reflected(s, phiD);
  if (p < 0 || p > 2) return 0;
  float sum = 0;
  for (int i = 0; i < kPaths; ++i) {
    const Path path = pathOf(s, p, i);
    sum +=
        path.energy * near(phiD - path.turn) * std::exp(-absorption * 2 * static_cast<float>(p) * path.way);
  }
  return sum;
}

Vec3 marschnerStrand(const Vec3& albedo, const Vec3& tangent, const Vec3& light, const Vec3& view,
                     float width, float sharpen) {
  const float sinI = glm::dot(tangent, light), sinR = glm::dot(tangent, view);
  const float thetaI = std::asin(glm::clamp(sinI, -1.0f, 1.0f)),
              thetaR = std::asin(glm::clamp(sinR, -1.0f, 1.0f));
  const float cosines = std::sqrt(std::max((1 - sinI * sinI) * (1 - sinR * sinR), 1e-6f));
  const float phi = std::acos(glm::clamp((glm::dot(light, view) - sinI * sinR) / cosines, -1.0f, 1.0f));
  const float thetaD = 0.5f * (thetaR - thetaI), cosD = std::max(std::cos(thetaD), kLeastCosine);
  Vec3 sum(0);
  for (int p = 0; p < 3; ++p) {
    const float m =
        marschnerM(0.5f * (thetaI + thetaR), kLobeShift[p], width * kLobeWidth[p] / std::sqrt(sharpen));
    for (int c = 0; c < 3; ++c) {
      const float absorption = -0.25f * std::log(std::max(albedo[c], 1e-4f));
      sum[c] += m * marschnerN(p, thetaD, phi, kStrandEta, absorption);
    }
  }
  return sum * (0.5f * kPi * std::cos(thetaI) / (cosD * cosD));
}

std::vector<Vec4> strandTableM(float width) {
  std::vector<Vec4> texels;
  for (int y = 0; y < kStrandTableM; ++y)
    for (int x = 0; x < kStrandTableM; ++x) {
      const float thetaI = std::asin(2 * at(x, kStrandTableM) - 1),
                  thetaR = std::asin(2 * at(y, kStrandTableM) - 1);
      Vec4 texel(0, 0, 0, std::max(std::cos(0.5f * (thetaR - thetaI)), 0.0f));
      for (int p = 0; p < 3; ++p)
        texel[p] = gaussian(0.5f * (thetaI + thetaR), kLobeShift[p], width * kLobeWidth[p]);
      texels.push_back(texel);
    }
  return texels;
}

std::vector<Vec4> strandTableN() {
  std::vector<Vec4> texels;
  std::vector<Path> once(kPaths), twice(kPaths);
  for (int y = 0; y < kStrandTableN.y; ++y) {
    const float cosD = at(y, kStrandTableN.y), least = std::max(cosD, kLeastCosine);
    const Section s(std::acos(cosD), kStrandEta);
    for (int i = 0; i < kPaths; ++i) {
      once[static_cast<std::size_t>(i)] = pathOf(s, 1, i);
      twice[static_cast<std::size_t>(i)] = pathOf(s, 2, i);
    }
    for (int x = 0; x < kStrandTableN.x; ++x) {
      const Vec4 n = texelN(once, twice, s, std::acos(2 * at(x, kStrandTableN.x) - 1));
      texels.push_back(Vec4(Vec3(n) / (least * least), n.w));
    }
  }
  return texels;
}

}  // namespace fur::hair
