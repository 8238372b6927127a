#include "geometry/CubeMapping.h"

#include <algorithm>

#include "geometry/Adjacency.h"

namespace fur::geometry {

namespace {

constexpr int kNoFace = -1;

// Below this (89 degrees) a triangle has hardly any area on the face.
constexpr float kTurnedAway = 0.02f;

// Faces are +x, -x, +y, -y, +z, -z.
float facing(const Vec3& normal, int face) { return (face & 1 ? -1.0f : 1.0f) * normal[face / 2]; }

// Eq. 4.2 for planes across the axes: the face with the smallest t > 0.
int faceAlong(const Vec3& p, const Vec3& normal, float low, float high) {
  int best = kNoFace;
  float nearest = 0.0f;
  for (int face = 0; face < 6; ++face) {
    const float towards = facing(normal, face);
    if (!(towards > 0.0f)) continue;
    const float away = face & 1 ? p[face / 2] - low : high - p[face / 2];
    const float t = away / towards;
    if (best != kNoFace && t >= nearest) continue;
    best = face;
    nearest = t;
  }
  return best;
}

int bestFace(const Vec3& normal) {
  int best = 0;
  for (int face = 1; face < 6; ++face)
    if (facing(normal, face) > facing(normal, best)) best = face;
  return best;
}

// Eq. 4.3 and 4.4, right-handed as seen from outside.
Vec2 onFace(const Vec3& p, int face, float low) {
  const Vec3 q = p - low;
  switch (face) {
    case 0: return {-q.z, q.y};
    case 1: return {q.z, q.y};
    case 2: return {q.x, -q.z};
    case 3: return {q.x, q.z};
    case 4: return {q.x, q.y};
    default: return {-q.x, q.y};
  }
}

std::vector<int> facesOf(const Mesh& mesh, float low, float high) {
  std::vector<int> faces;
  faces.reserve(mesh.triangleCount());
  for (std::size_t i = 0; i < mesh.indices.size(); i += 3) {
    const std::uint32_t* v = &mesh.indices[i];
    const Vec3 normal = normalizeOr(glm::cross(mesh.positions[v[1]] - mesh.positions[v[0]],
                                               mesh.positions[v[2]] - mesh.positions[v[0]]), mesh.normals[v[0]]);
    int face = faceAlong(mesh.positions[v[0]], mesh.normals[v[0]], low, high);
    for (int k = 1; k < 3; ++k)
      if (faceAlong(mesh.positions[v[k]], mesh.normals[v[k]], low, high) != face) face = kNoFace;
    if (face == kNoFace || facing(normal, face) < kTurnedAway) face = bestFace(normal);
    faces.push_back(face);
  }
  return faces;
}

}  // namespace

Charts cubeCharts(const Mesh& mesh, const std::vector<std::uint32_t>& across) {
  const Bounds box = bounds(mesh);
  const float low = std::min({box.low.x, box.low.y, box.low.z}), high = std::max({box.high.x, box.high.y, box.high.z});
  const std::vector<int> faces = facesOf(mesh, low, high);
  Charts charts;
  charts.chartOf = connectedPieces(across, [&](std::uint32_t t, std::size_t, std::uint32_t other) {
    return faces[other] == faces[t];
  }, charts.count);
  charts.corners.reserve(mesh.indices.size());
  for (std::size_t i = 0; i < mesh.indices.size(); ++i)
    charts.corners.push_back(onFace(mesh.positions[mesh.indices[i]], faces[i / 3], low));
  return charts;
}

}  // namespace fur::geometry
