// A surface as all share it who show the same model: it takes more memory, and longer to make, than anything else of a model.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "core/Result.h"
#include "core/SharedThings.h"
#include "geometry/Surface.h"
#include "geometry/SurfaceQuery.h"
#include "groom/Groom.h"

namespace fur::app {

class ShownSurface {
 public:
  ShownSurface(geometry::Surface surface = {});

  const geometry::Surface& operator*() const { return parts_->surface; }
  const geometry::Surface* operator->() const { return &parts_->surface; }
  // All made when first asked for: of the surface as it was made, its positions without duplicates, and how fur lies there by itself.
  const geometry::SurfaceQuery& query() const;
  const groom::SurfacePoints& points() const;
  const std::vector<Vec3>& naturalLie() const;

 private:
  friend class ModelShelf;
  struct Parts {
    geometry::Surface surface;
    std::optional<geometry::SurfaceQuery> query{};
    std::optional<groom::SurfacePoints> points{};
    std::optional<std::vector<Vec3>> lie{};
  };
  explicit ShownSurface(std::shared_ptr<Parts> parts) : parts_(std::move(parts)) {}

  std::shared_ptr<Parts> parts_;
};

using Pixels = std::shared_ptr<std::vector<std::uint8_t>>;  // never changed

// What models are made of that are shown in one program, as long as any of them is.
class ModelShelf {
 public:
  // As geometry::buildSurface(), unless there is one of such a mesh.
  Result<ShownSurface> surfaceOf(const geometry::Mesh& mesh, geometry::FurMapping mapping);

  // The same in steps of some milliseconds, with what is asked of a surface when it is shown. The shelf must outlive it.
  class Coming {
   public:
    Coming(ModelShelf& shelf, const geometry::Mesh& mesh, geometry::FurMapping mapping);
    // Whether that was the last. Not to be called after.
    bool step();
    Result<ShownSurface> take() { return std::move(*surface_); }

   private:
    ModelShelf* shelf_;
    std::uint64_t number_;
    std::optional<geometry::SurfaceBuilding> building_;
    std::optional<Result<ShownSurface>> surface_;
  };

  // The same pixels where another model has them already.
  Pixels pixels(std::vector<std::uint8_t> pixels);

 private:
  SharedThings surfaces_, pixels_;
};

}  // namespace fur::app
