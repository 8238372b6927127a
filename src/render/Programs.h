// Every shader variant, compiled when it is first drawn.
#pragma once

#include <map>
#include <utility>

#include "gl/Objects.h"
#include "render/Frame.h"

namespace fur::render {

enum class Shader { Background, GroundShadow, Blur, Ground, Skin, Shell, Fin };

// Bits of a variant; each is a #define in the shader.
enum Variant : unsigned {
  kPlain = 0,
  kWet = 1,
  kViewTangents = 2,
  kViewCoverage = 4,
  kViewWetness = 8,
  kViewNormals = 16,
  kStraightDown = 32,  // GroundShadow
  kVertical = 64,      // Blur
  kTextured = 128,     // the model has a picture of its own
};

class Programs {
 public:
  // The program, bound for use. A refused shader is remembered as the first error.
  Result<const gl::Program*> use(Shader shader, unsigned variant);

 private:
  std::map<std::pair<Shader, unsigned>, gl::Program> programs_;
};

// Every variant that the renderer can ask for: a test compiles them all.
std::vector<std::pair<Shader, unsigned>> allVariants();

}  // namespace fur::render
