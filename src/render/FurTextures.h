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
  // What setLayer() and setFin() fill from now on; drops what came since the last show(). `types`: 1..4.
  void begin(int size, int layers, int finRows, int types);
  // Both return the bytes that were uploaded. Of layers without strands (furgen::hasStrands()) levels may have their coverage alone.
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

  int size() const { return shown_->coverage.shape().width; }
  int layers() const { return shown_->layers; }  // of one type
  const FurDensities& densities() const { return shown_->densities; }
  float density() const;  // of the densest type; 0: all are bald
  // Another number whenever other fur is shown.
  unsigned long revision() const { return revision_; }
  // Of what several share, a share.
  std::size_t bytes() const;

  // Layers of type after type, strands and offsets of every second one (furgen/Packing.h); of the fin maps one a type.
  struct Coat {
    gl::Texture coverage{}, strand{}, offset{}, finCoverage{}, finStrand{};
    int layers = 1;
    FurDensities densities{};
    std::vector<furgen::PackedLevel> streaked{};  // what streaks are made of: small levels of half-way layers, type after type
    gl::Texture streaks{};
    std::shared_ptr<const void> of{};  // what it shows, for those who share it
    void makeStreaks();
    std::size_t bytes() const;
  };

 private:
  static std::shared_ptr<Coat> emptyCoat(int size, int layers, int finRows, int types);

  std::shared_ptr<Coat> shown_ = std::make_shared<Coat>(), next_;
  unsigned long revision_ = 0;
};

}  // namespace fur::render
