#include "app/stages/ShownSurface.h"

#include <utility>

#include "core/Fnv1a.h"
#include "groom/Lie.h"

namespace fur::app {

namespace {

void add(Fnv1a& hash, const void* data, std::size_t bytes) {
  hash.add(bytes);
  hash.addBytes(data, bytes);
}

std::uint64_t hashOf(const geometry::Mesh& mesh, geometry::FurMapping mapping) {
  Fnv1a hash;
  const auto addAll = [&](const auto& values) { add(hash, values.data(), values.size() * sizeof values[0]); };
  hash.add(mapping);
  hash.add(mesh.layout.chartCount);
  addAll(mesh.positions), addAll(mesh.normals), addAll(mesh.uv), addAll(mesh.otherUv), addAll(mesh.atlas), addAll(mesh.furUv);
  addAll(mesh.indices), addAll(mesh.layout.chartOf), addAll(mesh.layout.corners);
  return hash.value();
}

}  // namespace

// It is not going to grow.
ShownSurface::ShownSurface(geometry::Surface surface) : parts_(std::make_shared<Parts>(Parts{std::move(surface)})) {
  parts_->surface.vertices.shrink_to_fit();
}

const geometry::SurfaceQuery& ShownSurface::query() const {
  if (!parts_->query) parts_->query.emplace(parts_->surface);
  return *parts_->query;
}

const groom::SurfacePoints& ShownSurface::points() const {
  if (!parts_->points) parts_->points.emplace(parts_->surface);
  return *parts_->points;
}

const std::vector<Vec3>& ShownSurface::naturalLie() const {
  if (!parts_->lie) parts_->lie.emplace(groom::naturalLie(parts_->surface, points()));
  return *parts_->lie;
}

ModelShelf::Coming::Coming(ModelShelf& shelf, const geometry::Mesh& mesh, geometry::FurMapping mapping) : shelf_(&shelf), number_(hashOf(mesh, mapping)) {
  if (auto had = shelf.surfaces_.find(number_)) surface_ = ShownSurface(std::static_pointer_cast<ShownSurface::Parts>(std::move(had)));
  else building_.emplace(mesh, mapping);
}

bool ModelShelf::Coming::step() {
  if (surface_) {
    if (*surface_) (void)surface_->value().query(), (void)surface_->value().points();
    return true;
  }
  if (!building_->step()) return false;
  auto built = building_->take();
  building_.reset();
  if (!built) return surface_ = built.error(), true;
  ShownSurface surface(std::move(*built));
  shelf_->surfaces_.add(number_, surface.parts_);
  surface_ = std::move(surface);
  return false;
}

Result<ShownSurface> ModelShelf::surfaceOf(const geometry::Mesh& mesh, geometry::FurMapping mapping) {
  Coming coming(*this, mesh, mapping);
  while (!coming.step()) {}
  return coming.take();
}

Pixels ModelShelf::pixels(std::vector<std::uint8_t> pixels) {
  // Of some thousands of them: those that are found are compared.
  Fnv1a hash;
  hash.add(pixels.size());
  for (std::size_t i = 0; i < pixels.size(); i += 1 + pixels.size() / 4096) hash.add(pixels[i]);
  if (auto had = std::static_pointer_cast<std::vector<std::uint8_t>>(pixels_.find(hash.value())); had && *had == pixels) return had;
  auto own = std::make_shared<std::vector<std::uint8_t>>(std::move(pixels));
  pixels_.add(hash.value(), own);
  return own;
}

}  // namespace fur::app
