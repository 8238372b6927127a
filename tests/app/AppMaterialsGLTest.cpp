// Parts of a model that are furry and parts that are not.
#include "tests/app/Salon.h"
#include "tests/render/Picture.h"
#include "tests/scene/GltfBuilder.h"

namespace fur::app {
namespace {

// A sphere of each material, side by side: the left one's is named Body, the right one's Eyes. `pictured`: all of it lies at the left of
// pictures, and by other coordinates at their right; there is one, picture 0.
std::vector<std::uint8_t> twoSpheres(const std::string& left = R"({"name":"Body"})", const std::string& right = R"({"name":"Eyes","pbrMetallicRoughness":{"baseColorFactor":[0,1,0,1],"metallicFactor":0}})", bool pictured = false) {
  geometry::Mesh sphere = geometry::makeSphere();
  std::string views, accessors, primitives;
  scene::FileBytes binary;
  const auto add = [&](const auto& values, int componentType, const char* type, std::size_t count) {
    views += (views.empty() ? "" : ",") + std::string(R"({"buffer":0,"byteOffset":)") + std::to_string(binary.size()) + R"(,"byteLength":)" + std::to_string(values.size() * sizeof values[0]) + "}";
    const std::size_t number = static_cast<std::size_t>(std::count(accessors.begin(), accessors.end(), '{'));
    accessors += (accessors.empty() ? "" : ",") + std::string(R"({"bufferView":)") + std::to_string(number) + R"(,"componentType":)" + std::to_string(componentType) + R"(,"count":)" + std::to_string(count) + R"(,"type":")" + type + "\"}";
    scene::appendValues(binary, values);
    return std::to_string(number);
  };
  for (int material = 0; material < 2; ++material) {
    std::vector<Vec3> positions = sphere.positions;
    for (Vec3& p : positions) p.x += material ? 1.2f : -1.2f;
    const std::string place = add(positions, 5126, "VEC3", positions.size()), normal = add(sphere.normals, 5126, "VEC3", positions.size()), index = add(sphere.indices, 5125, "SCALAR", sphere.indices.size());
    std::string sets;
    for (int set = 0; pictured && set < 2; ++set)
      sets += ",\"TEXCOORD_" + std::to_string(set) + "\":" + add(std::vector<Vec2>(positions.size(), Vec2(set ? 0.75f : 0.25f, 0.5f)), 5126, "VEC2", positions.size());
    primitives += (material ? "," : "") + std::string(R"({"attributes":{"POSITION":)") + place + R"(,"NORMAL":)" + normal + sets + R"(},"indices":)" + index + R"(,"material":)" + std::to_string(material) + "}";
  }
  return scene::glb(R"({"asset":{"version":"2.0"},"scene":0,"scenes":[{"nodes":[0]}],"nodes":[{"mesh":0}],"meshes":[{"primitives":[)" + primitives + R"(]}],"materials":[)" + left + "," + right +
                        (pictured ? R"(],"textures":[{"source":0}],"images":[{"uri":"data:image/png;base64,iVBORw0KGgoAAAANSUhEUgAAAAIAAAABCAYAAAD0In+KAAAADklEQVR4nGNgYGD4DwIADvoE/EWwHYsAAAAASUVORK5CYII="}],"samplers":[{})" : "") +
                        R"(],"accessors":[)" + accessors + R"(],"bufferViews":[)" + views + R"(],"buffers":[{"byteLength":)" + std::to_string(binary.size()) + "}]}", binary);
}

constexpr int kSide = 120;
constexpr Vec2 kLeft{32, 60}, kRight{88, 60};

struct TwoRoom : test::Room {
  explicit TwoRoom(const std::vector<std::uint8_t>& file = twoSpheres()) : Room(kSide, {{"layers", "8"}, {"tileSize", "64"}, {"breath", "0"}, {"furLength", "0.1"}, {"lightPitch", "0.3"}, {"lightYaw", "0"}}) {
    App::keepDocuments(&scene::kDocumentKeeping);
    EXPECT_TRUE(app.loadModel(file, "two.glb"));
    app.setCamera({0, 0, 3.4f, Vec3(0)});
  }
  ~TwoRoom() { App::keepDocuments(nullptr); }
  void click(Tool tool, Vec2 at) {
    app.setTool(tool);
    app.pointer({.phase = PointerPhase::Down, .position = at, .buttons = 1});
    app.pointer({.phase = PointerPhase::Move, .position = at + Vec2(1, 1), .buttons = 1});
    app.pointer({.phase = PointerPhase::Up, .position = at});
  }
};

// Mean of how much neighbouring pixels differ round a place: strands, or a smooth ball.
double grain(const test::Picture& picture, Vec2 at) {
  double sum = 0;
  for (int y = -8; y < 8; ++y)
    for (int x = -8; x < 8; ++x) {
      const int px = static_cast<int>(at.x) + x, py = static_cast<int>(at.y) + y;
      for (int k = 0; k < 3; ++k) sum += std::abs(picture.at(px, py)[k] - picture.at(px + 1, py)[k]);
    }
  return sum / (3 * 256);
}

bool isGreen(const std::uint8_t* pixel) { return pixel[1] > 60 && pixel[1] > 2 * pixel[0] && pixel[1] > 2 * pixel[2]; }

TEST(AppMaterials, ABarePartIsASmoothBallOfItsOwnColourBesideAFurryOne) {
  TwoRoom room;
  const test::Picture picture = room.settled();
  EXPECT_TRUE(isGreen(picture.at(88, 60)));
  EXPECT_FALSE(isGreen(picture.at(32, 60)));
  EXPECT_GT(grain(picture, kLeft), 3 * grain(picture, kRight));
}

TEST(AppMaterials, BarePartsHaveNoCoat) {
  TwoRoom room;
  room.settled();
  EXPECT_EQ(room.app.materials(), R"([{"name":"Body","triangles":)" + std::to_string(geometry::makeSphere().triangleCount()) + R"(,"furry":true},{"name":"Eyes","triangles":)" +
                                      std::to_string(geometry::makeSphere().triangleCount()) + R"(,"furry":false}])");
  for (const char* view : {"shells", "fins", "coverage"}) {
    room.app.setField("view", view);
    const test::Picture picture = room.settled();
    room.app.setField("furLength", "0");
    const test::Picture without = room.settled();
    room.app.setField("furLength", "0.1");
    for (int y = 0; y < kSide; ++y)
      for (int x = kSide / 2 + 6; x < kSide; ++x) ASSERT_EQ(std::memcmp(picture.at(x, y), without.at(x, y), 3), 0) << view << " " << x << " " << y;
  }
}

TEST(AppMaterials, AClickWithTheToolGivesAPartFurAndUndoTakesIt) {
  TwoRoom room;
  const test::Picture bare = room.settled();
  room.click(Tool::Furry, kRight);
  EXPECT_TRUE(room.app.isFurry(1));
  EXPECT_TRUE(room.app.groomed());
  const test::Picture furry = room.settled();
  EXPECT_GT(grain(furry, kRight), 3 * grain(bare, kRight));
  room.app.undo();
  EXPECT_FALSE(room.app.isFurry(1));
  EXPECT_FALSE(room.app.groomed());
  EXPECT_EQ(room.settled().rgba, bare.rgba);
  room.app.redo();
  EXPECT_EQ(room.settled().rgba, furry.rgba);
}

TEST(AppMaterials, TheToolAndTheMethodMeanTheSame) {
  TwoRoom room;
  EXPECT_EQ(room.app.materialAt(kLeft), 0);
  EXPECT_EQ(room.app.materialAt(kRight), 1);
  EXPECT_EQ(room.app.materialAt({2, 2}), -1);
  EXPECT_TRUE(room.app.setFurry(1, true));
  EXPECT_TRUE(room.app.isFurry(1));
  room.app.undo();
  EXPECT_FALSE(room.app.isFurry(1));
  for (const int material : {-1, 2, 1 << 30}) {
    const Status status = room.app.setFurry(material, true);
    ASSERT_FALSE(status);
    EXPECT_EQ(status.error().id, ErrorId::BadFile);
    EXPECT_NE(status.error().message.find("2 materials"), std::string::npos);
  }
  ASSERT_TRUE(room.app.loadPrimitive("torus"));
  EXPECT_FALSE(room.app.setFurry(0, false)) << "of one material all is furry";
}

TEST(AppMaterials, AreSavedWithTheDocumentAndWithTheGroom) {
  TwoRoom room;
  ASSERT_TRUE(room.app.setFurry(0, false));
  ASSERT_TRUE(room.app.setFurry(1, true));
  const auto file = room.app.saveScene(), groom = room.app.saveGroom();
  ASSERT_TRUE(room.app.loadModel(twoSpheres(), "two.glb"));
  EXPECT_TRUE(room.app.isFurry(0));
  ASSERT_TRUE(room.app.restoreGroom(groom));
  EXPECT_FALSE(room.app.isFurry(0));
  EXPECT_TRUE(room.app.isFurry(1));
  ASSERT_TRUE(room.app.loadPrimitive("torus"));
  EXPECT_FALSE(room.app.restoreGroom(groom)) << "of another model";
  ASSERT_TRUE(room.app.loadModel(file, "two.glb"));
  EXPECT_FALSE(room.app.isFurry(0));
  EXPECT_TRUE(room.app.isFurry(1));
  EXPECT_FALSE(room.app.groomed()) << "as the file had it";
}

TEST(AppMaterials, GroomingLeavesBarePartsAlone) {
  TwoRoom room;
  room.settled();
  const std::uint64_t before = room.app.groomHash();
  room.stroke(Tool::Comb, kRight, kRight + Vec2(6, 6));
  room.stroke(Tool::Trim, kRight, kRight + Vec2(6, 6));
  EXPECT_EQ(room.app.groomHash(), before);
  room.stroke(Tool::Trim, kLeft, kLeft + Vec2(6, 6));
  EXPECT_NE(room.app.groomHash(), before);
}

TEST(AppMaterials, EachFurryOneHasItsOwnPictureAndColour) {
  const std::string red = R"({"name":"Body","pbrMetallicRoughness":{"baseColorFactor":[1,0,0,1]}})", green = R"({"name":"Paws","pbrMetallicRoughness":{"baseColorFactor":[0,1,0,1]}})";
  TwoRoom room(twoSpheres(red, green));
  room.app.setField("rootColor", "#ffffff");
  room.app.setField("tipColor", "#ffffff");
  const test::Picture picture = room.settled();
  EXPECT_GT(picture.at(32, 60)[0], 2 * picture.at(32, 60)[1]);
  EXPECT_GT(picture.at(88, 60)[1], 2 * picture.at(88, 60)[0]);
}

TEST(AppMaterials, WhatIsBlendedLetsTheBackgroundThroughAndWhatIsMaskedIsNotThere) {
  const auto rightOf = [](const char* look) {
    TwoRoom room(twoSpheres(R"({"name":"Body"})", std::string(R"({"name":"Eyes","pbrMetallicRoughness":{"baseColorFactor":[0,1,0,0.3],"metallicFactor":0},)") + look + "}"));
    room.app.setField("ground", "false");
    const test::Picture picture = room.settled();
    return std::array{picture.at(88, 60)[0], picture.at(88, 60)[1], picture.at(88, 60)[2]};
  };
  const auto opaque = rightOf(R"("alphaMode":"OPAQUE")"), blended = rightOf(R"("alphaMode":"BLEND")"), masked = rightOf(R"("alphaMode":"MASK")");
  EXPECT_LT(opaque[0] + 30, blended[0]) << "of the background";
  EXPECT_LT(blended[0] + 5, masked[0]);
  EXPECT_LT(std::abs(masked[0] - masked[1]), 40) << "only background is left";
}

TEST(AppMaterials, ABarePartEmitsItsLight) {
  TwoRoom room(twoSpheres(R"({"name":"Body"})", R"({"name":"Eyes","pbrMetallicRoughness":{"baseColorFactor":[0,0,0,1],"metallicFactor":0},"emissiveFactor":[0,0,1]})"));
  const test::Picture picture = room.settled();
  EXPECT_GT(picture.at(88, 60)[2], 150);
  EXPECT_LT(picture.at(88, 60)[0], 80);
}

// A plane of two halves: the picture of what it emits is black and white, and its other coordinates lie in the white half alone.
TEST(AppMaterials, APictureOfABarePartLiesByTheCoordinatesThatItNames) {
  const auto shownBy = [](int set) {
    TwoRoom room(twoSpheres(R"({"name":"Body"})", R"({"name":"Eyes","pbrMetallicRoughness":{"baseColorFactor":[0,0,0,1],"metallicFactor":0,"baseColorTexture":{"index":0}},"emissiveFactor":[0,0,1],"emissiveTexture":{"index":0,"texCoord":)" +
                                                         std::to_string(set) + "}}", true));
    while (!room.app.pendingImage().bytes.empty()) room.app.provideImage(2, 1, {0, 0, 0, 255, 255, 255, 255, 255});
    return room.settled().at(88, 60)[2];
  };
  EXPECT_LT(shownBy(0), 80);
  EXPECT_GT(shownBy(1), 150);
}

TEST(AppMaterials, TheViewOfTheSkinShowsBarePartsAsTheyAre) {
  TwoRoom room;
  room.app.setField("view", "skin");
  EXPECT_TRUE(isGreen(room.settled().at(88, 60)));
}

// The mean wetness of a part: left or right of the middle.
float wetnessOf(App& app, bool right) {
  float sum = 0, count = 0;
  for (const geometry::SurfaceVertex& vertex : app.surface().vertices) {
    if ((vertex.position.x > 0) != right) continue;
    sum += app.wetnessAt(vertex.atlas.x, vertex.atlas.y);
    ++count;
  }
  return sum / count;
}

TEST(AppMaterials, BarePartsTakeNoWaterHoweverItComes) {
  const auto wet = [](const char* what, auto work) {
    TwoRoom room;
    work(room);
    for (int i = 0; i < 60; ++i) room.app.tick(1.0f / 60);
    EXPECT_GT(wetnessOf(room.app, false), 0.005f) << what;
    // Charts of the left one have gutters of two texels, some of which lie in the right one's.
    EXPECT_LT(wetnessOf(room.app, true), 0.005f) << what;
  };
  wet("all over", [](TwoRoom& room) { room.app.setWetness(1); });
  wet("rain", [](TwoRoom& room) {
    room.app.setField("rain", "1");
    for (int i = 0; i < 240; ++i) room.app.tick(1.0f / 60);
  });
  wet("strokes", [](TwoRoom& room) {
    room.app.setField("brushFlow", "1");
    room.stroke(Tool::Droplet, kRight, kRight + Vec2(10, 10));
    room.stroke(Tool::Droplet, kLeft, kLeft + Vec2(10, 10));
  });
  wet("at atlas coordinates", [](TwoRoom& room) {
    for (int y = 0; y < 8; ++y)
      for (int x = 0; x < 8; ++x) room.app.splashAt((static_cast<float>(x) + 0.5f) / 8, (static_cast<float>(y) + 0.5f) / 8, 0.1f, 0.8f);
  });
}

TEST(AppMaterials, APartThatBecomesFurryTakesWaterAndOneThatBecomesBareLosesIt) {
  TwoRoom room;
  room.app.setWetness(1);
  room.app.tick(1.0f / 60);
  ASSERT_TRUE(room.app.setFurry(1, true));
  room.app.tick(1.0f / 60);
  EXPECT_GT(wetnessOf(room.app, false), 0.5f) << "what was wet stays so";
  EXPECT_LT(wetnessOf(room.app, true), 0.05f);
  room.app.setWetness(1);
  EXPECT_GT(wetnessOf(room.app, true), 0.5f);
  ASSERT_TRUE(room.app.setFurry(0, false));
  for (int i = 0; i < 10; ++i) room.app.tick(1.0f / 60);
  EXPECT_LT(wetnessOf(room.app, false), 0.02f);
  const wet::Accounts water = room.app.water().accounts();
  EXPECT_NEAR(water.painted, water.held + water.film + water.drops + water.dripped + water.evaporated + water.removed, 1e-3) << "none is lost or made";
}

TEST(AppMaterials, UndoOfFurryBringsTheWaterBackThatThePartHeld) {
  TwoRoom room;
  room.app.setWetness(1);
  for (int i = 0; i < 10; ++i) room.app.tick(1.0f / 60);
  const float before = wetnessOf(room.app, false);
  ASSERT_GT(before, 0.5f);
  ASSERT_TRUE(room.app.setFurry(0, false));
  for (int i = 0; i < 10; ++i) room.app.tick(1.0f / 60);
  ASSERT_LT(wetnessOf(room.app, false), 0.02f);
  for (int again = 0; again < 2; ++again) {
    ASSERT_TRUE(room.app.undo());
    // All but what the first steps let run down.
    for (int i = 0; i < 10; ++i) room.app.tick(1.0f / 60);
    EXPECT_NEAR(wetnessOf(room.app, false), before, 0.05f) << again;
    const wet::Accounts water = room.app.water().accounts();
    EXPECT_NEAR(water.painted, water.held + water.film + water.drops + water.dripped + water.evaporated + water.removed, 1e-3) << again;
    ASSERT_TRUE(room.app.redo());
    for (int i = 0; i < 10; ++i) room.app.tick(1.0f / 60);
    EXPECT_LT(wetnessOf(room.app, false), 0.02f) << again;
  }
}

TEST(AppMaterials, LongHairCoversFurryPartsAlone) {
  TwoRoom room;
  room.app.editHair(HairEdit::AddScalp);
  room.app.editHair(HairEdit::Cover, 1);
  const hair::Scalp& scalp = room.app.hairstyle().scalps[0];
  for (const geometry::SurfaceVertex& vertex : room.app.surface().vertices) {
    const int size = scalp.map.size(), x = std::min(static_cast<int>(vertex.atlas.x * static_cast<float>(size)), size - 1), y = std::min(static_cast<int>(vertex.atlas.y * static_cast<float>(size)), size - 1);
    if (vertex.position.x < -0.05f) EXPECT_EQ(scalp.map.texels()[static_cast<std::size_t>(y * size + x)][0], 255);
    if (vertex.position.x > 0.05f) EXPECT_EQ(scalp.map.texels()[static_cast<std::size_t>(y * size + x)][0], 0);
  }
}

}  // namespace
}  // namespace fur::app
