// The coat that is drawn, and the one that is on its way: grown, cut into layers and uploaded in slices
// of a few milliseconds, so that the picture never waits.
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "furgen/Coat.h"
#include "furgen/Layers.h"
#include "furgen/TilePicture.h"
#include "render/Renderer.h"
#include "settings/Settings.h"

namespace fur::app {

// What the settings ask the generator for, one a fur type; `types` has a bit for each that the groom has
// anywhere. Density 0 where one is bald or nowhere; the last, unless it is the only one, has strands.
// Fewer layers than asked for, and a warning, where they would take more than 192 MiB on the GPU.
using CoatParameters = std::vector<furgen::FurParameters>;
CoatParameters coatParameters(const settings::Settings& settings, unsigned types, Warnings* warnings = nullptr);

// Whether everything but the generator's settings is the same: nothing to draw anew before the coat is there.
bool differOnlyInCoat(const settings::Settings& a, settings::Settings b);

using GivenCoat = std::shared_ptr<const furgen::FurVolume>;

// The coat of type 1 that is drawn: grown from settings, or read from a type set.
class DrawnCoat {
 public:
  DrawnCoat() = default;
  DrawnCoat(furgen::Coat grown, std::vector<float> coverage);
  DrawnCoat(GivenCoat volume, std::vector<float> coverage);

  int layers() const;
  int size() const;
  int strandCount() const;
  float weight() const;
  const std::vector<float>& coverage() const { return coverage_; }  // a share for each layer
  furgen::TilePicture tilePicture(int layer, furgen::TileChannel channel) const;
  furgen::TilePicture finPicture(furgen::TileChannel channel) const;
  // nullptr: it was read, or there is none yet.
  const furgen::Coat* grown() const { return volume_ || layers() == 0 ? nullptr : &grown_; }
  // nullptr: it was grown.
  const furgen::FurVolume* volume() const { return volume_.get(); }

 private:
  furgen::Coat grown_;
  GivenCoat volume_;
  std::vector<float> coverage_;
};

class CoatWork {
 public:
  // `given`, if any, is the coat of type 1; the others follow its size and layers.
  CoatWork(CoatParameters types, GivenCoat given);

  // Some milliseconds of work; returns whether the coat is whole and in the picture. Not to be called after.
  bool step(render::Renderer& renderer);
  float progress() const;  // 0..1
  DrawnCoat take() { return std::move(first_); }

 private:
  enum class Stage { Grow, Fin, Paint, Upload };

  std::size_t type() const { return densities_.size(); }
  bool isGiven() const { return given_ && type() == 0; }
  // Whether that was the last.
  bool finishType(render::Renderer& renderer);

  CoatParameters types_;
  GivenCoat given_;
  DrawnCoat first_;
  std::vector<float> densities_;  // of the types that are whole
  // The type at work, and its layer.
  Stage stage_ = Stage::Grow;
  std::optional<furgen::CoatGrower> grower_;
  std::unique_ptr<furgen::Coat> coat_;  // stays where it is: the painter looks at it
  std::optional<furgen::LayerPainter> painter_;
  furgen::LayerMaps maps_;
  std::vector<float> coverage_;  // of the layers that are uploaded
};

}  // namespace fur::app
