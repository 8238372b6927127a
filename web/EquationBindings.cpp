// The formula sheet with plain numbers in and out: the same functions that the program runs.
#include "Boundary.h"
#include "dynamics/BendField.h"
#include "hair/StrandShading.h"

using namespace fur;

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
