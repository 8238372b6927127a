// The coat's fur types on the GPU. A new coat comes in pieces while the one before stays in the picture.
#pragma once

#include <memory>
#include <span>
#include <vector>

#include "furgen/Packing.h"
#include "gl/Objects.h"
#include "render/Blocks.h"

namespace fur::render {

class FurTextures {
 public:
  // What setLayer() and setFin() fill from now on; drops what came since the last show().
  void begin(const furgen::CoatShape& shape);
  // Both return the bytes that were uploaded. Of layers without strands (CoatShape::hasStrands()) levels may have their coverage alone.
  std::size_t setLayer(int type, int layer, std::span<const furgen::PackedLevel> levels);
  std::size_t setFin(int type, std::span<const furgen::PackedLevel> levels);
  // What has come takes the place of what is shown. One density a type, the others are bald.
  void show(std::span<const float> densities);
  // In place of what is shown, and beside what comes: one texel, bald at density 0.
  void showTexel(float density);
  // Likewise that of another renderer in the same context.
  struct Coat;
  void show(std::shared_ptr<Coat> coat);
  const std::shared_ptr<Coat>& shown() const { return shown_; }
  // `wet`: with the streaks, which are made the first time.
  void bind(bool wet);

  const furgen::CoatShape& shape() const { return shown_->shape; }
  const FurDensities& densities() const { return shown_->densities; }
  float density() const;  // of the densest type; 0: all are bald
  // Another number whenever other fur is shown.
  unsigned long revision() const { return revision_; }
  // Of what several share, a share.
  std::size_t bytes() const;

  // Layers of type after type; of the fin maps one a type.
  struct Coat {
    gl::Texture coverage{}, strand{}, offset{}, finCoverage{}, finStrand{};
    furgen::CoatShape shape{};
    FurDensities densities{};
    std::vector<furgen::PackedLevel> streaked{};  // what streaks are made of: small levels of half-way layers, type after type
    gl::Texture streaks{};
    std::shared_ptr<const void> of{};  // what it shows, for those who share it
    void makeStreaks();
    std::size_t bytes() const;
  };

 private:
  static std::shared_ptr<Coat> emptyCoat(const furgen::CoatShape& shape);

  std::shared_ptr<Coat> shown_ = std::make_shared<Coat>(), next_;
  unsigned long revision_ = 0;
};

}  // namespace fur::render
