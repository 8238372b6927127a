// The coat's fur types on the GPU. A new coat comes in pieces while the one before stays in the picture.
#pragma once

#include <span>
#include <vector>

#include "furgen/Packing.h"
#include "gl/Objects.h"

namespace fur::render {

class FurTextures {
 public:
  // What setLayer() and setFin() fill from now on; drops what came since the last show(). `types`: 1..4.
  void begin(int size, int layers, int finRows, int types);
  void setLayer(int type, int layer, std::span<const furgen::PackedLevel> levels);
  void setFin(int type, std::span<const furgen::PackedLevel> levels);
  void show();
  // `wet`: with the streaks, which are made the first time.
  void bind(bool wet);

  int size() const { return shown_.coverage.shape().width; }
  int layers() const { return layers_; }  // of one type
  std::size_t bytes() const { return shown_.bytes() + next_.bytes() + streaks_.bytes(); }

 private:
  // Layers of type after type; of the fin maps one a type.
  struct Set {
    gl::Texture coverage, strand, offset, finCoverage, finStrand;
    std::vector<furgen::PackedLevel> streaked = {};  // what streaks are made of: small levels of half-way layers, type after type
    std::size_t bytes() const;
  };
  void makeStreaks();
  Set shown_, next_;
  gl::Texture streaks_;
  int layers_ = 1, nextLayers_ = 1;
};

}  // namespace fur::render
