// Draws fins (Sheppard 2004, 3.2): one instance an edge, where the outline is sharp, hollow or the surface ends.
#pragma once

#include <optional>
#include <span>

#include "render/passes/Drawing.h"
#include "render/passes/fin/MovingEdges.h"

namespace fur::render {

class FinPass {
 public:
  // `moves`: the surface will change its shape. Returns the bytes that were uploaded.
  std::size_t set(const geometry::Surface& surface, bool moves);
  void follow(const Skin& skin);
  // The length of fur at every vertex, until the next set(): fins between two of none are left out. {}: 1 everywhere.
  void setLengths(std::span<const float> vertexLengths);

  bool draw(const Drawing& drawing, VariantBits view);
  // Of the technique `shells`.
  bool drawClassic(const Drawing& drawing);
  std::size_t bytes() const;

 private:
  void select(const Drawing& drawing, float pixels);
  void drawBatches(const Drawing& drawing, int segments) const;  // quads along the height of a fin
  void selectClassic(const Drawing& drawing, bool all);
  void upload(const Drawing& drawing, const std::vector<FinEdge>& seen);
  bool bald(float vertex) const { return !vertexLengths_.empty() && vertexLengths_[static_cast<std::size_t>(vertex)] <= 0; }

  std::vector<FinEdge> edges_;
  std::optional<MovingEdges> moving_;
  std::vector<float> vertexLengths_;
  // Of edges that the eye may see fins of, those of each material.
  struct Batch {
    gl::Buffer instances;
    gl::VertexArray array;
    int count = 0;
    void fill(const std::vector<FinEdge>& edges);
  };
  std::vector<Batch> batches_;
  int count_ = 0;
  std::optional<Vec4> selectedFor_;  // eye, model space; w: pixels, see select(); below 0: of selectClassic()
};

}  // namespace fur::render
