// The model's vertices and triangles on the GPU, which most passes draw or read.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "geometry/Surface.h"
#include "gl/Objects.h"
#include "render/MovingVertices.h"

namespace fur::render {

// Where triangles of each material lie in a list of indices, in the order in which they came.
struct IndexRanges {
  struct Range {
    int first = 0, count = 0;
  };
  std::vector<Range> of;  // by material
  Range at(std::size_t material) const { return material < of.size() ? of[material] : Range{}; }
  // Puts the triangles of one material after those of another.
  static IndexRanges sort(std::vector<std::uint32_t>& indices, std::span<const std::uint8_t> materialOfVertex);
};

class SurfaceBuffers {
 public:
  // `tangents`, one a vertex, for a surface that will change its shape: follow(). What the shape was like stays
  // where it matters little: the stretch of the tile. Both return the bytes that were uploaded.
  // `materials`: one a vertex, the same for all of a triangle; none: there is one.
  std::size_t set(const geometry::Surface& surface, std::span<const Vec3> tangents, std::span<const std::uint8_t> materials = {});
  std::size_t follow(const Skin& skin);

  void draw(int instances) const { array_.drawIndexed(indexCount_, instances); }
  // The triangles of one material.
  void drawMaterial(std::size_t material) const;
  std::size_t materialOf(std::uint32_t vertex) const { return materials_.empty() ? 0 : materials_[vertex]; }
  IndexRanges sortByMaterial(std::vector<std::uint32_t>& indices) const { return IndexRanges::sort(indices, materials_); }
  const gl::VertexArray& array() const { return array_; }
  // Of each vertex the attribute FUR_AROUND: where it asks how wet the coat is round it, and how far.
  std::span<const Vec3> surroundings() const { return surroundings_; }
  int indexCount() const { return indexCount_; }
  int vertexCount() const { return vertexCount_; }
  bool twoSided() const { return twoSided_; }  // it has sheets, whose skin is seen from both sides
  // Another number whenever it is another surface or has another shape.
  unsigned long revision() const { return revision_; }

  // The same vertices in other triangles. Until the next set(), as the next one.
  gl::VertexArray arrayOver(const gl::Buffer& indices) const;
  // One instance a vertex, of its position and normal alone.
  gl::VertexArray instanceArray() const;

  std::size_t bytes() const { return vertices_.bytes() + furVertices_.bytes() + otherUv_.bytes() + indices_.bytes(); }

 private:
  gl::Buffer vertices_, furVertices_, otherUv_, indices_;
  gl::VertexArray array_;
  int vertexCount_ = 0, indexCount_ = 0;
  bool twoSided_ = false;
  unsigned long revision_ = 0;
  std::vector<Vec3> surroundings_;
  std::vector<std::uint8_t> materials_;  // of each vertex; empty: there is one
  IndexRanges ranges_;
  std::optional<MovingVertices> moving_;
};

}  // namespace fur::render
