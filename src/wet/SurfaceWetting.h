// A droplet on the surface of a model. It wets all charts that it touches, with one clump centre in space, which each chart
// has in its own coordinates.
//
// The triangles round the droplet are grouped into sheets: triangles of one chart for which the droplet's centre, projected
// along the triangle's plane, lies at the same point of the atlas. A chart that meets itself along a seam (a globe cut at
// its date line) gives two sheets. A droplet is round on the skin, so it is an ellipse where the atlas is stretched.
// It is a ball in space: it wets what lies within its radius, and does not follow the skin round sharp bends.
#pragma once

#include <span>

#include "geometry/Surface.h"
#include "geometry/SurfaceQuery.h"
#include "wet/WetnessMask.h"

namespace fur::wet {

class SurfaceWetting {
 public:
  // Rasterises the charts at the mask's size (AtlasTexels.h). The surface and mask passed later must have the same triangles
  // and size. `bare`: one a triangle, those that take no water, as no fur grows there; empty: all take some.
  SurfaceWetting(const geometry::Surface& surface, int maskSize, std::span<const std::uint8_t> bare = {});

  // `centre` on the surface, radius in model units. Triangles whose normals face away from `normal` (the far side of a thin
  // ear) are skipped.
  void addDroplet(WetnessMask& mask, const geometry::Surface& surface, const geometry::SurfaceQuery& query,
                  const Vec3& centre, const Vec3& normal, float radius, float wetness) const;
  void dryAt(WetnessMask& mask, const geometry::Surface& surface, const geometry::SurfaceQuery& query,
             const Vec3& centre, const Vec3& normal, float radius, float amount) const;

  static constexpr std::uint16_t kNoChart = 0xffff;
  const std::vector<std::uint16_t>& chartOfTexel() const { return chartOfTexel_; }
  const geometry::AtlasTexels& atlas() const { return atlas_; }

  // A ball round a point of the surface as one chart has it: where the point lies in the atlas, and the scale there.
  struct Sheet {
    std::uint16_t chart;
    Vec2 centre;
    float area, scaledArea;
    Vec3 stretch;  // Face::stretch, times area
    float scale() const { return scaledArea / area; }
    // The Droplet::shape of a circle on the skin.
    Vec3 shape() const;
  };
  std::vector<Sheet> sheetsAt(const geometry::Surface& surface, const geometry::SurfaceQuery& query,
                              const Vec3& centre, const Vec3& normal, float radius) const;
  // The sheet of one triangle, extended along its plane. The triangle must have an area.
  Sheet sheetOf(const geometry::Surface& surface, std::uint32_t triangle, const Vec3& centre) const;

 private:
  // How a triangle maps space to the atlas: u = originU + dot(gradU, x), and v alike.
  struct Face {
    Vec3 gradU, gradV, normal;
    Vec2 origin;
    float area = 0;   // model units squared; 0 = degenerate, carries no water
    float scale = 0;  // atlas units per model unit
    Vec3 stretch{1, 0, 1};  // squared model units of a step (du, dv): x du^2 + 2 y du dv + z dv^2
  };
  static Face mapFace(const geometry::Surface& surface, std::size_t triangle);
  geometry::AtlasTexels atlas_;
  std::vector<Face> faces_;
  std::vector<std::uint16_t> chartOfTexel_;
};

}  // namespace fur::wet
