#include "render/passes/bead/BeadPass.h"

#include <algorithm>

#include "core/Random.h"

namespace fur::render {

namespace {

// Enough to sparkle all over. A software rasteriser has to work out each, whether it is seen or not.
constexpr std::size_t kBeads = 2048;

}  // namespace

std::vector<groom::WhiskerHair> strandsForBeads(const geometry::Surface& surface) {
  const std::vector<std::uint32_t>& indices = surface.indices;
  std::vector<float> areas{0};  // up to each triangle's end
  for (std::size_t i = 0; i + 2 < indices.size(); i += 3) {
    const auto at = [&](std::size_t k) { return surface.vertices[indices[i + k]].position; };
    areas.push_back(areas.back() + glm::length(glm::cross(at(1) - at(0), at(2) - at(0))));
  }
  std::vector<groom::WhiskerHair> strands;
  if (!(areas.back() > 0)) return strands;
  Random random(5);
  for (std::size_t bead = 0; bead < kBeads; ++bead) {
    // One from each part of the surface that is as large.
    const float share = (static_cast<float>(bead) + random.uniform()) / kBeads;
    const auto end = std::upper_bound(areas.begin() + 1, areas.end() - 1, share * areas.back());
    const std::size_t first = 3 * static_cast<std::size_t>(end - areas.begin() - 1);
    const float across = std::sqrt(random.uniform()), along = random.uniform();
    groom::WhiskerHair strand{};
    strand.weights = {1 - across, across * (1 - along), across * along};
    Vec2 atlas(0);
    for (int k = 0; k < 3; ++k) {
      const std::uint32_t vertex = indices[first + static_cast<std::size_t>(k)];
      strand.root += strand.weights[k] * surface.vertices[vertex].position;
      strand.normal += strand.weights[k] * surface.vertices[vertex].normal;
      atlas += strand.weights[k] * surface.vertices[vertex].atlas;
      strand.vertices[k] = static_cast<float>(vertex);
    }
    strand.normal = strand.direction = normalizeOr(strand.normal, Vec3(0, 1, 0));
    strand.give = 1;
    strand.shade = random.uniform();
    strand.atlasU = atlas.x;
    strand.atlasV = atlas.y;
    strands.push_back(strand);
  }
  return strands;
}

void BeadPass::set(const geometry::Surface& surface) {
  strands_ = strandsForBeads(surface);
  changed_ = true;
}

void BeadPass::follow(const Skin& skin) {
  for (groom::WhiskerHair& strand : strands_) {
    Vec3 root(0), normal(0);
    for (int k = 0; k < 3; ++k) {
      const auto vertex = static_cast<std::size_t>(strand.vertices[k]);
      root += strand.weights[k] * skin.positions[vertex];
      normal += strand.weights[k] * skin.normals[vertex];
    }
    strand.root = root;
    strand.normal = strand.direction = normalizeOr(normal, strand.normal);
  }
  changed_ = true;
}

bool BeadPass::draw(const Drawing& drawing, const WhiskerPass& whiskers) {
  if (!drawing.frame.wet || !drawing.look.furry() || strands_.empty()) return true;
  if (vertices_.bytes() == 0) {
    vertices_ = gl::Buffer(gl::BufferKind::Vertex, gl::bytesOf(strands_), true);
    array_ = hairArray(vertices_, 0);
    drawing.uploadedBytes += vertices_.bytes();
  } else if (changed_) {
    vertices_.update(gl::bytesOf(strands_));
    drawing.uploadedBytes += vertices_.bytes();
  }
  changed_ = false;
  if (!drawing.programs.use(Shader::Bead, drawing.look.beads())) return false;
  gl::apply({.depthWrite = false, .cullBack = false, .blend = gl::Blend::Over});
  array_.drawPoints(static_cast<int>(strands_.size()));
  whiskers.drawBeads();
  return true;
}

}  // namespace fur::render
