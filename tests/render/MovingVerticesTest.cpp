// Vertices that follow a skin which changes its shape.
#include "render/MovingVertices.h"

#include <gtest/gtest.h>

#include <cmath>
#include <optional>
#include <vector>

#include "geometry/SurfaceChecks.h"

namespace fur::render {
namespace {

// A level sheet that is rolled round the axis z, `bend` the angle for each unit: up at its rims below 0.
struct Sheet {
  Sheet() : surface(geometry::built(geometry::makePlane())) {
    roll(0);
    std::vector<SkinVertex> vertices;
    for (std::size_t i = 0; i < surface.vertices.size(); ++i) vertices.push_back({Vec4(positions[i], 0), Vec4(normals[i], 0), Vec4(tangents[i], 0), Vec3(0, 0, 1)});
    moving.emplace(std::move(vertices), tangents, surface.indices);
  }
  void roll(float bend) {
    positions.clear(), normals.clear(), tangents.clear();
    for (const geometry::SurfaceVertex& v : surface.vertices) {
      const float angle = bend * v.position.x, sine = std::sin(angle), cosine = std::cos(angle);
      positions.push_back(bend == 0 ? v.position : Vec3(sine / bend, (cosine - 1) / bend, v.position.z));
      normals.emplace_back(sine, cosine, 0);
      tangents.emplace_back(cosine, -sine, 0);
    }
  }
  Vec3 curvature(std::size_t i) const { return {moving->vertices()[i].position.w, moving->vertices()[i].normal.w, moving->vertices()[i].gradS.w}; }

  geometry::Surface surface;
  std::vector<Vec3> positions, normals, tangents;
  std::optional<MovingVertices> moving;
};

TEST(MovingVertices, CurveMoreWhereTheSkinBendsOutwardsAndAsTheyDidWhereItFolds) {
  Sheet sheet;
  sheet.roll(1.2f);
  sheet.moving->follow({sheet.positions, sheet.normals, sheet.tangents});
  for (std::size_t i = 0; i < sheet.positions.size(); ++i) ASSERT_LT(glm::length(sheet.curvature(i) - Vec3(1.2f, 0, 0)), 0.02f);
  EXPECT_LT(glm::distance(Vec3(sheet.moving->vertices()[5].gradS), sheet.tangents[5]), 1e-5f);
  sheet.roll(-1.2f);
  sheet.moving->follow({sheet.positions, sheet.normals, sheet.tangents});
  for (std::size_t i = 0; i < sheet.positions.size(); ++i) ASSERT_LT(glm::length(sheet.curvature(i)), 1e-3f);
  sheet.roll(0);
  sheet.moving->follow({sheet.positions, sheet.normals, sheet.tangents});
  for (std::size_t i = 0; i < sheet.positions.size(); ++i) ASSERT_LT(glm::length(sheet.curvature(i)), 1e-4f);
}

}  // namespace
}  // namespace fur::render
