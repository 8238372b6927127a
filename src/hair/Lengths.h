// Segments keep their lengths.
#pragma once

#include "hair/GuideBlocks.h"

namespace fur::hair {

// Moves nodes 2 and on by what the segments' lengths need, all at once: Newton's steps on |d|^2 = L^2, of which each is a
// tridiagonal system, linear in nodes (Han & Harada 2013 have it for hair). Unlike a pass from root to tip it keeps momentum. As in
// SHAKE (Ryckaert, Ciccotti and Berendsen 1977) segments pull along where they were, `was`: so energy is kept, and hair that
// hangs hangs still.
void relaxLengths(const Lanes* lengths, int nodes, const Lanes3* was, Lanes3* p);

// The unit vector of a segment whose nodes may be at one place; then `otherwise`.
inline Lanes3 directionOr(const Lanes3& segment, const Lanes3& otherwise) {
  const Lanes squared = dot(segment, segment);
  const LaneMask sound = squared > 1e-16f;
  return select(sound, segment * (1.0f / sqrtOf(sound ? squared : splat(1.0f))), otherwise);
}

}  // namespace fur::hair
