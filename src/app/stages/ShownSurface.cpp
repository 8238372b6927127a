#include "app/stages/ShownSurface.h"

#include <utility>

#include "core/Fnv1a.h"

namespace fur::app {

namespace {

std::uint64_t hashOf(const geometry::Mesh& mesh, geometry::FurMapping mapping) {
  Fnv1a hash;
  const auto add = [&](const auto& values) {
    hash.add(values.size());
    hash.addAll(values);
  };
  hash.add(mapping);
  hash.add(mesh.layout.chartCount);
  add(mesh.positions), add(mesh.normals), add(mesh.uv), add(mesh.otherUv), add(mesh.atlas), add(mesh.furUv);
  add(mesh.indices), add(mesh.layout.chartOf), add(mesh.layout.corners);
  return hash.value();
}

}  // namespace

// It is not going to grow.
ShownSurface::ShownSurface(geometry::Surface surface) : parts_(std::make_shared<Parts>(Parts{std::move(surface)})) {
  parts_->surface.vertices.shrink_to_fit();
  parts_->surface.edges.shrink_to_fit();
  parts_->surface.furIndices.shrink_to_fit();
}

const geometry::SurfaceQuery& ShownSurface::query() const {
  if (!parts_->query) parts_->query.emplace(parts_->surface);
  return *parts_->query;
}

const groom::SurfacePoints& ShownSurface::points() const {
  if (!parts_->points) parts_->points.emplace(parts_->surface);
  return *parts_->points;
}

Result<ShownSurface> ModelShelf::surfaceOf(const geometry::Mesh& mesh, geometry::FurMapping mapping) {
  std::erase_if(surfaces_, [](const auto& one) { return one.second.expired(); });
  auto& kept = surfaces_[hashOf(mesh, mapping)];
  if (auto parts = kept.lock()) return ShownSurface(std::move(parts));
  auto built = geometry::buildSurface(mesh, mapping);
  if (!built) return built.error();
  ShownSurface surface(std::move(*built));
  kept = surface.parts_;
  return surface;
}

Pixels ModelShelf::pixels(std::vector<std::uint8_t> pixels) {
  std::erase_if(pixels_, [](const auto& one) { return one.second.expired(); });
  Fnv1a hash;
  hash.addAll(pixels);
  auto& kept = pixels_[hash.value()];
  if (auto had = kept.lock(); had && *had == pixels) return had;
  auto own = std::make_shared<const std::vector<std::uint8_t>>(std::move(pixels));
  kept = own;
  return own;
}

}  // namespace fur::app
