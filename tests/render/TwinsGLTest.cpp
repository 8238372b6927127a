// Every formula that runs on the GPU has a C++ twin; here both are evaluated over a grid.
#include <cmath>
#include <functional>

#include "dynamics/BendField.h"
#include "furgen/Strand.h"
#include "hair/Marschner.h"
#include "hair/StrandShading.h"
#include "render/ShaderSources.h"
#include "render/ShaderText.h"
#include "render/StrandTables.h"
#include "shared/Blocks.h"
#include "tests/render/TwinPicture.h"
#include "wet/Clump.h"

namespace fur::render {
namespace {

using Twin = std::function<float(float, float)>;

// The settings under which those functions are compared that read them.
const hair::StrandLook kLook{.lambert = 0.4f, .specular = 0.45f, .shininess = 60, .dryShininess = 12, .strandShadow = 0.6f,
                                .occlusion = 0.7f, .wetDarkening = 0.4f, .wetGloss = 0.8f, .density = 0.5f};
constexpr float kLightIntensity = 2.2f, kExposure = 1.3f;
constexpr float kFillLight = 0.35f;
const Vec3 kKeyLight(2.0f, 1.5f, 1.0f), kBackLight(0.8f, 0.6f, 0.4f);
constexpr float kLayers = 32, kClumpShape = 0.6f, kClumpRadius = 0.2f;
const Vec3 kSky(0.3f, 0.25f, 0.2f), kFloorLight(0.1f, 0.15f, 0.2f);

shared::FrameBlock frameOfLook() {
  shared::FrameBlock frame{};
  frame.lightIntensity = kLightIntensity;
  frame.keyLight = Vec4(kKeyLight, 1);
  frame.fillLight = kFillLight;
  frame.backLight = Vec4(kBackLight, 1);
  frame.exposure = kExposure;
  frame.sky = Vec4(kSky, 1);
  frame.floorLight = Vec4(kFloorLight, 1);
  return frame;
}
shared::FurBlock coatOfLook() {
  shared::FurBlock coat{};
  coat.typeDensity.x = kLook.density;
  coat.lambert = kLook.lambert;
  coat.typeSpecular.x = kLook.specular;
  coat.typeShininess.x = kLook.shininess;
  coat.typeDryShininess.x = kLook.dryShininess;
  coat.typeShadow.x = kLook.strandShadow;
  coat.typeOcclusion.x = kLook.occlusion;
  coat.layers = kLayers;
  coat.layersLog = std::log(coat.layers);
  coat.clumpShape = kClumpShape;
  coat.clumpRadius = kClumpRadius;
  coat.wetDarkening = kLook.wetDarkening;
  coat.wetGloss = kLook.wetGloss;
  return coat;
}

Vec3 onCircle(float angle) { return {std::sin(angle), 0, std::cos(angle)}; }

// The largest difference between FUNCTION of twins.frag and the twin, over [0, 1]^2.
float largestDifference(int function, const Twin& twin) {
  test::Stage stage(FUR_TWIN_SIZE, FUR_TWIN_SIZE);
  const auto program = gl::Program::link("twins", stageText(shaders::kScreenVert), stageText(shaders::kTwinsFrag),
                                         "#define FUNCTION " + std::to_string(function) + "\n");
  EXPECT_TRUE(program) << (program ? "" : program.error().message);
  const shared::FrameBlock frame = frameOfLook();
  shared::FurBlock coat = coatOfLook();
  settings::Settings settings;
  settings.strandModel = 1;
  StrandTables tables;
  tables.use(settings);
  program.value().bindSampler("strandM", FUR_UNIT_STRAND_M);
  program.value().bindSampler("strandN", FUR_UNIT_STRAND_N);
  coat.lobePeak = 1 / (strandLobeWidth(settings) * std::sqrt(2 * kPi));
  const gl::Buffer frameBlock(gl::BufferKind::Uniform, gl::bytesOf(frame), true);
  const gl::Buffer coatBlock(gl::BufferKind::Uniform, gl::bytesOf(coat), true);
  frameBlock.bindAsBlock(FUR_FRAME_BINDING);
  coatBlock.bindAsBlock(FUR_COAT_BINDING);
  const test::Picture picture = test::drawTwin(stage, program.value());
  float worst = 0;
  for (int y = 0; y < FUR_TWIN_SIZE; ++y)
    for (int x = 0; x < FUR_TWIN_SIZE; ++x) {
      const float value = test::twinValue(picture, x, y);
      const float u = static_cast<float>(x) / (FUR_TWIN_SIZE - 1), v = static_cast<float>(y) / (FUR_TWIN_SIZE - 1);
      worst = std::max(worst, std::abs(value - twin(u, v)));
    }
  return worst;
}

// GPUs evaluate sin, log and pow to about 2^-11 of full scale at worst (GLSL ES 3.00, 4.5.1 leaves it
// open; llvmpipe's polynomials are at 1e-4); a wrong formula is off by far more.
constexpr float kGpuPrecision = 5e-4f;

TEST(Twins, ArcOfConstantLength) {
  EXPECT_LT(largestDifference(0, [](float u, float v) { return dynamics::arcBend(u * 1.35f, v).x; }), kGpuPrecision);
  EXPECT_LT(largestDifference(1, [](float u, float v) { return dynamics::arcBend(u * 1.35f, v).y; }), kGpuPrecision);
}

TEST(Twins, SheppardsPolynomial) {
  static_assert(static_cast<float>(FUR_MAX_BEND) == dynamics::kMaxBend);
  EXPECT_LT(largestDifference(19, [](float u, float v) { return dynamics::windBend(u, v).x; }), kGpuPrecision);
  EXPECT_LT(largestDifference(20, [](float u, float v) { return dynamics::windBend(u, v).y; }), kGpuPrecision);
}

TEST(Twins, ClumpProfile) {
  EXPECT_LT(largestDifference(2, [](float u, float v) { return wet::clumpProfile(glm::mix(1 / 32.0f, 1.0f, u), v, 32); }),
            kGpuPrecision);
}

TEST(Twins, StrandsOfAClump) {
  EXPECT_LT(largestDifference(38, [](float u, float v) { return wet::lockPull(u, 1.5f * v, wet::sheetOf(v)); }), kGpuPrecision);
  EXPECT_LT(largestDifference(53, [](float u, float v) { return wet::tuftPull(u, wet::tuftsOf(v, glm::mix(0.5f, 4.0f, u) * kClumpRadius, kClumpRadius), {3.3f, 5.7f}); }), kGpuPrecision);
  EXPECT_LT(largestDifference(54, wet::lockSheet), kGpuPrecision);
  EXPECT_LT(largestDifference(55, [](float u, float) { return wet::locksInClump(u); }), kGpuPrecision);
  EXPECT_LT(largestDifference(13, [](float u, float v) { return wet::clumpPull(glm::mix(1 / kLayers, 1.0f, u), kClumpShape, kLayers, v); }), kGpuPrecision);
  EXPECT_LT(largestDifference(14, wet::alongStrand), kGpuPrecision);
  EXPECT_LT(largestDifference(17, [](float u, float v) { return wet::wetLean(u, v); }), kGpuPrecision);
  EXPECT_LT(largestDifference(21, [](float u, float) { return wet::upright(u); }), kGpuPrecision);
  EXPECT_LT(largestDifference(52, [](float u, float v) { return wet::wetTop(glm::mix(0.5f, 1.0f, u), v, 0.5f * u, wet::sheetOf(v)); }), kGpuPrecision);
  EXPECT_LT(largestDifference(22, [](float u, float v) { return wet::rimTaper(u, wet::sheetOf(u), 1.5f * v); }), kGpuPrecision);
  EXPECT_LT(largestDifference(33, [](float u, float v) { return wet::sheetOf(u, v); }), kGpuPrecision);
  EXPECT_LT(largestDifference(34, [](float u, float) { return wet::shortnessOf(u, kClumpRadius); }), kGpuPrecision);
  EXPECT_LT(largestDifference(18, [](float u, float v) { return wet::clumpingWetness(u, 3 * v, v - 0.5f); }), kGpuPrecision);
}

TEST(Twins, ClumpsOfASheetNearToTheEye) {
  EXPECT_LT(largestDifference(46, [](float u, float) { return wet::litLower(1.2f * u); }), kGpuPrecision);
  EXPECT_LT(largestDifference(41, wet::nearSheet), kGpuPrecision);
  EXPECT_LT(largestDifference(44, [](float u, float v) { return wet::clumpsClosed(0.2f * u, 0.3f, v); }), kGpuPrecision);
  EXPECT_LT(largestDifference(42, [](float u, float v) { return wet::liesBy(wet::chanceOfClump(0.005f * Vec2(u, v)), v, u); }), kGpuPrecision);
}

TEST(Twins, SizeAndRunOfABead) {
  EXPECT_LT(largestDifference(40, wet::beadSize), kGpuPrecision);
  EXPECT_LT(largestDifference(45, wet::beadRun), kGpuPrecision);
}

TEST(Twins, PlaceOnALock) {
  const auto on = [](float u, float v) { return wet::onLock(Vec2(u - 0.1f, 0.2f - 0.4f * v), Vec2(1, 0.2f), 0.6f); };
  EXPECT_LT(largestDifference(35, [&](float u, float v) { return on(u, v).x; }), kGpuPrecision);
  EXPECT_LT(largestDifference(36, [&](float u, float v) { return glm::clamp(on(u, v).y, -1.0f, 1.0f); }), kGpuPrecision);
}

TEST(Twins, WaterOnStrands) {
  EXPECT_LT(largestDifference(39, [](float u, float v) { return 0.4f * hair::clumpShade(2 * u - 1, 2 * v - u, 1 - u * v, v, 1.2f * v, wet::sheetOf(u)); }), kGpuPrecision);
  EXPECT_LT(largestDifference(51, [](float u, float) { return hair::mirroredSky(u) - 2; }), kGpuPrecision);
  EXPECT_LT(largestDifference(15, [](float u, float v) { return hair::wetAlbedo(Vec3(u), v).x; }), kGpuPrecision);
  EXPECT_LT(largestDifference(47, [](float u, float v) { return hair::wetCoatAlbedo(Vec3(u), v).x; }), kGpuPrecision);
  EXPECT_LT(largestDifference(48, [](float u, float v) { return hair::passedOn(1.3f * u, Vec3(0.8f * v)).x; }), kGpuPrecision);
  const auto mirrored = [](float u, float v) {
    const Vec2 shares = hair::waterGloss(onCircle(3 * u), hair::clumpNormal(Vec2(v, 0), 0.4f), onCircle(0.7f), onCircle(-0.4f), 0.9f, 0.4f,
                                         kLook.wetGloss, kLook.shininess, u, 0.3f + 0.7f * v);
    return 0.25f * (shares.x + shares.y);
  };
  EXPECT_LT(largestDifference(16, mirrored), 2 * kGpuPrecision);
}

TEST(Twins, HeightOfAStrandWhereTypesMeet) {
  // Up to 2, where the fixed point ends.
  EXPECT_LT(largestDifference(12, [](float u, float v) { return std::min(furgen::standsUpTo(u, glm::mix(0.5f, 1.0f, v)), 1.9999995f); }),
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

TEST(Twins, SrgbDecodingIsWithinAnEightBitStep) {
  const auto exact = [](float u, float) { return u <= 0.04045f ? u / 12.92f : std::pow((u + 0.055f) / 1.055f, 2.4f); };
  EXPECT_LT(largestDifference(23, exact), 0.003f);
}

// Light and eye of twins.frag, about the strand (1, 0, 0).
Vec3 eyeOf(float v) { return {std::sin(3 * v), 0.6f * std::cos(3 * v), 0.8f * std::cos(3 * v)}; }

TEST(Twins, KajiyaAndKay) {
  EXPECT_LT(largestDifference(5, [](float u, float v) { return hair::kajiyaLobe(u * 2 - 1, v * 60); }), kGpuPrecision);
  const auto shifted = [](float u, float v) {
    return hair::shiftedCosine({1, 0, 0}, onCircle(3 * u), eyeOf(v), hair::lobeShifts(u).y);
  };
  // The shader takes a shift of up to 0.35 for its sine and 1 - x^2 / 2 for its cosine.
  EXPECT_LT(largestDifference(6, shifted), 0.35f * 0.35f * 0.35f / 6 + kGpuPrecision);
  EXPECT_LT(largestDifference(10, [](float u, float v) { return hair::rimLight(u * 2 - 1, v * 2 - 1, 0.7f); }), kGpuPrecision);
}

TEST(Twins, EquationsAsPrinted) {
  EXPECT_LT(largestDifference(29, [](float u, float v) { return hair::kajiyaPower(u * 2 - 1, v * 60); }), kGpuPrecision);
  EXPECT_LT(largestDifference(30, [](float u, float v) { return wet::clumpDisplacement(glm::mix(1 / kLayers, 1.0f, u), kClumpShape, kLayers, v); }), kGpuPrecision);
  const Vec3 sky = glm::mix(kFloorLight, kSky, 0.75f);
  EXPECT_LT(largestDifference(31, [&](float u, float v) {
    return hair::printedLight(kLook, Vec3(0.5f, 0.3f, 0.2f), Vec3(1), sky, u, 0.9f * v + 0.1f, v, u).x;
  }), 2 * kGpuPrecision);
}

TEST(Twins, MarschnerFromTablesIsMarschnersFormula) {
  const float width = strandLobeWidth({});
  const auto formula = [&](float u, float v) {
    return hair::marschnerStrand(Vec3(0.4f), {1, 0, 0}, onCircle(3 * u), eyeOf(v), width, 1).g;
  };
  // Bilinear look-ups between 128 texels under a lobe of 4 degrees, whose peak here is 1.7, and colour^way without
  // a power.
  EXPECT_LT(largestDifference(9, formula), 0.1f);
}

TEST(Twins, LightOnAStrand) {
  const Vec3 albedo(0.5f, 0.3f, 0.2f), light = onCircle(0.7f), view = onCircle(-0.4f);
  const auto shade = [&](float u, float v, float rho) {
    hair::StrandLight lights;
    lights.key = kKeyLight * hair::keyShare(kLook, v, light.z, 0.8f);
    lights.through = kKeyLight * (0.8f * hair::rimLight(glm::dot(light, view), view.z, v));
    lights.fill = kFillLight;
    lights.rim = kBackLight * hair::fringe(view.z, v);
    lights.sky = glm::mix(kFloorLight, kSky, 0.75f);
    return hair::shadeStrand(kLook, albedo, onCircle(3 * u), light, view, light.z, view.z, v, rho, lights, u).x;
  };
  // The sum of several terms, scaled by the light.
  EXPECT_LT(largestDifference(7, [&](float u, float v) { return shade(u, v, 0.3f); }), 2 * kLightIntensity * kGpuPrecision);
  // Of the technique `shells`, dry.
  EXPECT_LT(largestDifference(32, [&](float u, float v) { return shade(u, v, 0); }), 2 * kLightIntensity * kGpuPrecision);
}

TEST(Twins, ToneMap) {
  EXPECT_LT(largestDifference(8, [](float u, float) { return hair::toneMap(Vec3(3 * u), kExposure).x; }), kGpuPrecision);
}

}  // namespace
}  // namespace fur::render
