#include "render/passes/shadow/FurShadow.h"

#include <functional>

#include "geometry/Primitives.h"
#include "hair/VolumeShadow.h"
#include "render/ShaderSources.h"
#include "render/ShaderText.h"
#include "shared/Blocks.h"
#include "tests/render/TwinPicture.h"

namespace fur::render {
namespace {

constexpr Vec3 kCentre(0.1f, 0.5f, -0.05f);
constexpr float kRadius = 0.3f;

// A sphere over a square of ground, or the ground alone, with a coat of given coverage, and a light on both.
class Lit {
 public:
  Lit(Shadows shadows, const Vec3& light, float furLength, bool withSphere,
      std::span<const std::uint8_t> coverage)
      : stage_(FUR_TWIN_SIZE, FUR_TWIN_SIZE) {
    settings_.shadows = static_cast<int>(shadows);
    settings_.furLength = furLength;
    addGround();
    if (withSphere) addSphere();
    upload(light);
    // One texel a layer.
    tile_ = gl::Texture({gl::TexelFormat::R8, 1, 1, static_cast<int>(coverage.size()), gl::Filter::Nearest, true},
                        std::as_bytes(coverage));
    const std::vector<Vec4> rest(FUR_BEND_ROW * 8, Vec4(0, 0, 0, 1));
    bends_ =
        gl::Texture({gl::TexelFormat::RGBA32F, FUR_BEND_ROW, 8, 0, gl::Filter::Nearest}, gl::bytesOf(rest));
    tile_.bind(FUR_UNIT_COVERAGE);
    bends_.bind(FUR_UNIT_BEND);
    update();
  }

  void update(unsigned long scene = 1, int size = 256) {
    coatBlock_.bindAsBlock(FUR_COAT_BINDING);
    frameBlock_.bindAsBlock(FUR_FRAME_BINDING);
    FurShadow::Key key = key_;
    key.scene = scene;
    key.size = size;
    EXPECT_TRUE(shadow_.update(programs_, key, surface_, static_cast<int>(indices_.size()), HairPass())) << programs_.error().message;
  }

  // Calls `check` with points of that height and what the shaders say of them.
  void probe(float height, const std::function<void(const Vec3& point, float light)>& check) {
    frame_.eye = Vec4(0, height, 0, 1);
    frameBlock_.update(gl::bytesOf(frame_));
    stage_.attachTarget();
    const bool layers = settings_.shadows == static_cast<int>(Shadows::Layers);
    const auto program = gl::Program::link(
        "probe", stageText(shaders::kScreenVert), stageText(shaders::kTwinsFrag),
        std::string("#define FUNCTION 11\n#define SHADOW_") + (layers ? "LAYERS" : "DEPTH") + " 1\n");
    ASSERT_TRUE(program) << (program ? "" : program.error().message);
    program.value().bindSampler("firstSurfaces", FUR_UNIT_SHADOW);
    program.value().bindSampler("opacities", FUR_UNIT_OPACITY);
    const test::Picture picture = test::drawTwin(stage_, program.value());
    for (int y = 0; y < FUR_TWIN_SIZE; ++y)
      for (int x = 0; x < FUR_TWIN_SIZE; ++x) {
        const Vec2 at = Vec2(x, y) / static_cast<float>(FUR_TWIN_SIZE - 1) * 2.0f - 1.0f;
        check({at.x, height, at.y}, test::twinValue(picture, x, y));
      }
  }

  const VolumeShadow& shadowing() const { return key_.volume; }
  const FurShadow& shadow() const { return shadow_; }

 private:
  struct Vertex {
    Vec3 position, normal;
  };
  void addGround() {
    for (const Vec2 corner : {Vec2(-0.7f), Vec2(0.7f, -0.7f), Vec2(-0.7f, 0.7f), Vec2(0.7f)})
      vertices_.push_back({{corner.x, 0, corner.y}, {0, 1, 0}});
    indices_ = {0, 2, 1, 1, 2, 3};
  }
  void addSphere() {
    const auto first = static_cast<std::uint32_t>(vertices_.size());
    const geometry::Mesh sphere = geometry::makeSphere();
    for (std::size_t i = 0; i < sphere.positions.size(); ++i)
      vertices_.push_back({kCentre + kRadius * sphere.positions[i], sphere.normals[i]});
    for (const std::uint32_t i : sphere.indices) indices_.push_back(first + i);
  }
  void upload(const Vec3& light) {
    static constexpr gl::Attribute kAttributes[] = {{FUR_POSITION, 3, 0}, {FUR_NORMAL, 3, sizeof(Vec3)}};
    vertexBuffer_ = gl::Buffer(gl::BufferKind::Vertex, gl::bytesOf(vertices_), false);
    indexBuffer_ = gl::Buffer(gl::BufferKind::Index, gl::bytesOf(indices_), false);
    surface_ = gl::VertexArray(vertexBuffer_, sizeof(Vertex), kAttributes, 0, &indexBuffer_);
    key_ = {static_cast<Shadows>(settings_.shadows), 256, lightFromModel(glm::normalize(light), shadowRadius(settings_.furLength)),
            volumeShadow(settings_, 0.5f), kPlain, 0, Vec4(0), Mat4(1)};
    key_.fill(frame_);
    shared::FurBlock coat{};
    coat.furLength = settings_.furLength;
    coat.tilesPerUnit = coat.tileTexels = 1;
    coat.layers = 16;
    coat.storedLayers = 8;
    coat.typeDensity.x = 0.5f;
    frameBlock_ = gl::Buffer(gl::BufferKind::Uniform, gl::bytesOf(frame_), true);
    coatBlock_ = gl::Buffer(gl::BufferKind::Uniform, gl::bytesOf(coat), true);
  }

  test::Stage stage_;
  settings::Settings settings_;
  Programs programs_;
  FurShadow shadow_;
  std::vector<Vertex> vertices_;
  std::vector<std::uint32_t> indices_;
  FurShadow::Key key_{};
  shared::FrameBlock frame_{};
  gl::Buffer vertexBuffer_, indexBuffer_, frameBlock_, coatBlock_;
  gl::VertexArray surface_;
  gl::Texture tile_, bends_;
};

constexpr std::uint8_t kBare[8] = {};

// How far from the sphere's centre the ray to the light passes, and the way to the sphere's lit side.
struct Ray {
  float miss, way;
};
Ray toSphere(const Vec3& point, const Vec3& light) {
  const Vec3 from = point - kCentre;
  const float along = glm::dot(from, light);
  const float miss = glm::length(from - along * light);
  return {miss, std::sqrt(std::max(kRadius * kRadius - miss * miss, 0.0f)) - along};
}

TEST(FurShadow, OfASphereFallsOnThePlaneWhereGeometrySays) {
  for (const Vec3 light :
       {glm::normalize(Vec3(0.4f, 1, 0.3f)), Vec3(0, 1, 0), glm::normalize(Vec3(-1, 0.9f, 0.2f))}) {
    Lit lit(Shadows::Depth, light, 0, true, kBare);
    int dark = 0, bright = 0;
    lit.probe(0, [&](const Vec3& point, float value) {
      if (std::max(std::abs(point.x), std::abs(point.z)) > 0.65f) return;
      const Ray ray = toSphere(point, light);
      // Five texels of blur and the sphere's facets.
      if (std::abs(ray.miss - kRadius) < 0.06f) return;
      const float depth = ray.miss < kRadius ? std::max(ray.way - lit.shadowing().bias, 0.0f) : 0;
      EXPECT_NEAR(value, hair::transmittance(lit.shadowing().extinction / 1.442695f, depth), 0.02f)
          << point.x << ' ' << point.z;
      (value < 0.1f ? dark : bright) += 1;
    });
    EXPECT_GT(dark, 20);
    EXPECT_GT(bright, 100);
  }
}

TEST(FurShadow, OfASphereInLayersFallsThereToo) {
  const Vec3 light = glm::normalize(Vec3(0.4f, 1, 0.3f));
  Lit lit(Shadows::Layers, light, 0.05f, true, kBare);
  lit.probe(0, [&](const Vec3& point, float value) {
    if (std::max(std::abs(point.x), std::abs(point.z)) > 0.65f) return;
    const float miss = toSphere(point, light).miss;
    if (std::abs(miss - kRadius) < 0.02f) return;  // two texels
    EXPECT_NEAR(value, miss < kRadius ? 0.0f : 1.0f, 0.01f) << point.x << ' ' << point.z;
  });
}

TEST(FurShadow, LeavesTheSideOfTheLightAloneAndDarkensTheOther) {
  for (const Shadows shadows : {Shadows::Depth, Shadows::Layers})
    for (const float y : {1.0f, -1.0f}) {
      Lit lit(shadows, {0, y, 0}, 0.05f, true, kBare);
      const auto near = [](const Vec3& p) {
        return glm::length(Vec2(p.x - kCentre.x, p.z - kCentre.z)) < 0.6f * kRadius;
      };
      lit.probe(kCentre.y + kRadius + 0.02f, [&](const Vec3& p, float value) {
        if (near(p)) EXPECT_NEAR(value, y > 0 ? 1.0f : 0.0f, 0.05f);
      });
    }
}

TEST(FurShadow, ALoneLayerOfStrandsDoesNotShadowItself) {
  const std::uint8_t tips[8] = {0, 0, 0, 0, 0, 0, 0, 255};
  const float length = 0.2f;
  for (const Vec3 light : {Vec3(0, 1, 0), glm::normalize(Vec3(0.6f, 1, 0.1f))}) {
    Lit lit(Shadows::Layers, light, length, false, tips);
    const auto inside = [](const Vec3& p) { return std::max(std::abs(p.x), std::abs(p.z)) < 0.5f; };
    for (const float above : {0.0f, 0.01f, 0.1f})
      lit.probe(length + above, [&](const Vec3& p, float value) {
        if (inside(p)) EXPECT_EQ(std::lround(value * 255), 255);
      });
    // It does those below: one shell of eight, which all together take 0.72 of what is dark.
    lit.probe(0.3f * length, [&](const Vec3& p, float value) {
      if (inside(p)) EXPECT_NEAR(value, hair::transmittance(5, 0.09f), 0.01f);
    });
  }
  Lit depth(Shadows::Depth, {0, 1, 0}, length, false, tips);
  depth.probe(0.6f * length, [&](const Vec3& p, float value) {
    if (std::max(std::abs(p.x), std::abs(p.z)) < 0.5f) EXPECT_EQ(std::lround(value * 255), 255);
  });
}

TEST(FurShadow, LooksOpacityUpAsItsTwin) {
  // Sixteen layers alike in all texels, from a first surface at 0.3 of a range of 2 on; depth runs along x.
  test::Stage stage(FUR_TWIN_SIZE, FUR_TWIN_SIZE);
  constexpr int kLayers = 4 * FUR_SHADOW_TARGETS, kTexels = 16;
  std::vector<double> sigma;
  std::vector<std::uint8_t> texels;
  for (int i = 0; i < kLayers; ++i) sigma.push_back(static_cast<double>(i * i) / 255.0);
  for (int target = 0; target < FUR_SHADOW_TARGETS; ++target)
    for (int texel = 0; texel < kTexels * kTexels; ++texel)
      for (int k = 0; k < 4; ++k) texels.push_back(static_cast<std::uint8_t>((4 * target + k) * (4 * target + k)));
  std::vector<std::uint8_t> depths;
  for (int texel = 0; texel < kTexels * kTexels; ++texel) depths.insert(depths.end(), {76, 127, 255, 255});
  const gl::Texture opacities({gl::TexelFormat::RGBA8, kTexels, kTexels, FUR_SHADOW_TARGETS, gl::Filter::Nearest}, std::as_bytes(std::span(texels)));
  const gl::Texture first({gl::TexelFormat::RGBA8, kTexels, kTexels, 0, gl::Filter::Nearest}, std::as_bytes(std::span(depths)));
  shared::FrameBlock frame{};
  frame.lightFromModel = Mat4(0.0f);
  frame.lightFromModel[0] = Vec4(0, 0, 1, 0);     // depth: 1 + x
  frame.lightFromModel[3] = Vec4(0.5f, 0.5f, 1, 1);
  frame.shadowRange = 2, frame.shadowLayerDepth = 0.08f, frame.shadowExtinction = 1.442695f;
  const gl::Buffer block(gl::BufferKind::Uniform, gl::bytesOf(frame), true);
  block.bindAsBlock(FUR_FRAME_BINDING);
  opacities.bind(FUR_UNIT_OPACITY);
  first.bind(FUR_UNIT_SHADOW);
  const auto program = gl::Program::link("lookup", stageText(shaders::kScreenVert), stageText(shaders::kTwinsFrag), "#define FUNCTION 11\n#define SHADOW_LAYERS 1\n");
  ASSERT_TRUE(program);
  program.value().bindSampler("firstSurfaces", FUR_UNIT_SHADOW);
  program.value().bindSampler("opacities", FUR_UNIT_OPACITY);
  const test::Picture picture = test::drawTwin(stage, program.value());
  const float surface = 2 * (76.0f + 127.0f / 255.0f) / 255.0f;
  for (int x = 0; x < FUR_TWIN_SIZE; ++x) {
    const float depth = 2 * static_cast<float>(x) / (FUR_TWIN_SIZE - 1);
    // A layer less deep than it lies.
    const float z = depth - surface - frame.shadowLayerDepth;
    EXPECT_NEAR(test::twinValue(picture, x, 3), hair::transmittance(1, hair::opacityLookup(sigma, z, frame.shadowLayerDepth)), 1e-3f) << depth;
  }
}

TEST(FurShadow, DeepensWithTheFurAbove) {
  const std::uint8_t full[8] = {255, 255, 255, 255, 255, 255, 255, 255};
  for (const Shadows shadows : {Shadows::Depth, Shadows::Layers}) {
    Lit lit(shadows, {0, 1, 0}, 0.2f, false, full);
    float last = 2;
    for (const float h : {1.0f, 0.6f, 0.3f, 0.0f}) {
      float middle = 0;
      lit.probe(h * 0.2f, [&](const Vec3& p, float value) {
        if (p.x == 0 && p.z == 0) middle = value;
      });
      EXPECT_LE(middle, last);
      last = middle;
    }
    EXPECT_LT(last, 0.9f);
    EXPECT_GT(last, 0.02f) << "a coat's own depth leaves light to its roots";
  }
}

TEST(FurShadow, IsRedrawnOnlyWhenItsSceneChanges) {
  Lit lit(Shadows::Depth, {0, 1, 0}, 0.1f, true, kBare);
  for (int i = 0; i < 5; ++i) lit.update();
  EXPECT_EQ(lit.shadow().redraws(), 1);
  lit.update(2);
  EXPECT_EQ(lit.shadow().redraws(), 2);
}

TEST(FurShadow, InLayersIsAsLargeAsItIsAskedToBeAfterwards) {
  const auto shares = [](Lit& lit) {
    std::vector<float> out;
    lit.probe(0.3f, [&](const Vec3&, float light) { out.push_back(light); });
    return out;
  };
  Lit fresh(Shadows::Layers, {0.3f, 1, 0}, 0.1f, true, kBare), resized(Shadows::Layers, {0.3f, 1, 0}, 0.1f, true, kBare);
  resized.update(2, 32);
  EXPECT_NE(shares(resized), shares(fresh));
  resized.update(3, 256);
  EXPECT_EQ(shares(resized), shares(fresh));
}

TEST(LightFromModel, HoldsTheSphereAndMeasuresDepthInModelUnits) {
  for (const Vec3 light : {Vec3(0, 1, 0), Vec3(0, -1, 0), glm::normalize(Vec3(1, 2, -3)), Vec3(1, 0, 0)}) {
    const Mat4 m = lightFromModel(light, 1.2f);
    const auto at = [&](const Vec3& p) { return Vec3(m * Vec4(p, 1)); };
    for (const Vec3 p : {Vec3(1, 0, 0), Vec3(0, -1, 0), Vec3(0, 0, 1), glm::normalize(Vec3(-1, 1, 1))}) {
      EXPECT_TRUE(at(p).x > 0 && at(p).x < 1 && at(p).y > 0 && at(p).y < 1 && at(p).z > 0 && at(p).z < 2.4f);
      EXPECT_NEAR(at(p).z - at(p + 0.3f * light).z, 0.3f, 1e-5f);
      EXPECT_NEAR(glm::length(Vec2(at(p + 0.3f * light) - at(p))), 0, 1e-5f);
    }
  }
}

}  // namespace
}  // namespace fur::render
