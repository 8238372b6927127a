// A surface that another program takes as bytes instead of making it.
#include <gtest/gtest.h>

#include "geometry/Primitives.h"
#include "geometry/SurfaceBytes.h"
#include "geometry/SurfaceChecks.h"

namespace fur::geometry {
namespace {

// With hard edges, over which fur leans: vertices are inserted there.
Mesh facetedMesh() {
  Mesh mesh;
  mesh.positions = {{0, 0.8f, 0}, {-0.6f, -0.4f, 0.5f}, {0.6f, -0.4f, 0.5f}, {0, -0.4f, -0.7f}};
  mesh.indices = {0, 1, 2, 0, 2, 3, 0, 3, 1, 1, 3, 2};
  return mesh;
}

TEST(SurfaceBytes, GiveTheSurfaceBack) {
  for (const Mesh& mesh : {makeSphere(), facetedMesh()}) {
    const Surface made = built(mesh);
    const auto bytes = surfaceBytes(made);
    const auto read = surfaceFromBytes(bytes, mesh);
    ASSERT_TRUE(read);
    EXPECT_EQ(read->inserted.size(), made.inserted.size());
    EXPECT_EQ(surfaceBytes(*read), bytes);
  }
}

TEST(SurfaceBytes, ThatEndEarlyGoOnOrLeadElsewhereAreNone) {
  const Mesh mesh = makeSphere();
  Surface surface = built(mesh);
  auto bytes = surfaceBytes(surface);
  EXPECT_FALSE(surfaceFromBytes({}, mesh));
  EXPECT_FALSE(surfaceFromBytes(std::span(bytes).first(bytes.size() - 1), mesh));
  bytes.push_back(0);
  EXPECT_FALSE(surfaceFromBytes(bytes, mesh));
  EXPECT_FALSE(surfaceFromBytes(surfaceBytes(surface), facetedMesh()));
  surface.furIndices[5] = static_cast<std::uint32_t>(surface.vertices.size());
  EXPECT_FALSE(surfaceFromBytes(surfaceBytes(surface), mesh));
}

}  // namespace
}  // namespace fur::geometry
