#include "render/passes/shell/ShellPass.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "core/Sort.h"
#include "render/Blocks.h"

namespace fur::render {

std::size_t ShellPass::set(const geometry::Surface& surface, const SurfaceBuffers& buffers) {
  crowded_.clear();
  places_.clear();
  for (const geometry::SurfaceVertex& v : surface.vertices) {
    const Vec4& a = v.atlasFromFur;
    // The longest way in the atlas of a unit along the skin: the greatest singular value of the map between them.
    const Vec3 u = a.x * v.gradS + a.z * v.gradT, w = a.y * v.gradS + a.w * v.gradT;
    const float mean = 0.5f * (glm::dot(u, u) + glm::dot(w, w)), apart = glm::length(Vec2(mean - glm::dot(w, w), glm::dot(u, w)));
    places_.emplace_back(v.atlas, std::sqrt(mean + apart));
  }
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
  cellsFor_ = -1;
}

// What may lie under the rays that enter the coat on a patch: their triangles and two fur lengths round them; and where its vertices
// ask how high wet fur stands, as those of a patch beside it ask there as well.
void ShellPass::findCells(const SurfaceBuffers& surface, float coatLength) {
  constexpr float kRays = 2.0f;
  if (cellsFor_ == coatLength) return;
  cellsFor_ = coatLength;
  cells_.clear();
  firstCell_.assign(1, 0);
  std::vector<std::uint16_t> cells;
  for (const geometry::FurCluster& cluster : patches_.clusters) {
    cells.clear();
    for (std::uint32_t i = cluster.first; i < cluster.first + cluster.count; i += 3) {
      Vec2 low(1), high(0);
      float reach = 0;
      for (std::uint32_t k = 0; k < 3; ++k) {
        const std::uint32_t vertex = patches_.indices[i + k];
        const Vec3 &place = places_[vertex], &around = surface.surroundings()[vertex];
        low = glm::min(low, Vec2(place));
        high = glm::max(high, Vec2(place));
        reach = std::max(reach, kRays * coatLength * place.z);
        addCells(Vec2(around) - around.z, Vec2(around) + around.z, cells);
      }
      addCells(low - reach, high + reach, cells);
    }
    sortStably(cells.begin(), cells.end());
    cells.erase(std::unique(cells.begin(), cells.end()), cells.end());
    cells_.insert(cells_.end(), cells.begin(), cells.end());
    firstCell_.push_back(cells_.size());
  }
}

bool ShellPass::isWet(const WetCells& wet, std::uint32_t cluster) const {
  const auto cell = [this](std::size_t i) { return cells_.begin() + static_cast<std::ptrdiff_t>(firstCell_[i]); };
  return std::any_of(cell(cluster), cell(cluster + 1), [&](std::uint16_t at) { return wet.isWet(at); });
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
void ShellPass::order(const Drawing& drawing, float reach, Order wanted, bool divides) {
  const Vec3 eye = eyeInModel(drawing.frame);
  const bool crowds = drawing.frame.shellCount > 1 && wanted != Order::FarToNear;  // what is blended comes in one order
  const bool same = divided_ == divides && crowds_ == crowds && (!divides || wetFor_ == drawing.wetCells.revision());
  if (same && orderedFor_ == Vec4(eye, reach) && ordered_ == wanted) return;
  orderedFor_ = Vec4(eye, reach);
  ordered_ = wanted;
  divided_ = divides;
  crowds_ = crowds;
  wetFor_ = drawing.wetCells.revision();
  if (divides) findCells(drawing.surface, reach);
  const bool overlapping = wanted == Order::NearToFarOverlapping;
  struct Triangles {
    std::vector<std::uint32_t> plain, crowded;
  };
  std::array<Triangles, 2> seen;
  std::vector<std::uint32_t> clusters = geometry::clustersNearToFar(patches_.clusters, eye, reach);
  if (wanted == Order::FarToNear) std::reverse(clusters.begin(), clusters.end());
  for (const std::uint32_t i : clusters) {
    const geometry::FurCluster& c = patches_.clusters[i];
    const auto first = overlapping ? patches_.indices.begin() + c.first : patches_.ownIndices.begin() + c.ownFirst;
    Triangles& group = seen[divides && isWet(drawing.wetCells, i)];
    std::vector<std::uint32_t>& out = crowds && isCrowded(c, spreads_[i], eye) ? group.crowded : group.plain;
    out.insert(out.end(), first, first + (overlapping ? c.count : c.ownCount));
  }
  std::vector<std::uint32_t> all;
  all.reserve(patches_.indices.size());
  const auto append = [&](std::vector<std::uint32_t>& triangles) {
    IndexRanges ranges = drawing.surface.sortByMaterial(triangles);
    for (IndexRanges::Range& range : ranges.of) range.first += static_cast<int>(all.size());
    all.insert(all.end(), triangles.begin(), triangles.end());
    return ranges;
  };
  for (std::size_t wet = 0; wet < groups_.size(); ++wet) {
    groups_[wet].indexCount = static_cast<int>(seen[wet].plain.size() + seen[wet].crowded.size());
    groups_[wet].plain = append(seen[wet].plain);
    groups_[wet].crowded = append(seen[wet].crowded);
  }
  if (all.empty()) return;
  indices_.update(gl::bytesOf(all));
  drawing.uploadedBytes += all.size() * sizeof(std::uint32_t);
}

// On a coat that is wet in places patches that are dry are drawn as dry fur is, which costs less.
bool ShellPass::draw(const Drawing& drawing, VariantBits view) {
  if (!drawing.look.furry()) return true;
  const Frame& frame = drawing.frame;
  const bool exploded = view & kViewExploded;
  const VariantBits variant = drawing.look.shells(view);
  const bool divides = !view && variant & kWet;
  order(drawing, frame.coatLength + (exploded ? FUR_EXPLODED_SHELLS * FUR_EXPLODED_GAP : 0),
        chartsOverlap(frame) && !exploded ? Order::NearToFarOverlapping : Order::NearToFar, divides);
  gl::apply(stateOf(view, {.alphaToCoverage = true, .alpha = false}));
  const int shells = exploded ? FUR_EXPLODED_SHELLS : 1, crowded = exploded || view & kViewLayer ? shells : frame.shellCount;
  // What the samples after this one are drawn with the driver compiles meanwhile.
  if (divides && frame.gathers && !frame.flows && frame.sample == 0) drawing.programs.begin(Shader::Shell, variant | kBorders);
  if (!divides) return drawGroup(drawing, variant, false, shells, crowded);
  return drawGroup(drawing, variant & ~(kWet | kBorders), false, shells, crowded) && drawGroup(drawing, variant, true, shells, crowded);
}

bool ShellPass::drawGroup(const Drawing& drawing, VariantBits variant, bool wet, int shells, int crowdedShells) const {
  if (groups_[wet].indexCount == 0) return true;
  if (!drawing.programs.use(Shader::Shell, variant)) return false;
  drawMaterials(drawing, wet, shells, crowdedShells);
  return true;
}

void ShellPass::drawMaterials(const Drawing& drawing, bool wet, int shells, int crowdedShells) const {
  forFurry(drawing.materials, [&](std::size_t material) {
    const IndexRanges::Range range = groups_[wet].plain.at(material), crowded = groups_[wet].crowded.at(material);
    if (range.count > 0) array_.drawIndexed(range.count, shells, range.first);
    if (crowded.count > 0) array_.drawIndexed(crowded.count, crowdedShells, crowded.first);
  });
}

bool ShellPass::drawClassic(const Drawing& drawing) {
  if (!drawing.look.furry()) return true;
  if (!drawing.programs.use(Shader::ClassicShell, drawing.look.classicFur())) return false;
  order(drawing, drawing.frame.coatLength, Order::FarToNear, false);
  if (groups_[0].indexCount == 0) return true;
  gl::apply({.blend = gl::Blend::Over});
  drawMaterials(drawing, false, drawing.frame.settings.layers, drawing.frame.settings.layers);
  return true;
}

}  // namespace fur::render
