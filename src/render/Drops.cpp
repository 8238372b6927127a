#include "render/Drops.h"

#include "shared/Blocks.h"

namespace fur::render {

namespace {

constexpr gl::Attribute kAttributes[] = {{FUR_DROP_PLACE, 4, offsetof(Drop, position)}, {FUR_DROP_WAY, 3, offsetof(Drop, velocity)}};
static_assert(sizeof(Drop) == 7 * sizeof(float));

}  // namespace

Status Drops::draw(Programs& programs, std::span<const Drop> drops, std::size_t& uploadedBytes) {
  if (drops.empty()) return Done{};
  const auto program = programs.use(Shader::Drop, kPlain);
  if (!program) return program.error();
  if (drops_.bytes() == 0) {
    drops_ = gl::Buffer(gl::BufferKind::Vertex, std::as_bytes(drops), true);
    array_ = gl::VertexArray(drops_, sizeof(Drop), kAttributes, 1, nullptr);
  } else {
    drops_.update(std::as_bytes(drops));
  }
  uploadedBytes += drops.size_bytes();
  gl::apply({.depthWrite = false, .cullBack = false, .blend = gl::Blend::Over, .alpha = false});
  array_.drawStrips(4, static_cast<int>(drops.size()));
  return Done{};
}

}  // namespace fur::render
