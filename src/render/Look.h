// Which shader variants a frame's passes are drawn in. Plain numbers, no GL.
#pragma once

#include "render/Frame.h"
#include "render/Programs.h"

namespace fur::render {

// `view`, where a pass is asked for it: the bits of a view that is shown in place of the final picture; kPlain: none.
class Look {
 public:
  // `furry`: there is a coat to draw; `textured`: the model has a picture of its own.
  Look(const Frame& frame, bool furry, bool textured);

  bool furry() const { return furry_; }
  unsigned shells(unsigned view) const;
  unsigned fins(unsigned view) const;
  unsigned skin(unsigned view) const;      // under the fur, where there is any
  unsigned bareSkin(unsigned view) const;  // alone
  unsigned whiskers() const;
  unsigned hair() const;
  unsigned arrows(unsigned view) const { return view ? view : bend_; }
  // Of a coat in the fur's shadow map.
  unsigned bend() const { return bend_; }

 private:
  bool furry_, wetHair_;
  unsigned final_;  // all bits but those of `bend_`
  unsigned bend_;   // how strands bend
};

}  // namespace fur::render
