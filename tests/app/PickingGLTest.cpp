// Tools reach what is seen: every pixel that fur covers, and nothing beside it.
#include <string>

#include "core/PortableMath.h"
#include "tests/geometry/Solids.h"
#include "tests/render/Picture.h"

namespace fur::app {
namespace {

using Fields = std::initializer_list<std::pair<const char*, const char*>>;

// A body with two thin ears and folds between them.
std::vector<std::uint8_t> animal() {
  geometry::Mesh mesh = geometry::makeSphere(48, 32);
  mesh.uv.clear();
  mesh.normals.clear();
  for (Vec3& p : mesh.positions) {
    const float ear = std::max(0.0f, 1 - 14 * ((std::abs(p.x) - 0.35f) * (std::abs(p.x) - 0.35f) + p.z * p.z));
    if (p.y > 0) p.y += 0.9f * ear * ear;
    p.z += 0.25f * portableSin(4 * p.y);
  }
  return scene::exportGlb(mesh, "animal");
}

struct Zoo {
  test::Stage stage{kSide, kSide, 4};
  App app;
  static constexpr int kSide = 128;
  std::vector<float> cover;  // of each pixel

  explicit Zoo(const std::string& model, Fields fields = {}) {
    stage.attach(app);
    if (model == "box") EXPECT_TRUE(app.loadModel(scene::exportGlb(geometry::test::makeBox(1, 0.7f, 0.5f), "box"), "box.glb"));
    else if (model == "animal") EXPECT_TRUE(app.loadModel(animal(), "animal.glb"));
    else EXPECT_TRUE(app.loadPrimitive(model));
    set({{"ground", "false"}, {"dryRate", "0"}, {"breath", "0"}});
    set(fields);
    app.settle();
  }
  ~Zoo() { app.detach(false); }

  void set(Fields fields) {
    for (const auto& [name, value] : fields) EXPECT_TRUE(app.setField(name, value)) << name;
  }
  // What of a white background and of a black one does not show.
  void look() {
    test::Picture pictures[2];
    for (int white = 0; white < 2; ++white) {
      const char* color = white ? "#ffffff" : "#000000";
      set({{"backgroundTop", color}, {"backgroundBottom", color}});
      pictures[white] = stage.draw(app);
    }
    cover.clear();
    for (int i = 0; i < kSide * kSide; ++i) {
      int difference = 0;
      for (int k = 0; k < 3; ++k) difference += pictures[1].rgba[4 * i + k] - pictures[0].rgba[4 * i + k];
      cover.push_back(1 - static_cast<float>(difference) / 765.0f);
    }
  }
  float coverAt(int x, int y) const { return x < 0 || y < 0 || x >= kSide || y >= kSide ? 0 : cover[y * kSide + x]; }
  bool bareRound(int x, int y, int radius) const {
    for (int dy = -radius; dy <= radius; ++dy)
      for (int dx = -radius; dx <= radius; ++dx)
        if (coverAt(x + dx, y + dy) > 0.1f) return false;
    return true;
  }
  void expectReached(const std::string& what) {
    look();
    int covered = 0, missed = 0, bare = 0, caught = 0;
    for (int y = 0; y < kSide; ++y)
      for (int x = y % 3; x < kSide; x += 3) {  // a third of the pixels
        const bool hit = app.pick(Vec2(x, y) + 0.5f).has_value();
        if (coverAt(x, y) >= 0.5f) ++covered, missed += !hit;
        else if (bareRound(x, y, 3)) ++bare, caught += hit;
      }
    // Long fur past the rim of a sheet is seen from its side, where the coat has no outside.
    EXPECT_LE(missed, covered / (what == "plane shag" ? 50 : 100)) << what << ": of " << covered;
    EXPECT_LE(caught, bare / 100) << what << ": of " << bare;
  }
};

const char* const kModels[] = {"sphere", "torus", "plane", "box", "animal"};

TEST(Picking, ToolsReachEveryPixelThatFurCoversAndNothingBeside) {
  for (const std::string model : kModels) {
    Zoo zoo(model);
    zoo.expectReached(model + " dry");
    zoo.app.setWetness(1);
    zoo.app.settle();
    zoo.expectReached(model + " soaked");
    zoo.app.setWetness(0.6f);
    zoo.app.settle();
    zoo.expectReached(model + " wet");
    zoo.app.setWetness(0);
    zoo.app.groomAll(GroomEdit::Comb, 1, Vec3(0.7f, -0.7f, 0));
    zoo.app.settle();
    zoo.expectReached(model + " combed");
    zoo.app.groomAll(GroomEdit::Clear);
    for (const char* coat : {"shag", "velvet"}) {
      zoo.app.applyPreset(coat);
      zoo.set({{"ground", "false"}});
      zoo.app.settle();
      zoo.expectReached(model + " " + coat);
    }
  }
}

TEST(Picking, WhereFurIsShortOrGoneTheSkinIsReached) {
  for (const std::string model : kModels) {
    Zoo zoo(model, {{"groomStrength", "1"}, {"brushRadius", "0.4"}});
    zoo.app.groomAll(GroomEdit::Vary, 0.8f);
    zoo.app.setTool(Tool::Trim);
    for (const Vec2 at : {Vec2(64, 64), Vec2(37, 58)})
      for (const PointerPhase phase : {PointerPhase::Down, PointerPhase::Up}) zoo.app.pointer({.phase = phase, .position = at, .buttons = 1});
    zoo.app.settle();
    zoo.expectReached(model + " partly bald");
  }
}

}  // namespace
}  // namespace fur::app
