#include <gtest/gtest.h>

#include "geometry/SurfaceChecks.h"
#include "geometry/Weld.h"

namespace fur::geometry {
namespace {

TEST(Mesh, FitsIntoTheUnitSphereAtAnySize) {
  for (const float size : {1e-20f, 1.0f, 1e30f}) {
    Mesh mesh = makeTorus(16, 8);
    for (Vec3& p : mesh.positions) p = p * size + Vec3(3, 4, 5) * size;
    fitToUnitSphere(mesh);
    float farthest = 0.0f;
    for (const Vec3& p : mesh.positions) farthest = std::max(farthest, glm::length(p));
    EXPECT_NEAR(farthest, 1.0f, 1e-5f) << size;
    const Bounds box = bounds(mesh);
    EXPECT_LT(glm::length(box.low + box.high), 1e-5f) << size;
  }
}

TEST(Mesh, LeavesASinglePointAtTheOrigin) {
  Mesh mesh;
  mesh.positions = {Vec3(5, 6, 7)};
  fitToUnitSphere(mesh);
  EXPECT_EQ(mesh.positions[0], Vec3(0));
}

TEST(Mesh, SharesNormalsAcrossUvSeams) {
  Mesh mesh = makeSphere();
  computeNormals(mesh);
  const Weld weld = weldPositions(mesh.positions);
  std::vector<Vec3> first(weld.count, Vec3(0));
  for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
    Vec3& known = first[weld.idOf[i]];
    if (known == Vec3(0)) known = mesh.normals[i];
    ASSERT_EQ(known, mesh.normals[i]);
  }
}

TEST(Mesh, WeldsMinusZeroWithZero) {
  const Weld weld = weldPositions({Vec3(0.0f, 1, 2), Vec3(-0.0f, 1, 2), Vec3(0.0f, 1, 2.0000002f)});
  EXPECT_EQ(weld.count, 2u);
  EXPECT_EQ(weld.idOf[0], weld.idOf[1]);
}

TEST(Primitives, FaceOutwards) {
  for (const Mesh& mesh : {makeSphere(), makeTorus(), makePlane()}) {
    for (std::size_t i = 0; i < mesh.indices.size(); i += 3) {
      const std::uint32_t* v = &mesh.indices[i];
      const Vec3 face = glm::cross(mesh.positions[v[1]] - mesh.positions[v[0]], mesh.positions[v[2]] - mesh.positions[v[0]]);
      for (int k = 0; k < 3; ++k) ASSERT_GT(glm::dot(face, mesh.normals[v[k]]), 0.0f);
    }
  }
}

TEST(Primitives, LieInTheUnitSphere) {
  for (const Mesh& mesh : {makeSphere(), makeTorus(), makePlane()}) {
    ASSERT_EQ(mesh.uv.size(), mesh.positions.size());
    for (const Vec3& p : mesh.positions) ASSERT_LE(glm::length(p), 1.000001f);
    for (const Vec3& n : mesh.normals) ASSERT_NEAR(glm::length(n), 1.0f, 1e-5f);
  }
}

}  // namespace
}  // namespace fur::geometry
