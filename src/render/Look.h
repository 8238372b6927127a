// Which shader variants a frame's passes are drawn in. Plain numbers, no GL.
#pragma once

#include "render/Frame.h"
#include "render/Programs.h"

namespace fur::render {

// `view`, where a pass is asked for it: the bits of a view that is shown in place of the final picture; kPlain: none.
class Look {
 public:
  // `furry`: there is a coat to draw; `textured`: the model, a fur type or the skin has a picture; `skinPictured`: the skin has.
  Look(const Frame& frame, bool furry, bool textured, bool skinPictured = false);

  bool furry() const { return furry_; }
  // The coat is drawn by the technique `shells`: the final picture, and the views that show it in parts.
  bool classic() const { return classic_; }
  // Of its shells and its fins.
  VariantBits classicFur() const { return bend_ | final_ | printed_ | kClassic; }
  VariantBits shells(VariantBits view) const;
  VariantBits fins(VariantBits view) const;
  VariantBits skin(VariantBits view) const;      // under the fur, where there is any
  VariantBits bareSkin(VariantBits view) const;  // alone
  VariantBits whiskers() const;
  VariantBits beads() const { return bend_; }
  VariantBits hair() const;
  VariantBits arrows(VariantBits view) const { return view ? view : bend_; }
  // Of a coat in the fur's shadow map.
  VariantBits bend() const { return bend_; }

 private:
  bool furry_, wetHair_, classic_;
  VariantBits notOfBare_;  // what bare skin has no use for
  VariantBits final_;  // all bits but those of `bend_`
  VariantBits bend_;   // how strands bend
  VariantBits borders_;  // whether locks run on across the borders of charts
  VariantBits printed_;  // which equations are the papers' as they are printed
};

}  // namespace fur::render
