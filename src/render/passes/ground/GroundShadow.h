// The model's shadow on the ground, and on wet ground its mirror image: a small map, drawn anew when what it shows changes.
#pragma once

#include <optional>

#include "render/passes/Drawing.h"
#include "render/passes/hair/HairPass.h"

namespace fur::render {

class GroundShadow {
 public:
  void create();
  // Needs both blocks bound. Leaves the platform's framebuffer bound, and where it has drawn another viewport.
  bool update(const Drawing& drawing, const HairPass& hair);
  const gl::Texture& map() const { return maps_[0]; }
  // Draws nothing that is kept, into a target of its own.
  void drawNothing() const;
  std::size_t bytes() const { return maps_[0].bytes() + maps_[1].bytes(); }

 private:
  struct Key {
    unsigned long surface, hair;
    Mat4 worldFromModel;
    Vec3 light;
    float length, height;
    Vec4 ball;
    Vec3 mirrorsTo;  // the eye, where the ground is wet
    bool casts = true;  // as Frame has it
    bool operator==(const Key&) const = default;
  };
  bool drawModel(const Drawing& drawing, const HairPass& hair);
  bool blur(Programs& programs);

  gl::Texture maps_[2];  // [1]: half blurred
  gl::Target targets_[2];
  std::optional<Key> key_;
};

}  // namespace fur::render
