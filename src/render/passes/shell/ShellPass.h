// Draws the coat: its outside in one draw, whose fragments march through it (shell.frag). Patches of it go from near to far.
#pragma once

#include <optional>

#include "geometry/FurClusters.h"
#include "render/passes/Drawing.h"

namespace fur::render {

class ShellPass {
 public:
  // On all of the surface, whose buffers these are. Returns the bytes that were uploaded.
  std::size_t set(const geometry::Surface& surface, const SurfaceBuffers& buffers);
  void follow(const Skin& skin);
  // On these in place of all of the surface, until the next set(). None: there is no fur.
  void setPatches(geometry::FurPatches patches);
  bool empty() const { return patches_.indices.empty(); }

  bool draw(const Drawing& drawing, unsigned view);
  std::size_t bytes() const { return indices_.bytes(); }

 private:
  void order(const Drawing& drawing, float reach, bool overlapping);

  geometry::FurPatches patches_;
  gl::Buffer indices_;  // of patches that face the eye, near to far
  gl::VertexArray array_;
  int indexCount_ = 0;
  // Eye (model space) and fur length, and whether charts overlap, that those on the GPU were put in order for.
  std::optional<Vec4> orderedFor_;
  bool orderedOverlapping_ = false;
};

}  // namespace fur::render
