// Every shader variant, compiled when it is first drawn.
#pragma once

#include <map>
#include <utility>

#include "gl/Objects.h"
#include "render/Frame.h"

namespace fur::render {

enum class Shader { Background, GroundShadow, Blur, Ground, Skin, Shell, ShadowMap, ShadowBlur, Fin, Enlarge, Whisker };

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
  kUnderFur = 256,     // Skin
  kMarschner = 512,    // Shell, Fin, Whisker: strands lit by Marschner's model
  kShadowDepth = 1024,   // Skin, Shell, Fin, Whisker: receive the fur's shadow, see FurShadow.h; ShadowBlur: makes it
  kShadowLayers = 2048,  // the same with opacity layers; ShadowMap: the layers themselves
  kGroomed = 8192,       // Shell: the groom's map says more than full length
  kTypes = 16384,          // Shell, Fin, Skin: several fur types; shells then are groomed
  kViewDominance = 32768,
  kViewTypes = 65536,
  kViewOffset = 131072,
  kSkinOnly = 4096,      // ShadowMap: the skin instead of the coat's outside
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
