// Every shader variant, compiled when it is first drawn or asked for ahead.
#pragma once

#include <cstdint>
#include <utility>
#include <vector>

#include "gl/Objects.h"
#include "render/Frame.h"

namespace fur::render {

enum class Shader { Background, Ground, GroundShadow, Blur, Skin, Shell, ClassicShell, ShadowMap, ShadowBlur, Fin, Enlarge, Mean, ShowMean, Whisker, Drop, Bead, Ball, Arrow, Bare, Hair, BlendedHair, HairPoints, HairShadow, HairDepth, HairSkin, HairMap, HairWisp, HairLine, HiddenHairLine };

// Bits of a variant; each is a #define in the shader.
using VariantBits = std::uint64_t;
enum Variant : VariantBits {
  kPlain = 0,
  kWet = 1 << 0,           // Shell, Fin, Whisker, Skin under fur; Ground: it is wet somewhere
  kTextured = 1 << 1,      // the model has a picture of its own
  kGroomed = 1 << 2,       // Shell, Fin, Skin, ShadowMap: the groom's map says more than full length
  kTypes = 1 << 3,         // Shell, Fin, Skin, ShadowMap: several fur types; groomed, too
  kMarschner = 1 << 4,     // Shell, Fin, Whisker: strands lit by Marschner's model
  kShadowDepth = 1 << 5,   // Skin, Bare, Shell, Fin, Whisker: receive the fur's shadow, see FurShadow.h; ShadowBlur: makes it
  kShadowLayers = 1 << 6,  // the same with opacity layers; ShadowMap: the layers themselves
  kUnderFur = 1 << 7,      // Skin
  kSkinOnly = 1 << 8,      // ShadowMap: the skin instead of the coat's outside
  // From here on each makes a view.
  kViewTangents = 1 << 9,
  kViewCoverage = 1 << 10,
  kViewWetness = 1 << 11,
  kViewNormals = 1 << 12,
  kViewDominance = 1 << 13,
  kViewTypes = 1 << 14,
  kViewOffset = 1 << 15,
  kViewLayer = 1 << 16,
  kViewExploded = 1 << 17,  // with kViewLayer
  kViewDim = 1 << 18,       // Skin: so that what is drawn over it stands out
  kViewEdges = 1 << 19,     // Fin
  kViewClumps = 1 << 20,
  kViewShadow = 1 << 21,
  kViewOverdraw = 1 << 22,
  kViewSteps = 1 << 23,
  kViewForces = 1 << 24,    // Arrow
  // Not of a view again.
  kBall = 1ull << 25,         // GroundShadow, ShadowMap: the ball's in place of the model's
  kPolynomial = 1ull << 26,   // Shell, Fin, Whisker, ShadowMap: strands bend as Sheppard has it
  kPainted = 1ull << 27,      // Shell, Fin, Skin: somebody has painted them
  kShaped = 1ull << 28,       // Shell, Fin: brushes have changed the shape of strands; groomed, too
  kViewLayout = 1ull << 29,   // Skin; of a view once more
  kStrips = 1ull << 30,       // Hair, BlendedHair, HairDepth: wisps as strips
  kOnGround = 1ull << 31,     // HairShadow: on the ground
  kClassic = 1ull << 32,      // Fin, Skin: below and beside shells that are drawn one by one
  kPrintedLobe = 1ull << 33,    // ClassicShell, Fin, and the next two: the papers' equations as printed (settings of these names)
  kPrintedClumps = 1ull << 34,
  kPrintedLight = 1ull << 35,
  kBorders = 1ull << 36,      // Shell, wet: locks run on across the borders of charts
};

constexpr bool isView(VariantBits variant) { return variant & (((kViewForces << 1) - kViewTangents) | kViewLayout); }

// The text of a shader that not every program has (render/ShaderSources.h).
struct ProvidedShader {
  const char *label, *vertex, *fragment;
  const char* defines = "";
};

class Programs {
 public:
  // From then on `shader`, one of hair, has that text; before, it cannot be used. Kept by reference.
  static void provide(Shader shader, const ProvidedShader& text);

  // Lets the driver compile it while the program goes on; use() waits for it.
  void begin(Shader shader, VariantBits variant);
  // Whether use() need not wait for any that was begun.
  bool ready() const;
  // The program, bound for use, until the next is begun; null where the driver refuses a shader of it, which error() then tells.
  [[nodiscard]] const gl::Program* use(Shader shader, VariantBits variant);
  const Error& error() const { return error_; }

 private:
  struct Entry {
    Shader shader;
    VariantBits variant;
    gl::Program program;
    bool finished = false;
  };
  std::vector<Entry>::iterator find(Shader shader, VariantBits variant);
  [[nodiscard]] bool finish(gl::Program& program);

  std::vector<Entry> programs_;  // some dozens
  Error error_{};
};

// The variants that the renderer can ask for (Look.h), of those with paint, with Sheppard's bend and with borders a sample: a test
// compiles them all.
std::vector<std::pair<Shader, VariantBits>> allVariants();

}  // namespace fur::render
