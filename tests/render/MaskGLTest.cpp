// The mask as wet/MaskEncoding.h writes it, read by the shaders' own functions (common_clump.glsl).
#include "core/Random.h"
#include "render/ShaderSources.h"
#include "render/ShaderText.h"
#include "shared/Blocks.h"
#include "tests/render/TwinPicture.h"
#include "tests/wet/FlatSkin.h"
#include "wet/Clump.h"
#include "wet/MaskEncoding.h"
#include "wet/SurfaceWetting.h"

namespace fur::render {
namespace {

// So that each pixel lies in a texel of its own.
constexpr int kSize = FUR_TWIN_SIZE;
constexpr int kFirstEnds = 14, kSecondBegins = 17, kSecondEnds = 27, kThirdBegins = 29;

// Three charts side by side, the first of number 5, the second with a number that goes round to that of the third.
struct Atlas {
  wet::WetnessMask mask{kSize};
  std::vector<std::uint16_t> charts;
  std::vector<std::uint8_t> skin;

  Atlas() {
    for (int i = 0; i < kSize * kSize; ++i) {
      const int x = i % kSize;
      charts.push_back(x < kFirstEnds ? 5 : x < kSecondBegins ? wet::SurfaceWetting::kNoChart : x < kSecondEnds ? 63 : x < kThirdBegins ? wet::SurfaceWetting::kNoChart : 127);
      skin.push_back(charts.back() != wet::SurfaceWetting::kNoChart);
    }
    Random random(9);
    for (int i = 0; i < 30; ++i)
      mask.addDroplet({Vec2(random.uniform(-0.1f, 1.1f), random.uniform(-0.1f, 1.1f)), random.uniform(0.05f, 0.3f), random.uniform(0.3f, 1.0f)});
    // Some soaked, with a film.
    for (int i = 0; i < kSize * 20; ++i) mask.set(static_cast<std::uint32_t>(i), Vec4(0.5f, 0.3f, 1.5f, 1), 0.5f);
  }
  wet::MaskTexels encoded() const {
    wet::WaterAround around = test::flatSkin(kSize, skin).around();
    around.update(mask, {});
    return wet::encodeMask(mask, {0, 0, kSize, kSize}, charts, &around);
  }
  bool onChart(int texel) const { return charts[static_cast<std::size_t>(texel)] != wet::SurfaceWetting::kNoChart; }
};

class EncodedMask : public testing::Test {
 protected:
  // The value of FUNCTION of twins.frag in every texel.
  std::vector<float> read(int function) {
    const auto program = gl::Program::link("twins", stageText(shaders::kScreenVert), stageText(shaders::kTwinsFrag),
                                           "#define FUNCTION " + std::to_string(function) + "\n");
    EXPECT_TRUE(program) << (program ? "" : program.error().message);
    gl::Texture texture({gl::TexelFormat::RGBA32F, kSize, kSize, 0, gl::Filter::Nearest, false}, gl::bytesOf(encoded.texels));
    texture.bind(FUR_UNIT_MASK);
    program.value().bindSampler("mask", FUR_UNIT_MASK);
    shared::FurBlock coat{};
    coat.maskTexels = kSize;
    const shared::FrameBlock frame{};
    const gl::Buffer coatBlock(gl::BufferKind::Uniform, gl::bytesOf(coat), true), frameBlock(gl::BufferKind::Uniform, gl::bytesOf(frame), true);
    coatBlock.bindAsBlock(FUR_COAT_BINDING);
    frameBlock.bindAsBlock(FUR_FRAME_BINDING);
    const test::Picture picture = test::drawTwin(stage, program.value());
    std::vector<float> values;
    for (int i = 0; i < kSize * kSize; ++i) values.push_back(test::twinValue(picture, i % kSize, i / kSize));
    return values;
  }
  float waterIn(int x, int y) const {
    const float w = encoded.texels[static_cast<std::size_t>(std::clamp(y, 0, kSize - 1) * kSize + std::clamp(x, 0, kSize - 1))].w;
    return w <= -1 ? -1 - w : w;
  }

  test::Stage stage{kSize, kSize};
  Atlas atlas;
  wet::MaskTexels encoded = atlas.encoded();
};

// Of the fixed point over [-2, 2).
constexpr float kRead = 4 / 16777216.0f;

TEST_F(EncodedMask, GivesTheShadersEachClumpCentreBack) {
  const std::vector<float> u = read(24);
  for (int i = 0; i < kSize * kSize; ++i)
    // The last bit of a float near FUR_CHART_STEP * FUR_CHART_NUMBERS = 256.
    if (atlas.onChart(i)) EXPECT_NEAR(u[i], atlas.mask.texels()[i].x, 1 / 32768.0f) << i;
}

TEST_F(EncodedMask, TellsTheShadersEachChart) {
  const std::vector<float> charts = read(25), besideFifth = read(26);
  for (int i = 0; i < kSize * kSize; ++i) {
    const float number = static_cast<float>(atlas.charts[i] % FUR_CHART_NUMBERS);
    if (atlas.onChart(i)) EXPECT_NEAR(charts[i], (number + 0.5f) / FUR_CHART_NUMBERS, kRead) << i;
    EXPECT_NEAR(besideFifth[i], atlas.charts[i] != 5, kRead) << i;
  }
}

TEST_F(EncodedMask, TellsTheShadersTheBordersBeyondGutters) {
  const std::vector<float> without = read(50);
  const auto numberOf = [](int i) { return i % 3 == 0 ? 0.0f : std::floor(static_cast<float>(i) * static_cast<float>(FUR_MOST_BORDERS) / (kSize * kSize)); };
  for (int i = 0; i < kSize * kSize; ++i) encoded.texels[i].y += static_cast<float>(FUR_BORDER_STEP) * numberOf(i);
  const std::vector<float> borders = read(49), v = read(50);
  for (int i = 0; i < kSize * kSize; ++i) {
    EXPECT_NEAR(borders[i] * static_cast<float>(FUR_MOST_BORDERS), numberOf(i), 0.01f) << i;
    // The last bit of a float near FUR_BORDER_STEP * FUR_MOST_BORDERS.
    EXPECT_NEAR(v[i], without[i], 1 / 1024.0f) << i;
  }
}

TEST_F(EncodedMask, TellsTheShadersTheWaterBetweenTexelsAndAcrossTheBordersOfCharts) {
  const std::vector<float> held = read(27);
  float least = 1;
  for (int i = 0; i < kSize * kSize; ++i) {
    const Vec2 at = Vec2(i % kSize, i / kSize) * (kSize / (kSize - 1.0f)) - 0.5f, corner = glm::floor(at), part = at - corner;
    const int x = static_cast<int>(corner.x), y = static_cast<int>(corner.y);
    // At the rim the shader takes the first two texels, whatever lies between them.
    if (x < 0 || y < 0) continue;
    const float expected = glm::mix(glm::mix(waterIn(x, y), waterIn(x + 1, y), part.x), glm::mix(waterIn(x, y + 1), waterIn(x + 1, y + 1), part.x), part.y);
    EXPECT_NEAR(held[i], expected, 1e-5f) << i;
    if (!atlas.onChart(i) && i < kSize * 19) least = std::min(least, held[i]);
  }
  EXPECT_GT(least, 0.1f) << "between two wet charts it is not dry";
}

TEST_F(EncodedMask, TellsTheShadersTheWaterByWhichFurLies) {
  const std::vector<float> lying = read(43);
  const auto lyingIn = [&](int x, int y) { return std::floor(encoded.texels[static_cast<std::size_t>(y * kSize + x)].z / static_cast<float>(FUR_LYING_STEP)) / static_cast<float>(FUR_LYING_STEPS); };
  float most = 0;
  for (int i = 0; i < kSize * kSize; ++i) {
    const Vec2 at = Vec2(i % kSize, i / kSize) * (kSize / (kSize - 1.0f)) - 0.5f, corner = glm::floor(at), part = at - corner;
    const int x = static_cast<int>(corner.x), y = static_cast<int>(corner.y);
    if (x < 0 || y < 0 || x + 1 >= kSize || y + 1 >= kSize) continue;
    const float expected = glm::mix(glm::mix(lyingIn(x, y), lyingIn(x + 1, y), part.x), glm::mix(lyingIn(x, y + 1), lyingIn(x + 1, y + 1), part.x), part.y);
    EXPECT_NEAR(lying[i], expected, 1e-5f) << i;
    most = std::max(most, lying[i]);
  }
  EXPECT_GT(most, 0.5f);
}

TEST_F(EncodedMask, IsASheetToTheShadersWhereItIsOneToTheEncoding) {
  const std::vector<float> sheet = read(28);
  int sheets = 0;
  for (int i = 0; i < kSize * kSize; ++i) {
    EXPECT_NEAR(sheet[i], wet::sheetOf(encoded.texels[i].w), 1e-5f) << i;
    sheets += sheet[i] > 0;
  }
  EXPECT_GT(sheets, 0);
  EXPECT_LT(sheets, kSize * kSize);
}

}  // namespace
}  // namespace fur::render
