// The mean of the samples of a picture that stays (Samples.h), of the light that they show: in linear light, in whole numbers of
// 16 bits, which every context draws into. The samples come through the platform's framebuffer, out of sight.
#pragma once

#include "gl/Objects.h"
#include "render/Programs.h"

namespace fur::render {

class Gathered {
 public:
  // Takes `count` rows from `bottom` on of what the platform's framebuffer has, which is width x height pixels. The frame block says for
  // how much they count; once all rows have come the sample is whole.
  bool add(Programs& programs, int width, int height, int bottom, int count);
  // The mean of all whole samples, into the platform's framebuffer. `keepsDepth`: of the last of them, for what is drawn over it.
  bool show(Programs& programs, bool keepsDepth = false) const;
  // Gives back what only a further sample needs, three fifths of the bytes.
  void rest();
  std::size_t bytes() const { return taken_.bytes() + means_[0].bytes() + means_[1].bytes(); }

 private:
  void fit(int width, int height);

  gl::Texture taken_, means_[2];
  gl::Target takes_, targets_[2];
  int newest_ = 0;  // of means_
};

}  // namespace fur::render
