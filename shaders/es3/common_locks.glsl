// Locks grow from the cells of a jittered grid that repeats (furgen/LockCentres.h): those that brushes make, and those in which wet fur lies.
uniform sampler2D lockCentres;  // 0.5 + the way to the middle of the lock there / 4, in locks

// `at`, both: in locks.
vec2 lockCentre(vec2 at) { return at + 4.0 * (textureLod(lockCentres, at / FUR_LOCKS_ACROSS, 0.0).xy - 0.5); }
// The same by the nearest texel of the map, at a lower price; at its middle the centre is exact, so that all of a lock agree on it.
vec2 lockCentreNear(vec2 at) {
  vec2 texel = floor(at * FUR_LOCK_TEXELS);
  ivec2 repeated = ivec2(texel) & (int(FUR_LOCKS_ACROSS * FUR_LOCK_TEXELS) - 1);
  return (texel + 0.5) / FUR_LOCK_TEXELS + 4.0 * (texelFetch(lockCentres, repeated, 0).xy - 0.5);
}
