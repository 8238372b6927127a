#include "render/passes/shell/ShellPass.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "render/Blocks.h"

namespace fur::render {

std::size_t ShellPass::set(const geometry::Surface& surface, const SurfaceBuffers& buffers) {
  crowded_.clear();
  setPatches({surface.furIndices, surface.ownFurIndices, surface.furClusters});
  indices_ = gl::Buffer(gl::BufferKind::Index, gl::bytesOf(patches_.indices), true);
  array_ = buffers.arrayOver(indices_);
  return indices_.bytes();
}

void ShellPass::follow(const Skin& skin) {
  for (geometry::FurCluster& cluster : patches_.clusters) {
    // It may face any way now.
    if (std::exchange(cluster.cosine, -1.0f) > 0) orderedFor_.reset();
    cluster.centre = skin.positions[patches_.indices[cluster.first]];
    cluster.axis = skin.normals[patches_.indices[cluster.first]];
  }
}

void ShellPass::setPatches(geometry::FurPatches patches) {
  patches_ = std::move(patches);
  spreads_.clear();
  for (const geometry::FurCluster& cluster : patches_.clusters) spreads_.push_back(cluster.cosine);
  orderedFor_.reset();
}

void ShellPass::setCrowded(std::vector<std::uint8_t> vertices) {
  crowded_ = std::move(vertices);
  orderedFor_.reset();
}

// A ray that goes down steeply has crossed the coat's outside right before. `spread`: cosine of the cone of the patch's normals.
bool ShellPass::isCrowded(const geometry::FurCluster& cluster, float spread, const Vec3& eye) const {
  constexpr float kSteep = 0.5f;
  if (crowded_.empty()) return false;
  const float facing = glm::dot(normalizeOr(eye - cluster.centre, cluster.axis), cluster.axis);
  if (facing > 0 && spread > 0 && facing * spread - std::sqrt(std::max((1 - facing * facing) * (1 - spread * spread), 0.0f)) > kSteep) return false;
  const auto first = patches_.ownIndices.begin() + cluster.ownFirst;
  return std::any_of(first, first + cluster.ownCount, [&](std::uint32_t vertex) { return crowded_[vertex] > 0; });
}

// Near to far: what is covered is rejected by depth. Without what faces away. Only there do charts overlap: copies share samples.
void ShellPass::order(const Drawing& drawing, float reach, Order wanted) {
  const Vec3 eye = eyeInModel(drawing.frame);
  if (orderedFor_ == Vec4(eye, reach) && ordered_ == wanted) return;
  orderedFor_ = Vec4(eye, reach);
  ordered_ = wanted;
  const bool overlapping = wanted == Order::NearToFarOverlapping;
  std::vector<std::uint32_t> seen, crowded;
  seen.reserve(patches_.indices.size());
  std::vector<std::uint32_t> clusters = geometry::clustersNearToFar(patches_.clusters, eye, reach);
  if (wanted == Order::FarToNear) std::reverse(clusters.begin(), clusters.end());
  for (const std::uint32_t i : clusters) {
    const geometry::FurCluster& c = patches_.clusters[i];
    const auto first = overlapping ? patches_.indices.begin() + c.first : patches_.ownIndices.begin() + c.ownFirst;
    // What is blended comes in one order.
    std::vector<std::uint32_t>& out = wanted != Order::FarToNear && isCrowded(c, spreads_[i], eye) ? crowded : seen;
    out.insert(out.end(), first, first + (overlapping ? c.count : c.ownCount));
  }
  ranges_ = drawing.surface.sortByMaterial(seen);
  crowdedRanges_ = drawing.surface.sortByMaterial(crowded);
  for (IndexRanges::Range& range : crowdedRanges_.of) range.first += static_cast<int>(seen.size());
  seen.insert(seen.end(), crowded.begin(), crowded.end());
  indexCount_ = static_cast<int>(seen.size());
  if (seen.empty()) return;
  indices_.update(gl::bytesOf(seen));
  drawing.uploadedBytes += seen.size() * sizeof(std::uint32_t);
}

bool ShellPass::draw(const Drawing& drawing, VariantBits view) {
  if (!drawing.look.furry()) return true;
  const Frame& frame = drawing.frame;
  if (!drawing.programs.use(Shader::Shell, drawing.look.shells(view))) return false;
  const bool exploded = view & kViewExploded;
  order(drawing, frame.coatLength + (exploded ? FUR_EXPLODED_SHELLS * FUR_EXPLODED_GAP : 0), chartsOverlap(frame) && !exploded ? Order::NearToFarOverlapping : Order::NearToFar);
  if (indexCount_ == 0) return true;
  gl::apply(stateOf(view, {.alphaToCoverage = true, .alpha = false}));
  const int shells = exploded ? FUR_EXPLODED_SHELLS : 1;
  drawMaterials(drawing, shells, exploded || view & kViewLayer ? shells : frame.shellCount);
  return true;
}

void ShellPass::drawMaterials(const Drawing& drawing, int shells, int crowdedShells) const {
  forFurry(drawing.materials, [&](std::size_t material) {
    const IndexRanges::Range range = ranges_.at(material), crowded = crowdedRanges_.at(material);
    if (range.count > 0) array_.drawIndexed(range.count, shells, range.first);
    if (crowded.count > 0) array_.drawIndexed(crowded.count, crowdedShells, crowded.first);
  });
}

bool ShellPass::drawClassic(const Drawing& drawing) {
  if (!drawing.look.furry()) return true;
  if (!drawing.programs.use(Shader::ClassicShell, drawing.look.classicFur())) return false;
  order(drawing, drawing.frame.coatLength, Order::FarToNear);
  if (indexCount_ == 0) return true;
  gl::apply({.blend = gl::Blend::Over});
  drawMaterials(drawing, drawing.frame.settings.layers, drawing.frame.settings.layers);
  return true;
}

}  // namespace fur::render
