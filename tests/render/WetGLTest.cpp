// Wet fur in the picture: where strands of a clump stand, and that nothing jumps as it gets wetter.
#include <algorithm>
#include <cmath>
#include <limits>

#include "geometry/Primitives.h"
#include "render/Blocks.h"
#include "settings/Presets.h"
#include "tests/render/Picture.h"
#include "truth/Strands.h"
#include "wet/Clump.h"

namespace fur::render {
namespace {

using test::Picture;
using test::Scene;

void set(app::App& app, std::initializer_list<std::pair<const char*, const char*>> fields) {
  for (const auto& [name, value] : fields) EXPECT_TRUE(app.setField(name, value)) << name;
  app.settle();
}

// --- strand by strand ---

constexpr int kWetSide = 500;

// A droplet in the middle of a plane that lies level, seen from above: one layer alone, in the droplet few strands.
struct Droplet : Scene {
  static constexpr float kRadius = 0.22f;
  float wetness;

  Droplet(float rho, const char* w, const char* height) : Scene(kWetSide, kWetSide), wetness(rho) {
    EXPECT_TRUE(app.loadPrimitive("plane"));
    app.setCamera({0, 1.4f, 1});
    set(app, {{"density", "0.12"}, {"thickness", "0.2"}, {"curl", "0.3"}, {"lengthVariation", "0"}, {"taper", "0"}, {"furLength", "0"},
              {"repeat", "2"}, {"layers", "64"}, {"gravity", "0"}, {"clumpShape", w}, {"view", "layer"}, {"viewLayer", height}});
    EXPECT_TRUE(app.splashPixel(Vec2(kWetSide / 2.0f), kRadius, wetness)) << "on bare skin, so that it lies in the middle";
    set(app, {{"furLength", "0.15"}});
    app.settle();
  }

  // The tube's place where it has come so far along itself.
  static std::optional<Vec3> pointAt(const truth::Tubes& tubes, const truth::Tube& tube, float along) {
    for (std::uint32_t k = 1; k < tube.nodeCount; ++k) {
      const truth::TubeNode &a = tubes.nodes[tube.firstNode + k - 1], &b = tubes.nodes[tube.firstNode + k];
      if (a.height <= along && along < b.height) return glm::mix(a.position, b.position, (along - a.height) / (b.height - a.height));
    }
    return std::nullopt;
  }

  struct Found {
    int strands = 0, shown = 0, shownMirrored = 0;
  };
  // Strands whose clumping by the CPU brings them to that height within the droplet; of how many the picture shows fur within a
  // texel of there, and of the same place on the other side of the droplet's middle.
  Found find() {
    const Picture picture = draw();
    const render::Frame f = app.frame();
    const settings::Settings& s = f.settings;
    const shared::FurBlock block = furBlock(f, {.size = app.grownCoat()->parameters.size, .layers = s.layers}, {0.3f}, 1);
    const truth::FurMap map(app.surface(), app.bends(), s.furLength, block.tilesPerUnit);
    const truth::Tubes tubes = truth::placeStrands(map, *app.grownCoat(), 1e-5f);
    const float texel = 1 / (block.tilesPerUnit * block.tileTexels), ground = app.surface().vertices[0].position.y;
    const Mat4 clip = clipFromWorld(f) * f.worldFromModel;
    const float stands = s.viewLayer / wet::standsTo(wetness, 0);
    constexpr float kChance = 0;  // of a centre at (0.5, 0.5)
    const float pull = wet::clumpPull(stands, s.clumpShape, static_cast<float>(s.layers), wet::clumpingWetness(wetness, kRadius / s.furLength, kChance));
    const auto hasFur = [&](const Vec3& at) {
      const Vec4 c = clip * Vec4(at, 1);
      const Vec2 pixel((0.5f + 0.5f * c.x / c.w) * kWetSide, (0.5f - 0.5f * c.y / c.w) * kWetSide);
      const int reach = static_cast<int>(std::floor(texel * pixelsPerUnit(f) / glm::length(f.camera.eye - at)));
      for (int y = static_cast<int>(pixel.y) - reach; y <= static_cast<int>(pixel.y) + reach; ++y)
        for (int x = static_cast<int>(pixel.x) - reach; x <= static_cast<int>(pixel.x) + reach; ++x)
          if (x >= 0 && y >= 0 && x < kWetSide && y < kWetSide && picture.at(x, y)[0] > picture.at(x, y)[2] + 10) return true;  // skin is blue there
      return false;
    };
    Found found;
    for (const truth::Tube& tube : tubes.tubes) {
      float along = stands;
      std::optional<Vec3> q;
      for (int k = 0; k < 8 && (q = pointAt(tubes, tube, along)); ++k)
        along = wet::alongStrand(stands, pull * glm::length(Vec2(q->x, q->z)) / s.furLength) *
                wet::rimTaper(wet::sheetOf(wetness), wet::sheetOf(wetness), glm::dot(Vec2(q->x, q->z), Vec2(q->x, q->z)) / (kRadius * kRadius));
      if (!q || along > 0.95f || glm::length(Vec2(q->x, q->z)) > 0.85f * kRadius) continue;
      // The smaller locks in a clump (wet::lockPull()) are so small beside this droplet that they move no strand by a texel.
      const Vec2 at = wet::clumpForward(Vec2(q->x, q->z), Vec2(0), pull);
      const float height = ground + s.viewLayer * s.furLength;
      ++found.strands;
      found.shown += hasFur({at.x, height, at.y});
      found.shownMirrored += hasFur({-at.x, height, -at.y});
    }
    return found;
  }
};

TEST(WetLocks, ShowEachStrandWhereClumpingItByItselfPutsIt) {
  for (const auto& [w, height] : {std::pair("0", "0.4"), std::pair("1", "0.4"), std::pair("0.6", "0.5")}) {
    Droplet droplet(0.6f, w, height);
    const Droplet::Found found = droplet.find();
    EXPECT_GT(found.strands, 40);
    // A few lie under others that the layer rounds to their place first.
    EXPECT_GT(found.shown, 0.97f * static_cast<float>(found.strands)) << "w " << w << " at height " << height;
    // The measure can tell: elsewhere there is fur by chance only.
    EXPECT_LT(found.shownMirrored, 0.6f * static_cast<float>(found.shown));
  }
}

// --- from dry to soaked ---

struct WetBall : Scene {
  WetBall() : Scene(200, 200, 0) {
    app.setCamera({0.3f, 0.2f, 3.2f});
    set(app, {{"ground", "false"}, {"layers", "16"}, {"tileSize", "128"}, {"backgroundTop", "#0000ff"}, {"backgroundBottom", "#0000ff"}});
  }
  Picture wet(float rho) {
    app.setWetness(rho);
    app.settle();
    return draw();
  }
};

TEST(WetLocks, CloseIntoASheetAndOpenAgainWithoutAJump) {
  WetBall ball;
  // In each half of the way to a soaked coat no step of an eightieth is more than four times as large as the mean one.
  std::vector<float> last = test::blocksOf(ball.wet(0.8f)), steps;
  for (int i = 1; i <= 16; ++i) {
    std::vector<float> next = test::blocksOf(ball.wet(0.8f + 0.0125f * static_cast<float>(i)));
    steps.push_back(test::meanDifference(last, next));
    last = std::move(next);
  }
  float sum = 0, most = 0;
  for (const float step : steps) sum += step, most = std::max(most, step);
  EXPECT_GT(sum, 3) << "soaked fur looks like wet fur";
  EXPECT_LT(most, 3 * sum / static_cast<float>(steps.size()));
  // The way back is the same one.
  EXPECT_EQ(ball.wet(0.9f).differingShare(ball.wet(0.9f), 0), 0);
  const Picture before = ball.wet(0.8f);
  ball.wet(1);
  EXPECT_EQ(before.differingShare(ball.wet(0.8f), 0), 0);
}

TEST(WetLocks, OfASoakedCoatLieLowerAndAreDarker) {
  WetBall ball;
  const auto fur = [](const Picture& p) {
    int count = 0;
    double red = 0;
    for (int y = 0; y < 200; ++y)
      for (int x = 0; x < 200; ++x)
        if (p.at(x, y)[0] > 0) ++count, red += p.at(x, y)[0];  // the background has no red
    return Vec2(static_cast<float>(count), static_cast<float>(red / count));
  };
  const Vec2 dry = fur(ball.draw()), clumps = fur(ball.wet(0.7f)), sheet = fur(ball.wet(1));
  EXPECT_LT(clumps.y, 0.8f * dry.y);
  EXPECT_LT(sheet.x, 0.97f * dry.x);
  EXPECT_LT(sheet.y, 0.8f * dry.y);
}

TEST(WetLocks, OfASoakedCoatEndWhereTheSheetDoes) {
  WetBall ball;
  set(ball.app, {{"furLength", "0.2"}, {"gravity", "0"}});
  ball.app.setCamera({0.3f, 0.0f, 4.0f});
  // Pixels from the middle of the picture to the outermost red one: a ball of that radius, from 4 away.
  const auto radius = [](const Picture& p) {
    float most = 0;
    for (int y = 0; y < 200; ++y)
      for (int x = 0; x < 200; ++x)
        if (p.at(x, y)[0] > 0) most = std::max(most, std::hypot(static_cast<float>(x) - 99.5f, static_cast<float>(y) - 99.5f));
    return most;
  };
  const auto pixels = [](float r) { return std::tan(std::asin(r / 4)) / std::tan(0.3f) * 100; };
  const float dry = radius(ball.draw()), sheet = radius(ball.wet(1));
  EXPECT_GT(dry, pixels(1.15f));
  EXPECT_LT(sheet, pixels(1 + 0.2f * (1 - wet::kSheetSinks)) + 1.5f) << "nothing hangs over it";
  EXPECT_GT(sheet, pixels(1.03f));
}

// How much values from there to there, x and y, differ from the mean of those beside, above and below them, for their size.
template <class Value>
double unevenness(const Value& at, int from, int to) {
  double apart = 0, sum = 0;
  for (int y = from; y < to; ++y)
    for (int x = from; x < to; ++x) {
      apart += std::abs(at(x, y) - (at(x - 1, y) + at(x + 1, y) + at(x, y - 1) + at(x, y + 1)) / 4.0);
      sum += at(x, y);
    }
  return apart / sum;
}

TEST(WetLocks, OfASoakedCoatHaveNoGrain) {
  WetBall ball;
  set(ball.app, {{"clumpSize", "0.3"}, {"repeat", "10"}, {"thickness", "0.35"}, {"variance", "1"}});  // locks that are many pixels wide, strands so fine that they are drawn as one
  const auto grain = [](const Picture& p) { return unevenness([&](int x, int y) { return p.at(x, y)[0]; }, 60, 140); };
  const double dry = grain(ball.draw()), sheet = grain(ball.wet(1));
  EXPECT_GT(dry, 0.05);
  // What is left is the edges of locks (0.94 of dry fur's); where strands are met by chance it is four times that of dry fur.
  EXPECT_LT(sheet, 1.5 * dry);
}

// Its clumps would be wider than it is long: as a whole it looked polished, with rings of light round the body.
TEST(WetLocks, OfShortFurLieSideBySide) {
  WetBall ball;
  set(ball.app, {{"furLength", "0.05"}, {"clumpSize", "0.1"}});
  ball.app.setCamera({0.3f, 0.2f, 2.2f});
  ball.app.setWetness(1);
  ball.app.settle();
  const Picture p = ball.draw();
  // Of 4 by 4 pixels, in which strands are a mean.
  const auto block = [&](int x, int y) {
    double light = 0;
    for (int i = 0; i < 16; ++i) light += p.at(4 * x + i % 4, 4 * y + i / 4)[0];
    return light;
  };
  EXPECT_GT(unevenness(block, 15, 35), 0.06);  // without locks 0.048
}

// A mesh without texture coordinates, turned: where the borders of its charts lie depends on the axes.
std::string turnedObj(const geometry::Mesh& mesh, float yaw, float pitch) {
  const Mat3 turn = Mat3(glm::rotate(glm::rotate(Mat4(1), pitch, Vec3(1, 0, 0)), yaw, Vec3(0, 1, 0)));
  std::string text;
  const auto line = [&](const char* kind, const Vec3& v) {
    text += std::string(kind) + " " + std::to_string(v.x) + " " + std::to_string(v.y) + " " + std::to_string(v.z) + "\n";
  };
  for (const Vec3& position : mesh.positions) line("v", turn * position);
  for (const Vec3& normal : mesh.normals) line("vn", turn * normal);
  for (std::size_t i = 0; i < mesh.indices.size(); i += 3) {
    text += "f";
    for (std::size_t k = 0; k < 3; ++k) {
      const std::string n = std::to_string(mesh.indices[i + k] + 1);
      text += " " + n + "//" + n;
    }
    text += "\n";
  }
  return text;
}

// Share of the model's pixels that are far darker than what lies round them.
double crackedShare(const Picture& picture) {
  constexpr int kRound = 6;
  const int width = picture.width, height = picture.height;
  std::vector<double> sums(static_cast<std::size_t>((width + 1) * (height + 1)));
  const auto light = [&](int x, int y) { return picture.at(x, y)[0] + picture.at(x, y)[1] + picture.at(x, y)[2]; };
  const auto at = [&](int x, int y) -> double& { return sums[static_cast<std::size_t>(y * (width + 1) + x)]; };
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) at(x + 1, y + 1) = at(x, y + 1) + at(x + 1, y) - at(x, y) + light(x, y);
  int cracked = 0, all = 0;
  for (int y = kRound; y < height - kRound; ++y)
    for (int x = kRound; x < width - kRound; ++x) {
      // Within the outline.
      if (std::hypot(x - 0.5 * width, y - 0.5 * height) > 0.36 * height) continue;
      const int a = x - kRound, b = x + kRound + 1, c = y - kRound, d = y + kRound + 1;
      const double mean = (at(b, d) - at(a, d) - at(b, c) + at(a, c)) / ((b - a) * (d - c));
      ++all;
      cracked += light(x, y) < 0.5 * mean;
    }
  return static_cast<double>(cracked) / all;
}

TEST(WetLocks, OfASoakedCoatHaveNoCracksAlongTheBordersOfCharts) {
  geometry::Mesh sphere = geometry::makeSphere(), torus = geometry::makeTorus(72, 32, 0.5f);
  bool corner = false;
  for (const settings::Preset& preset : settings::presets()) {
    corner = !corner;
    // Whatever model its coat is on.
    Scene scene(360, 270);
    ASSERT_TRUE(scene.app.applyPreset(preset.name));
    // So fine that a sheet is drawn as one: gaps between strands that are seen are as dark as cracks.
    set(scene.app, {{"ground", "false"}, {"breath", "0"}, {"dryRate", "0"}, {"gravity", "0"}, {"repeat", "12"}});
    // The middle of a chart and a corner where three meet: each coat has one of them on the sphere and the other on the torus.
    for (const auto& [name, mesh, pitch, turn] : {std::tuple("sphere", sphere, 0.0f, corner ? 0.785f : 0.0f), std::tuple("torus", torus, 1.2f, corner ? 0.0f : 0.785f)}) {
      const std::string obj = turnedObj(mesh, turn, pitch + 0.8f * turn);
      const auto bytes = reinterpret_cast<const std::uint8_t*>(obj.data());
      ASSERT_TRUE(scene.app.loadModel({bytes, bytes + obj.size()}, "turned.obj"));
      scene.app.setCamera({0, 0, 3.4f});
      scene.app.setWetness(1);
      for (int i = 0; i < 60; ++i) scene.app.tick(1.0f / 60);
      // Where each texel was as wet as the flow had left it, it was up to 0.006.
      EXPECT_LT(crackedShare(scene.draw()), 0.002) << name << ", " << preset.name << ", turned by " << turn;
    }
  }
}

// A level plane whose atlas is cut in two along z = 0, the further half turned by half a turn: combed fur leans across the cut.
std::string cutPlane() {
  constexpr int kCells = 24, kPoints = (kCells + 1) * (kCells + 1);
  std::string vertices, faces;
  for (const float z : {-1.0f, 0.0f}) {
    for (int i = 0; i < kPoints; ++i) {
      const float s = static_cast<float>(i % (kCells + 1)) / kCells, t = static_cast<float>(i / (kCells + 1)) / kCells;
      const Vec2 uv = z < 0 ? Vec2(0.05f + 0.9f * s, 0.45f - 0.4f * t) : Vec2(0.95f - 0.9f * s, 0.55f + 0.4f * t);
      vertices += "v " + std::to_string(2 * s - 1) + " 0 " + std::to_string(z + t) + "\nvt " + std::to_string(uv.x) + " " + std::to_string(uv.y) + "\n";
    }
    for (int cell = 0; cell < kCells * kCells; ++cell) {
      const int a = (z < 0 ? 1 : 1 + kPoints) + cell + cell / kCells, c = a + kCells + 1;
      const auto corner = [](int i) { return " " + std::to_string(i) + "/" + std::to_string(i); };
      faces += "f" + corner(a) + corner(c) + corner(a + 1) + "\nf" + corner(a + 1) + corner(c) + corner(c + 1) + "\n";
    }
  }
  return vertices + faces;
}

TEST(WetLocks, RunOnAcrossTheBordersOfChartsInAPictureOfSeveralSamples) {
  Scene scene(500, 500);
  set(scene.app, {{"ground", "false"}, {"view", "clumps"}});
  const std::string obj = cutPlane();
  const auto bytes = reinterpret_cast<const std::uint8_t*>(obj.data());
  ASSERT_TRUE(scene.app.loadModel({bytes, bytes + obj.size()}, "cut.obj"));
  scene.app.setCamera({0, 1.4f, 1.4f});
  scene.app.setWetness(0.7f);
  for (int i = 0; i < 12; ++i) scene.app.tick(1.0f / 60);
  ASSERT_TRUE(scene.app.draw(app::Picture::Best, 4));
  const Picture picture = scene.stage.read();
  // The share of pixels of a row that show the same clump as those below: each lock ends somewhere else.
  double least = 1, sum = 0;
  for (int y = 0; y + 1 < picture.height; ++y) {
    int same = 0;
    for (int x = 0; x < picture.width; ++x) {
      int apart = 0;
      for (int k = 0; k < 3; ++k) apart += std::abs(picture.at(x, y)[k] - picture.at(x, y + 1)[k]);
      same += apart < 40;
    }
    least = std::min(least, static_cast<double>(same) / picture.width);
    sum += static_cast<double>(same) / picture.width;
  }
  // The grain of strands makes it 0.6 of the mean here and there; where a ray knew nothing of what roots beyond the border, and all ended in one
  // row, it was 0.1 of it.
  EXPECT_GT(least, 0.4 * sum / (picture.height - 1));
}

TEST(WetLocks, HoldLessWaterTowardsDryFur) {
  Droplet droplet(0.7f, "0.6", "0.5");
  set(droplet.app, {{"view", "wetness"}});
  const Picture p = droplet.draw();
  // On the way from the middle of the droplet to the right, as shares of its radius: how far the colour is from that of dry skin.
  const render::Frame f = droplet.app.frame();
  const Mat4 clip = clipFromWorld(f) * f.worldFromModel;
  const float ground = droplet.app.surface().vertices[0].position.y;
  const auto at = [&](float share) {
    const Vec4 c = clip * Vec4(share * Droplet::kRadius, ground, 0, 1);
    return p.at(static_cast<int>((0.5f + 0.5f * c.x / c.w) * kWetSide), static_cast<int>((0.5f - 0.5f * c.y / c.w) * kWetSide));
  };
  const auto wet = [&](float share) {
    float sum = 0;
    for (int k = 0; k < 3; ++k) sum += static_cast<float>(std::abs(at(share)[k] - at(1.3f)[k]));
    return sum;
  };
  EXPECT_GT(wet(0), 60);
  EXPECT_NEAR(wet(0.4f), wet(0), 6);
  EXPECT_LT(wet(0.85f), 0.9f * wet(0));
  EXPECT_LT(wet(0.96f), 0.6f * wet(0));
  EXPECT_GT(wet(0.96f), 0);
}

TEST(WetLocks, StandWetAlongTheOutlineToo) {
  // Rays that graze a round body leave its charts: what they meet there is no dry fur.
  WetBall ball;
  set(ball.app, {{"view", "clumps"}, {"furLength", "0.25"}});
  const Picture p = ball.wet(0.8f);
  int fur = 0, grey = 0;
  for (int y = 0; y < 200; ++y)
    for (int x = 0; x < 200; ++x) {
      const std::uint8_t* c = p.at(x, y);
      if (c[2] > 250 && c[0] < 5) continue;
      ++fur;
      grey += std::abs(c[0] - c[1]) < 3 && std::abs(c[1] - c[2]) < 3;
    }
  EXPECT_GT(fur, 12000);
  EXPECT_LT(grey, 0.03f * static_cast<float>(fur));
}

TEST(WetLocks, StayInASavedScene) {
  WetBall ball;
  const Picture before = ball.wet(0.7f);
  const float held = ball.app.meanWetness();
  const std::vector<std::uint8_t> saved = ball.app.saveScene();
  ball.app.setWetness(0);
  ASSERT_TRUE(ball.app.loadModel(saved, "ball.glb"));
  ball.app.settle();
  EXPECT_NEAR(ball.app.meanWetness(), held, 1e-4f);
  const std::uint64_t hash = ball.app.wetnessHash();
  // Centres are rounded by a part of a texel: some strands at the rims of clumps.
  EXPECT_LT(ball.draw().differingShare(before, 24), 0.03f);
  ASSERT_TRUE(ball.app.loadModel(ball.app.saveScene(), "ball.glb"));
  EXPECT_EQ(ball.app.wetnessHash(), hash);
}

TEST(WetLocks, AreSoundAtTheEndsOfEveryRange) {
  WetBall ball;
  set(ball.app, {{"layers", "4"}});
  const std::size_t texels = ball.app.wetnessMask().texels().size();
  for (const char* w : {"0", "1"})
    for (const float radius : {std::numeric_limits<float>::denorm_min(), 1e-12f, 1e-3f, 0.2f, 1e30f})
      for (const float centre : {0.0f, 0.5f, 1.0f, 1e30f}) {
        set(ball.app, {{"clumpShape", w}});
        ball.app.restoreWetness(std::vector<Vec4>(texels, Vec4(centre, centre, radius, 1)));
        const Picture p = ball.draw();
        // A pixel that is not a number comes out black, as do some dozens in the deepest shade between clumps.
        int black = 0;
        for (std::size_t i = 0; i < p.rgba.size(); i += 4) black += p.rgba[i] + p.rgba[i + 1] + p.rgba[i + 2] == 0;
        EXPECT_LT(black, 200) << "w " << w << ", radius " << radius << ", centre " << centre;
      }
}

// --- wet in places ---

// Far from the water patches are drawn as dry fur is, to the pixel, and nothing is left out where wet ones begin.
TEST(WetPatches, LeaveTheRestOfTheCoatAsItWas) {
  Scene scene(240, 240, 0);
  EXPECT_TRUE(scene.app.loadPrimitive("sphere"));
  scene.app.setCamera({0.3f, 0.2f, 3.2f});
  set(scene.app, {{"furLength", "0.1"}, {"stayWet", "true"}});
  const Picture dry = scene.draw();
  EXPECT_TRUE(scene.app.splashPixel(Vec2(160, 120), 0.1f, 0.7f));
  scene.app.settle();
  const Picture wet = scene.draw();
  const auto differ = [&](int fromX, int toX) {
    int count = 0;
    for (int y = 60; y < 180; ++y)
      for (int x = fromX; x < toX; ++x) count += !std::equal(dry.at(x, y), dry.at(x, y) + 4, wet.at(x, y));
    return count;
  };
  EXPECT_GT(differ(140, 180), 500);
  EXPECT_EQ(differ(20, 55), 0);
}

}  // namespace
}  // namespace fur::render
