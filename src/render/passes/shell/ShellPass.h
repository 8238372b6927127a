// Draws the coat: its outside in one draw, whose fragments march through it (shell.frag), patches of it from near to far; or by the
// technique `shells` all its layers in one instanced draw (classic_shell.frag), patches of each from far to near.
#pragma once

#include <array>
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
  // One a vertex: rays may enter the coat there without crossing its outside, so that Frame::shellCount shells stand there instead of one.
  void setCrowded(std::vector<std::uint8_t> vertices);
  bool empty() const { return patches_.indices.empty(); }

  bool draw(const Drawing& drawing, VariantBits view);
  bool drawClassic(const Drawing& drawing);
  std::size_t bytes() const { return indices_.bytes(); }

 private:
  enum class Order { NearToFar, NearToFarOverlapping, FarToNear };
  // `divides`: patches that are dry from those that are wet.
  void order(const Drawing& drawing, float reach, Order wanted, bool divides);
  bool isCrowded(const geometry::FurCluster& cluster, float spread, const Vec3& eye) const;
  // `wet`: those patches that are (groups_).
  bool drawGroup(const Drawing& drawing, VariantBits variant, bool wet, int shells, int crowdedShells) const;
  void drawMaterials(const Drawing& drawing, bool wet, int shells, int crowdedShells) const;
  bool isWet(const WetCells& cells, std::uint32_t cluster) const;
  void findCells(const SurfaceBuffers& surface, float coatLength);

  geometry::FurPatches patches_;
  gl::Buffer indices_;  // of patches that face the eye, near to far
  gl::VertexArray array_;
  std::vector<std::uint8_t> crowded_;
  std::vector<float> spreads_;  // of the normals of each patch at rest, as FurCluster::cosine
  // Of each material, in that order: what is not crowded, and what is.
  struct Group {
    IndexRanges plain, crowded;
    int indexCount = 0;
  };
  std::array<Group, 2> groups_;  // of patches that are drawn as dry fur, and of those that are wet
  std::vector<Vec3> places_;  // of each vertex: in the atlas; atlas units to a model unit at most
  // Of each patch, the cells of the atlas (WetCells.h) that its rays may come to, one after another from firstCell_[i] on.
  std::vector<std::uint16_t> cells_;
  std::vector<std::size_t> firstCell_;
  float cellsFor_ = -1;  // fur length
  bool divided_ = false;  // dry patches from wet ones
  bool crowds_ = false;   // patches where several shells stand from others
  unsigned long wetFor_ = 0;
  // Eye (model space) and fur length that those on the GPU were put in order for, and which order that is.
  std::optional<Vec4> orderedFor_;
  Order ordered_ = Order::NearToFar;
};

}  // namespace fur::render
