#include "render/Drops.h"

#include "shared/Blocks.h"

namespace fur::render {

namespace {

// FUR_DROP_PLACE, FUR_DROP_WAY and FUR_DROP_KIND.
struct Instance {
  Vec4 place;
  Vec4 way;
  Vec2 kind;
};
constexpr gl::Attribute kAttributes[] = {
    {FUR_DROP_PLACE, 4, offsetof(Instance, place)}, {FUR_DROP_WAY, 4, offsetof(Instance, way)}, {FUR_DROP_KIND, 2, offsetof(Instance, kind)}};

// Pieces of a jet that are further apart than so many steps of the first are of two jets.
constexpr float kApart = 3.0f;

}  // namespace

Status Drops::draw(Programs& programs, std::span<const wet::Drop> drops, std::size_t& uploadedBytes) {
  if (drops.empty()) return Done{};
  const auto program = programs.use(Shader::Drop, kPlain);
  if (!program) return program.error();
  std::vector<Instance> instances(drops.size());
  Instance* next = instances.data();
  // The piece of a jet that set out before.
  const wet::Drop* before = nullptr;
  for (const wet::Drop& drop : drops) {
    Instance one{Vec4(drop.position, drop.radius), Vec4(drop.velocity / 60.0f, !drop.hangs()), {drop.jet, drop.splash}};
    if (drop.jet > 0 && drop.splash == 0) {
      const Vec3 step(one.way);
      // Each reaches to the one before.
      if (before) {
        const Vec3 link = before->position - drop.position;
        if (glm::dot(link, link) < kApart * kApart * glm::dot(step, step)) {
          one.way = Vec4(link, 1);
          one.place += Vec4(0.5f * link, 0);
        }
      }
      before = &drop;
    }
    *next++ = one;
  }
  if (drops_.bytes() == 0) {
    drops_ = gl::Buffer(gl::BufferKind::Vertex, gl::bytesOf(instances), true);
    array_ = gl::VertexArray(drops_, sizeof(Instance), kAttributes, 1, nullptr);
  } else {
    drops_.update(gl::bytesOf(instances));
  }
  uploadedBytes += gl::bytesOf(instances).size();
  gl::apply({.depthWrite = false, .cullBack = false, .blend = gl::Blend::Over});
  array_.drawStrips(4, static_cast<int>(drops.size()));
  return Done{};
}

}  // namespace fur::render
