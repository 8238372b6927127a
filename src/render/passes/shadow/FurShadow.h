// Shadow that fur casts and receives as a volume, seen from the light (Halen & Wester 2007, 3.3.2
// and 5.7-5.8):
//   depth   the depth-difference map: T = exp(-k dz), dz the way from the first fur surface on
//   layers  opacity shadow maps: 16 layers, laid from the first surface on (Yuksel & Keyser 2008 do so),
//           which count the strands on the way: T = exp(-k sigma(z))
// A texel is the penumbra: the setting shadowSize says how many there are. Redrawn only when its key changes.
// shaders/es3/common_furshadow.glsl looks it up; hair/VolumeShadow.h has the formulas. It does not know of wet clumps, and the
// ground keeps a shadow of its own.
#pragma once

#include <optional>

#include "gl/Objects.h"
#include "render/Programs.h"
#include "render/passes/hair/HairPass.h"
#include "settings/Settings.h"
#include "shared/Blocks.h"

namespace fur::render {

enum class Shadows { None, Depth, Layers };  // the setting `shadows`

// Of an orthographic camera round a model that reaches so far from its origin, with fur of that length.
float shadowRadius(float furLength, float reach = 1);
// Model space to the map: xy 0..1, z depth along the light in model units from the sphere's top. `light`:
// unit, towards the light.
Mat4 lightFromModel(const Vec3& light, float radius);
// What FrameBlock says of it (shared/Blocks.h), of a map for a coat of that density (share of the densest layer that strands cover).
struct VolumeShadow {
  float extinction, bias, layerDepth, surface, range;
  bool operator==(const VolumeShadow&) const = default;
};
VolumeShadow volumeShadow(const settings::Settings& settings, float density, float reach = 1);
// The variant of a shader that receives it.
VariantBits shadowVariant(const settings::Settings& settings);
// That of one whose strands bend.
inline VariantBits curveVariant(const settings::Settings& s) { return s.bendCurve ? +kPolynomial : +kPlain; }

class FurShadow {
 public:
  struct Key {
    Shadows shadows;
    int size;             // texels along the map
    Mat4 lightFromModel;
    VolumeShadow volume;
    VariantBits curve;    // curveVariant()
    unsigned long scene;  // another one whenever surface, bends or coat are others
    Vec4 ball;            // as Frame has it
    Mat4 worldFromModel;  // where there is one
    bool casts = true;    // as Frame has it
    bool operator==(const Key&) const = default;
    void fill(shared::FrameBlock& block) const;
  };
  // Needs both uniform blocks, the bends and the tile bound; leaves the platform's framebuffer bound, and
  // another viewport. Binds the maps to their units.
  bool update(Programs& programs, const Key& key, const gl::VertexArray& surface, int indexCount, const HairPass& hair);
  std::size_t bytes() const;
  long redraws() const { return redraws_; }

 private:
  void prepare(int size, bool layers);
  void clear(bool layers);
  bool drawFirst(Programs& programs, const Key& key, bool layers, const gl::VertexArray& surface, int indexCount, const HairPass& hair);
  bool blur(Programs& programs);
  bool drawLayers(Programs& programs, VariantBits curve, const gl::VertexArray& surface, int indexCount, const HairPass& hair);

  gl::Texture first_[2];  // depth of the first surface; [1]: half blurred
  gl::Target firstTarget_[2];
  gl::Texture opacity_;
  gl::Target opacityTarget_;
  std::optional<Key> key_;
  long redraws_ = 0;
};

}  // namespace fur::render
