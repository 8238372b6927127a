// Collision shapes for the bones of a rigged model: what hair stays out of when it is animated.
#pragma once

#include <vector>

#include "hair/Body.h"
#include "scene/Rig.h"

namespace fur::scene {

// For each node that holds enough of the mesh, by the greatest of a vertex' weights, a capsule along the bone, or along the vertices
// where no other bone follows, about as thick as they lie round it: half of them are outside. At rest, model space; Body::bone is
// the node. The kMostBodies largest; none for a rig that holds nothing.
std::vector<hair::Body> fitBodies(const Rig& rig);

}  // namespace fur::scene
