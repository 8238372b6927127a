// A droplet on the surface of a model: wets every chart that it touches, with one clump centre in
// space (each chart sees it in its own coordinates).
//
// The triangles round the droplet are gathered into sheets: those of one chart that agree where in
// the atlas the droplet's centre lies, each carrying it there along its own plane. A chart that meets
// itself along a seam (a globe cut at its date line) so gives two sheets. A droplet is round on the skin: in an
// atlas that stretches it is an ellipse. Does not follow water
// round sharp bends: a droplet is a ball, and wets what it touches.
#pragma once

#include "geometry/Surface.h"
#include "geometry/SurfaceQuery.h"
#include "wet/WetnessMask.h"

namespace fur::wet {

class SurfaceWetting {
 public:
  // Takes the charts at the mask's size, with their gutters (AtlasTexels.h). The surface and mask given
  // later must be of the same triangles and size.
  SurfaceWetting(const geometry::Surface& surface, int maskSize);

  // `centre` on the surface, radius in model units. Charts whose normals face away from `normal`
  // (the far side of a thin ear) stay as they are. No triangle within the radius: nothing happens.
  void addDroplet(WetnessMask& mask, const geometry::Surface& surface, const geometry::SurfaceQuery& query,
                  const Vec3& centre, const Vec3& normal, float radius, float wetness) const;
  void dryAt(WetnessMask& mask, const geometry::Surface& surface, const geometry::SurfaceQuery& query,
             const Vec3& centre, const Vec3& normal, float radius, float amount) const;

  static constexpr std::uint16_t kNoChart = 0xffff;
  const std::vector<std::uint16_t>& chartOfTexel() const { return chartOfTexel_; }
  const geometry::AtlasTexels& atlas() const { return atlas_; }

  // One view of a ball round a point of the surface: a chart, where the point lies in it, and how large a model unit
  // is there.
  struct Sheet {
    std::uint16_t chart;
    Vec2 centre;
    float area, scaledArea;
    Vec3 stretch;  // Face::stretch, times area
    float scale() const { return scaledArea / area; }
    // Droplet::shape of what is round on the skin.
    Vec3 shape() const;
  };
  std::vector<Sheet> sheetsAt(const geometry::Surface& surface, const geometry::SurfaceQuery& query,
                              const Vec3& centre, const Vec3& normal, float radius) const;
  // As one triangle alone sees it, carried on along its plane. Not of a triangle without area.
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
