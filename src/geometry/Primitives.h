// Models made by code. All are inside the unit sphere, with normals and uv.
#pragma once

#include "geometry/Mesh.h"

namespace fur::geometry {

Mesh makeSphere(int around = 72, int down = 36);
Mesh makeTorus(int around = 72, int across = 32, float tubeRadius = 0.36f);
// Lies in the plane y = 0, faces +y.
Mesh makePlane(int cells = 24);

}  // namespace fur::geometry
