// The formula sheet: equations of the papers with plain numbers in and out. They are the functions that the program runs, or
// the tested twins of what its shaders run, but for three, which it has in forms of its own: transmittance and opacity
// (common_furshadow.glsl), and the shift of a clump, which the program has as clumpPull(). Some run in the technique `shells` alone:
// finOpacity, and as the settings of these names say kajiyaSpecular (printedLobe), clumpDisplacement (printedClumps) and printedLight.
#include "web/Boundary.h"
#include "dynamics/BendField.h"
#include "furgen/Coat.h"
#include "furgen/FinOpacity.h"
#include "furgen/Strand.h"
#include "hair/Marschner.h"
#include "hair/Springs.h"
#include "hair/StrandShading.h"
#include "hair/VolumeShadow.h"
#include "wet/Clump.h"

using namespace fur;

FUR_EXPORT double fur_eqClumpProfile(float h, float w, float layers) { return wet::clumpProfile(h, w, layers); }
FUR_EXPORT double fur_eqClumpShift(float h, float w, float layers, float rho) {
  return wet::clumpShift(h, w, layers, rho);
}
FUR_EXPORT double fur_eqClumpDisplacement(float h, float w, float layers, float rho) {
  return wet::clumpDisplacement(h, w, layers, rho);
}
FUR_EXPORT double fur_eqFinOpacity(float facing, float across) { return furgen::finOpacity(facing, across); }
FUR_EXPORT double fur_eqPrintedLight(float color, float specular, float nDotL, float cosine, float p, float h, float rho, float sigmaOcc, float sigmaWet,
                                     float sigmaSpec) {
  const hair::StrandLook look{.specular = specular, .shininess = p, .dryShininess = hair::wetSpecularExponent(p, 0, sigmaSpec),
                              .occlusion = sigmaOcc, .wetDarkening = sigmaWet};
  return hair::printedLight(look, Vec3(color), Vec3(1), Vec3(0), nDotL, cosine, h, rho).x;
}
FUR_EXPORT double fur_eqWetSpecularExponent(float p, float rho, float sigmaSpec) {
  return hair::wetSpecularExponent(p, rho, sigmaSpec);
}
FUR_EXPORT double fur_eqOcclusionFactor(float h, float sigmaOcc) { return hair::occlusionFactor(h, sigmaOcc); }
FUR_EXPORT double fur_eqWetDarkening(float rho, float sigmaWet) { return hair::wetDarkening(rho, sigmaWet); }
FUR_EXPORT double fur_eqStrandThinning(float s, float taper) { return furgen::strandThinning(s, taper); }
FUR_EXPORT double fur_eqStrandRadius(float thickness) { return furgen::meanRadius(thickness); }
FUR_EXPORT double fur_eqStrandCount(float density, float thickness, int size) {
  furgen::FurParameters p;
  p.density = density;
  p.thickness = thickness;
  p.size = size;
  return furgen::wantedStrands(furgen::clampedParameters(p));
}
FUR_EXPORT int fur_eqStrandExists(float h, float presence, float dominance) {
  return furgen::strandExists(h, presence, dominance) ? 1 : 0;
}
FUR_EXPORT const double* fur_eqArcBend(float theta, float t) {
  const Vec2 bend = dynamics::arcBend(theta, t);
  return web::numbers({bend.x, bend.y});
}
FUR_EXPORT const double* fur_eqWindBend(float force, float t) {
  const Vec2 bend = dynamics::windBend(force, t);
  return web::numbers({bend.x, bend.y});
}
FUR_EXPORT double fur_eqKajiyaDiffuse(float tx, float ty, float tz, float lx, float ly, float lz) {
  return hair::kajiyaDiffuse({tx, ty, tz}, {lx, ly, lz});
}
FUR_EXPORT double fur_eqKajiyaSpecular(float tx, float ty, float tz, float lx, float ly, float lz, float vx, float vy,
                                       float vz, float exponent) {
  return hair::kajiyaSpecular({tx, ty, tz}, {lx, ly, lz}, {vx, vy, vz}, exponent);
}
FUR_EXPORT double fur_eqFurShadow(float height, float density, float nDotL) {
  return hair::furShadow(height, density, nDotL);
}
FUR_EXPORT double fur_eqMarschnerM(float thetaH, float alpha, float beta) {
  return hair::marschnerM(thetaH, alpha, beta);
}
FUR_EXPORT double fur_eqMarschnerN(int p, float thetaD, float phiD, float eta, float absorption) {
  return hair::marschnerN(p, thetaD, phiD, eta, absorption);
}
FUR_EXPORT double fur_eqTransmittance(float k, float sigma) { return hair::transmittance(k, sigma); }
FUR_EXPORT double fur_eqOpacityLookup(const double* layers, int count, float z, float dz) {
  return hair::opacityLookup({layers, static_cast<std::size_t>(count)}, z, dz);
}
FUR_EXPORT const double* fur_eqVerletStep(float px, float py, float pz, float qx, float qy, float qz, float ax, float ay, float az,
                                           float damping, float dt) {
  const Vec3 next = hair::verletStep(Vec3(px, py, pz), Vec3(qx, qy, qz), Vec3(ax, ay, az), damping, dt);
  return web::numbers({next.x, next.y, next.z});
}
FUR_EXPORT double fur_eqSpringStiffness(float k, float distance, float c, int a) { return hair::springStiffness(k, distance, c, a); }
FUR_EXPORT double fur_eqTiltStiffness(float k, float alpha, float zDotZh) { return hair::tiltStiffness(k, alpha, zDotZh); }
