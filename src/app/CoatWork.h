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

// What the settings ask the generator for. Fewer layers than asked for, and a warning, where the tile would
// take more than 192 MiB on the GPU.
furgen::FurParameters furParameters(const settings::Settings& settings, Warnings* warnings = nullptr);

// Whether everything but the generator's settings is the same: nothing to draw anew before the coat is there.
bool differOnlyInCoat(const settings::Settings& a, settings::Settings b);

// A coat that can be drawn: grown from settings, or read from a type set.
class DrawnCoat {
 public:
  DrawnCoat() = default;
  DrawnCoat(furgen::Coat grown, std::vector<float> coverage);
  explicit DrawnCoat(furgen::FurVolume volume);

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
  const furgen::FurVolume* volume() const { return volume_ ? &*volume_ : nullptr; }

 private:
  furgen::Coat grown_;
  std::optional<furgen::FurVolume> volume_;
  std::vector<float> coverage_;
};

class CoatWork {
 public:
  explicit CoatWork(const furgen::FurParameters& parameters);

  // Some milliseconds of work; returns whether the coat is whole and in the picture. Not to be called after.
  bool step(render::Renderer& renderer);
  float progress() const;  // 0..1
  DrawnCoat take();

 private:
  furgen::FurParameters parameters_;
  furgen::CoatGrower grower_;
  std::unique_ptr<furgen::Coat> coat_;  // stays where it is: the painter looks at it
  std::optional<furgen::LayerPainter> painter_;
  furgen::LayerMaps maps_;
  int nextLayer_ = 0;
  bool painted_ = false;  // maps_ holds the next layer
  std::vector<float> coverage_;
};

}  // namespace fur::app
