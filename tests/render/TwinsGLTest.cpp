// Every formula that runs on the GPU has a C++ twin; here both are evaluated over a grid.
#include <cmath>
#include <functional>

#include "dynamics/BendField.h"
#include "hair/StrandShading.h"
#include "render/ShaderSources.h"
#include "shared/Blocks.h"
#include "tests/render/Picture.h"
#include "wet/Clump.h"

namespace fur::render {
namespace {

using Twin = std::function<float(float, float)>;

// The largest difference between FUNCTION of twins.frag and the twin, over [0, 1]^2.
float largestDifference(int function, const Twin& twin) {
  test::Stage stage(FUR_TWIN_SIZE, FUR_TWIN_SIZE);
  const auto program = gl::Program::link("twins", shaders::kScreenVert, shaders::kTwinsFrag,
                                         "#define FUNCTION " + std::to_string(function) + "\n");
  EXPECT_TRUE(program) << (program ? "" : program.error().message);
  const shared::FrameBlock frame{};
  const shared::FurBlock coat{};
  const gl::Buffer frameBlock(gl::BufferKind::Uniform, gl::bytesOf(frame), true);
  const gl::Buffer coatBlock(gl::BufferKind::Uniform, gl::bytesOf(coat), true);
  frameBlock.bindAsBlock(FUR_FRAME_BINDING);
  coatBlock.bindAsBlock(FUR_COAT_BINDING);
  program.value().bindBlock("FrameBlock", FUR_FRAME_BINDING);
  program.value().bindBlock("FurBlock", FUR_COAT_BINDING);
  program.value().use();
  gl::setViewport(FUR_TWIN_SIZE, FUR_TWIN_SIZE);
  gl::apply({.depthTest = false, .depthWrite = false, .cullBack = false});
  gl::drawWithoutVertices(3);
  const test::Picture picture = stage.read();
  float worst = 0;
  for (int y = 0; y < FUR_TWIN_SIZE; ++y)
    for (int x = 0; x < FUR_TWIN_SIZE; ++x) {
      const std::uint8_t* p = picture.at(x, FUR_TWIN_SIZE - 1 - y);  // rows come from the top
      const float value = static_cast<float>((p[0] << 16) | (p[1] << 8) | p[2]) / 16777216.0f * 4 - 2;
      const float u = static_cast<float>(x) / (FUR_TWIN_SIZE - 1), v = static_cast<float>(y) / (FUR_TWIN_SIZE - 1);
      worst = std::max(worst, std::abs(value - twin(u, v)));
    }
  return worst;
}

Vec3 onCircle(float angle) { return {std::sin(angle), 0, std::cos(angle)}; }

// GPUs evaluate sin, log and pow to about 2^-11 of full scale at worst (GLSL ES 3.00, 4.5.1 leaves it
// open; llvmpipe's polynomials are at 1e-4); a wrong formula is off by far more.
constexpr float kGpuPrecision = 5e-4f;

TEST(Twins, ArcOfConstantLength) {
  EXPECT_LT(largestDifference(0, [](float u, float v) { return dynamics::arcBend(u * 1.35f, v).x; }), kGpuPrecision);
  EXPECT_LT(largestDifference(1, [](float u, float v) { return dynamics::arcBend(u * 1.35f, v).y; }), kGpuPrecision);
}

TEST(Twins, ClumpProfile) {
  EXPECT_LT(largestDifference(2, [](float u, float v) { return wet::clumpProfile(glm::mix(1 / 32.0f, 1.0f, u), v, 32); }),
            kGpuPrecision);
}

TEST(Twins, FurShadow) {
  EXPECT_LT(largestDifference(3, [](float u, float v) { return hair::furShadow(u, 0.6f, v * 2 - 1); }), kGpuPrecision);
}

TEST(Twins, SrgbEncodingIsWithinAThirdOfAnEightBitStep) {
  const auto exact = [](float u, float) {
    return u <= 0.0031308f ? 12.92f * u : 1.055f * std::pow(u, 1 / 2.4f) - 0.055f;
  };
  // The fit's own error, named in common_shading.glsl.
  EXPECT_LT(largestDifference(4, exact), 0.0015f);
}

TEST(Twins, KajiyaAndKay) {
  EXPECT_LT(largestDifference(5, [](float u, float v) { return hair::kajiyaDiffuse(onCircle(3 * u), onCircle(3 * v)); }),
            kGpuPrecision);
  EXPECT_LT(largestDifference(6,
                              [](float u, float v) {
                                return hair::kajiyaSpecular({1, 0, 0}, onCircle(3 * u), onCircle(3 * v), 12);
                              }),
            kGpuPrecision);
}

}  // namespace
}  // namespace fur::render
