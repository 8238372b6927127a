#include "render/passes/drop/DropPass.h"

#include <vector>

#include "shared/Blocks.h"

namespace fur::render {

namespace {

// FUR_DROP_PLACE, FUR_DROP_WAY and FUR_DROP_KIND.
struct Instance {
  Vec4 place;
  Vec4 way;
  Vec2 kind;
};
constexpr gl::Attribute kDropAttributes[] = {
    {FUR_DROP_PLACE, 4, offsetof(Instance, place)}, {FUR_DROP_WAY, 4, offsetof(Instance, way)}, {FUR_DROP_KIND, 2, offsetof(Instance, kind)}};

// Pieces of a jet that are further apart than so many steps of the first are of two jets.
constexpr float kApart = 3.0f;

// The place and the way on which each is seen in a sixtieth of a second.
std::vector<Instance> instancesOf(std::span<const wet::Drop> drops) {
  std::vector<Instance> instances;
  instances.reserve(drops.size());
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
    instances.push_back(one);
  }
  return instances;
}

}  // namespace

bool DropPass::draw(const Drawing& drawing) {
  if (drawing.frame.drops.empty()) return true;
  if (!drawing.programs.use(Shader::Drop, kPlain)) return false;
  const std::vector<Instance> instances = instancesOf(drawing.frame.drops);
  if (instances_.bytes() == 0) {
    instances_ = gl::Buffer(gl::BufferKind::Vertex, gl::bytesOf(instances), true);
    array_ = gl::VertexArray(instances_, sizeof(Instance), kDropAttributes, 1, nullptr);
  } else {
    instances_.update(gl::bytesOf(instances));
  }
  drawing.uploadedBytes += gl::bytesOf(instances).size();
  gl::apply({.depthWrite = false, .cullBack = false, .blend = gl::Blend::Over});
  array_.drawStrips(4, static_cast<int>(instances.size()));
  return true;
}

}  // namespace fur::render
