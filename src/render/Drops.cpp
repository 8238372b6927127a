#include "render/Drops.h"

#include "shared/Blocks.h"

namespace fur::render {

namespace {

constexpr gl::Attribute kAttributes[] = {{FUR_DROP_PLACE, 4, offsetof(wet::Drop, position)}, {FUR_DROP_WAY, 3, offsetof(wet::Drop, velocity)}};
static_assert(offsetof(wet::Drop, radius) == sizeof(Vec3));

}  // namespace

Status Drops::draw(Programs& programs, std::span<const wet::Drop> drops, std::size_t& uploadedBytes) {
  if (drops.empty()) return Done{};
  const auto program = programs.use(Shader::Drop, kPlain);
  if (!program) return program.error();
  if (drops_.bytes() == 0) {
    drops_ = gl::Buffer(gl::BufferKind::Vertex, std::as_bytes(drops), true);
    array_ = gl::VertexArray(drops_, sizeof(wet::Drop), kAttributes, 1, nullptr);
  } else {
    drops_.update(std::as_bytes(drops));
  }
  uploadedBytes += drops.size_bytes();
  gl::apply({.depthWrite = false, .cullBack = false, .blend = gl::Blend::Over});
  array_.drawStrips(4, static_cast<int>(drops.size()));
  return Done{};
}

}  // namespace fur::render
