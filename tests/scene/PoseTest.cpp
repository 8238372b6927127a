#include "scene/Pose.h"

#include <gtest/gtest.h>

#include "AllocatedBytes.h"
#include "core/Fnv1a.h"
#include "scene/Model.h"
#include "scene/Tentacle.h"
#include "tests/OnEveryPlatform.h"

namespace fur::scene {
namespace {

Model importedPosed(const FileBytes& bytes) {
  auto model = importModel(bytes, "tentacle.glb");
  EXPECT_TRUE(model) << (model ? "" : model.error().message);
  return std::move(*model);
}

std::string problemOf(const Tentacle& tentacle) {
  const auto model = importModel(tentacle.build(), "tentacle.glb");
  return model ? "none" : model.error().message;
}

// The same by the book, in double: glTF 2.0, 3.7.3.
struct Reference {
  const Tentacle& tentacle;
  const Rig& rig;
  double turn = 0, swell = 0;  // of each joint but the first, about z; share of the second target

  glm::dmat4 jointMatrix(int joint) const {
    glm::dmat4 m(1);
    for (int j = 0; j <= joint; ++j) {
      m = glm::translate(m, glm::dvec3(0, j ? tentacle.heightOf(1) : 0, 0));
      if (j) m = glm::rotate(m, turn, glm::dvec3(0, 0, 1));
    }
    return glm::translate(m, glm::dvec3(0, -tentacle.heightOf(joint), 0));
  }
  glm::dmat4 matrixOf(std::size_t i) const {
    glm::dmat4 m(0);
    for (std::size_t k = 4 * i; k < 4 * i + 4; ++k)
      m += jointMatrix(tentacle.jointsOf[k]) * static_cast<double>(tentacle.weights[k]);
    return m;
  }
  static glm::dvec3 at(const std::vector<float>& values, std::size_t i) { return {values[3 * i], values[3 * i + 1], values[3 * i + 2]}; }
  Vec3 position(std::size_t i) const {
    const glm::dvec3 local = at(tentacle.positions, i) + swell * at(tentacle.swell, i);
    return Vec3((glm::dvec3(matrixOf(i) * glm::dvec4(local, 1)) - glm::dvec3(rig.centre)) * static_cast<double>(rig.scale));
  }
  Vec3 normal(std::size_t i) const {
    const glm::dvec3 local = at(tentacle.normals, i) + swell * at(tentacle.swellNormals, i);
    return Vec3(glm::normalize(glm::inverse(glm::transpose(glm::dmat3(matrixOf(i)))) * local));
  }
};

void expectSame(const Pose& pose, const Reference& reference) {
  for (std::size_t i = 0; i < pose.positions().size(); ++i) {
    // Single precision against double, through four joints.
    ASSERT_LT(glm::length(pose.positions()[i] - reference.position(i)), 3e-6f) << i;
    ASSERT_LT(glm::length(pose.normals()[i] - reference.normal(i)), 1e-5f) << i;
    ASSERT_NEAR(glm::length(pose.tangents()[i]), 1, 1e-5f);
    ASSERT_NEAR(glm::dot(pose.tangents()[i], pose.normals()[i]), 0, 1e-5f);
  }
}

TEST(RigPose, SkinsAsTheReferenceDoes) {
  const Tentacle tentacle;
  const Model model = importedPosed(tentacle.build());
  ASSERT_EQ(model.rig.animations.size(), 2u);
  EXPECT_EQ(model.rig.animations[0].name, "wave");
  Pose pose(model.rig);
  expectSame(pose, {tentacle, model.rig});
  // At a key, and in the middle of two, where slerp halves the angle.
  for (const float t : {0.25f, 0.375f, 1.5f}) {
    pose.set(0, t);
    const auto turnAt = [](float key) { return 0.6 * std::sin(3.14159265358979 * static_cast<double>(key)); };
    const float first = std::floor(t * 4) / 4;
    expectSame(pose, {tentacle, model.rig, t == first ? turnAt(t) : 0.5 * (turnAt(first) + turnAt(first + 0.25f))});
  }
}

TEST(RigPose, MorphsAsTheReferenceDoes) {
  const Tentacle tentacle;
  const Model model = importedPosed(tentacle.build());
  Pose pose(model.rig);
  pose.set(1, 1);
  expectSame(pose, {tentacle, model.rig, 0, 1});
  pose.set(1, 0.5f);
  expectSame(pose, {tentacle, model.rig, 0, 0.5});
  pose.set(-1, 0);
  expectSame(pose, {tentacle, model.rig});
}

// A rotation between keys, written out so that no C library has a part in them.
Rig::Channel turning(const std::vector<Quat>& keys) {
  Rig::Channel channel;
  channel.path = Path::Rotation;
  channel.width = 4;
  for (const Quat& key : keys) {
    channel.times.push_back(static_cast<float>(channel.times.size()));
    for (const float v : {key.x, key.y, key.z, key.w}) channel.values.push_back(v);
  }
  return channel;
}

TEST(RigPose, TurnsEvenlyOnTheShorterWay) {
  const std::vector<Quat> keys{Quat(1, 0, 0, 0), Quat(-0.6f, 0, 0.8f, 0), Quat(0.36f, 0.48f, -0.8f, 0), Quat(0.36f, 0.48f, -0.8f, 1e-5f),
                               Quat(-0.36f, -0.48f, 0.8f, 0)};
  const Rig::Channel channel = turning(keys);
  for (float t = 0; t < 4; t += 0.0625f) {
    float turned[4];
    sample(channel, t, turned);
    const auto k = static_cast<std::size_t>(t);
    const glm::dquat expected = glm::normalize(glm::slerp(glm::dquat(keys[k]), glm::dquat(keys[k + 1]), static_cast<double>(t - std::floor(t))));
    const glm::dquat got(turned[3], turned[0], turned[1], turned[2]);
    // The same rotation has two signs.
    EXPECT_NEAR(std::abs(glm::dot(got, expected)), 1, 1e-6) << t;
    for (int i = 0; i < 4; ++i) EXPECT_NEAR(std::abs(got[i]), std::abs(expected[i]), 1e-6) << t << ' ' << i;
  }
}

TEST(RigPose, TurnsByTheSameBitsOnEveryPlatform) {
  const Rig::Channel channel = turning({Quat(1, 0, 0, 0), Quat(-0.6f, 0, 0.8f, 0), Quat(0.36f, 0.48f, -0.8f, 0), Quat(0.28f, 0.96f, 0, 0)});
  Fnv1a hash;
  for (int k = 0; k < 300; ++k) {
    float turned[4];
    sample(channel, 0.01f * static_cast<float>(k), turned);
    hash.addAll(turned);
  }
  test::printOnEveryPlatform("turns of an animation", hash.value());
}

TEST(RigPose, BeforeAndAfterItsKeysAnAnimationStands) {
  const Model model = importedPosed(Tentacle().build());
  Pose early(model.rig), late(model.rig), first(model.rig), last(model.rig);
  early.set(0, -1);
  first.set(0, 0);
  late.set(0, 100);
  last.set(0, 2);
  EXPECT_EQ(early.positions()[50], first.positions()[50]);
  EXPECT_EQ(late.positions()[50], last.positions()[50]);
}

TEST(RigPose, TheMeshIsTheRigWithoutAnAnimation) {
  const Model model = importedPosed(Tentacle().build());
  const Pose pose(model.rig);
  ASSERT_EQ(model.mesh.positions.size(), pose.positions().size());
  for (std::size_t i = 0; i < pose.positions().size(); ++i)
    ASSERT_LT(glm::length(model.mesh.positions[i] - pose.positions()[i]), 3e-6f) << i;
}

TEST(RigPose, NodesAloneAreMovedToo) {
  TriangleFile file;
  file.nodes = R"([{"children":[1],"rotation":[0,0,1,0]},{"mesh":0,"translation":[2,0,0]}])";
  file.top = R"("animations":[{"samplers":[{"input":2,"output":3,"interpolation":"STEP"},{"input":2,"output":4,"interpolation":"CUBICSPLINE"}],)"
             R"("channels":[{"sampler":0,"target":{"node":1,"path":"translation"}},{"sampler":1,"target":{"node":0,"path":"scale"}}]}],)";
  appendValues(file.more, std::vector<float>{0, 1});                          // times
  appendValues(file.more, std::vector<float>{1, 0, 0, 0, 3, 0});              // translations
  appendValues(file.more, std::vector<float>{0, 0, 0, 1, 1, 1, 1, 2, 0, 0, 0, 0, 2, 2, 2, 0, 0, 0});  // scales and their tangents
  file.moreViews = R"(,{"buffer":0,"byteOffset":44,"byteLength":8},{"buffer":0,"byteOffset":52,"byteLength":24},{"buffer":0,"byteOffset":76,"byteLength":72})";
  file.moreAccessors = R"(,{"bufferView":2,"componentType":5126,"count":2,"type":"SCALAR"},{"bufferView":3,"componentType":5126,"count":2,"type":"VEC3"},)"
                       R"({"bufferView":4,"componentType":5126,"count":6,"type":"VEC3"})";
  const Model model = importedPosed(file.build());
  Pose pose(model.rig);
  pose.set(0, 0.5f);
  // Half way along x of the cubic: 0.5 * 1 + 0.125 * 1 + 0.5 * 2, along y with a tangent of 2; the step still holds.
  const Vec3 scale(1.625f, 1.75f, 1.5f), local = Vec3(0, 1, 0) + Vec3(1, 0, 0);
  const Vec3 scene(-scale.x * local.x, -scale.y * local.y, 0);
  EXPECT_LT(glm::length(pose.positions()[2] - (scene - model.rig.centre) * model.rig.scale), 1e-5f);
}

// --- several animations at once ---

TEST(PoseMix, OfOneAnimationIsThatAnimationToTheBit) {
  const Model model = importedPosed(Tentacle().build());
  Pose alone(model.rig), mixed(model.rig);
  for (const int animation : {-1, 0, 1})
    for (const float t : {0.0f, 0.3f, 1.1f}) {
      alone.set(animation, t);
      mixed.set({.bodies = {{animation, t, 0.7f}, {1 - animation, 0.5f, 0}}, .layers = {{0, 0.3f, 0}}, .turns = {}});
      for (std::size_t i = 0; i < alone.positions().size(); ++i) {
        ASSERT_EQ(alone.positions()[i], mixed.positions()[i]);
        ASSERT_EQ(alone.normals()[i], mixed.normals()[i]);
        ASSERT_EQ(alone.tangents()[i], mixed.tangents()[i]);
      }
    }
}

TEST(PoseMix, TurnsJointsByTheirSharesAndMorphsLikewise) {
  const Tentacle tentacle;
  const Model model = importedPosed(tentacle.build());
  Pose pose(model.rig);
  const auto turnAt = [](double key) { return 0.6 * std::sin(3.14159265358979 * key); };
  // Times of keys: 0.25 and 0.75 turn alike, 1.25 the other way.
  pose.set({.bodies = {{0, 0.25f, 3}, {0, 1.25f, 1}}, .layers = {}, .turns = {}});
  expectSame(pose, {tentacle, model.rig, 0.5 * turnAt(0.25)});
  pose.set({.bodies = {{0, 0.25f, 1}, {1, 1, 1}}, .layers = {}, .turns = {}});
  expectSame(pose, {tentacle, model.rig, 0.5 * turnAt(0.25), 0.5});
}

TEST(PoseMix, LayersAddWhatTheyDifferFromTheRestBy) {
  const Tentacle tentacle;
  const Model model = importedPosed(tentacle.build());
  Pose pose(model.rig);
  const double turn = 0.6 * std::sin(3.14159265358979 * 0.25);
  pose.set({.bodies = {{0, 0.25f, 1}}, .layers = {{0, 0.25f, 0.5f}, {1, 1, 0.25f}, {0, 0, 1}, {-1, 0, 1}}, .turns = {}});
  expectSame(pose, {tentacle, model.rig, 1.5 * turn, 0.25});
  // As they come in they change as little as their weight.
  pose.set({.bodies = {{0, 0.25f, 1}}, .layers = {{0, 0.5f, 1e-4f}}, .turns = {}});
  expectSame(pose, {tentacle, model.rig, turn + 1e-4 * 0.6});
}

TEST(PoseMix, TurnsOfJointsAreOverAllThat) {
  const Tentacle tentacle;
  const Model model = importedPosed(tentacle.build());
  Pose pose(model.rig);
  PoseMix mix{.bodies = {{0, 0.25f, 1}}, .layers = {}, .turns = {{99999, Quat(1, 0, 0, 0)}}};
  const auto first = static_cast<std::size_t>(model.rig.skins[0].joints[0]);
  for (std::size_t k = 1; k < model.rig.skins[0].joints.size(); ++k)
    mix.turns.push_back({model.rig.skins[0].joints[k], glm::angleAxis(0.2f, Vec3(0, 0, 1))});
  pose.set(mix);
  expectSame(pose, {tentacle, model.rig, 0.6 * std::sin(3.14159265358979 * 0.25) + 0.2});
  EXPECT_EQ(Vec3(pose.transform(first)[1]), Vec3(0, model.rig.scale, 0));
}

TEST(PoseMix, AllocatesNothingOnceItHasPlayed) {
  const Model model = importedPosed(Tentacle().build());
  Pose pose(model.rig);
  const PoseMix mix{.bodies = {{0, 0.3f, 0.4f}, {1, 0.5f, 0.6f}}, .layers = {{0, 0.7f, 0.5f}}, .turns = {{2, Quat(0.6f, 0.8f, 0, 0)}}};
  pose.set(mix);
  const std::size_t before = allocatedBytes();
  pose.set(mix);
  EXPECT_EQ(allocatedBytes(), before);
}

TEST(PoseMix, JointsHaveTheirNames) {
  TriangleFile file;
  file.nodes = R"([{"mesh":0,"name":"hips"},{"name":"a joint with a long name"}])";
  file.top = R"("animations":[{"name":"stand","samplers":[{"input":2,"output":3}],"channels":[{"sampler":0,"target":{"node":0,"path":"translation"}}]}],)";
  appendValues(file.more, std::vector<float>{0, 1, 0, 0, 0, 1, 0, 0});
  file.moreViews = R"(,{"buffer":0,"byteOffset":44,"byteLength":8},{"buffer":0,"byteOffset":52,"byteLength":24})";
  file.moreAccessors = R"(,{"bufferView":2,"componentType":5126,"count":2,"type":"SCALAR"},{"bufferView":3,"componentType":5126,"count":2,"type":"VEC3"})";
  const Model model = importedPosed(file.build());
  ASSERT_EQ(model.rig.nodes.size(), 2u);
  EXPECT_EQ(model.rig.nodes[0].name, "hips");
  EXPECT_EQ(model.rig.nodes[1].name, "a joint with a long name");
}

TEST(RigPose, AModelThatDoesNotMoveHasNoRig) {
  EXPECT_FALSE(importedPosed(TriangleFile().build()).rig.moves());
  Tentacle still;
  still.animations = R"({"channels":[],"samplers":[]})";
  EXPECT_FALSE(importedPosed(still.build()).rig.moves());
  EXPECT_TRUE(importedPosed(still.build()).rig.positions.empty());
}

TEST(RigPose, HostileFilesGiveTypedErrors) {
  const auto withAnimation = [](const std::string& samplers, const std::string& channels) {
    Tentacle t;
    t.animations = R"({"samplers":[)" + samplers + R"(],"channels":[)" + channels + "]}";
    return problemOf(t);
  };
  const std::string sampler = R"({"input":6,"output":7})", channel = R"({"sampler":0,"target":{"path":"rotation","node":2}})";
  EXPECT_EQ(withAnimation(sampler, channel), "none");
  EXPECT_NE(withAnimation(sampler, R"({"sampler":0,"target":{"path":"rotation","node":99}})").find("node that does not exist"), std::string::npos);
  EXPECT_NE(withAnimation(sampler, R"({"sampler":7,"target":{"path":"rotation","node":2}})").find("sampler that does not exist"), std::string::npos);
  EXPECT_NE(withAnimation(R"({"input":6,"output":3})", channel).find("not one value a time"), std::string::npos);
  EXPECT_NE(withAnimation(R"({"input":6,"output":7,"interpolation":"MAGIC"})", channel).find("MAGIC"), std::string::npos);
  EXPECT_NE(withAnimation(R"({"input":8,"output":7})", channel).find("ascend"), std::string::npos);
  EXPECT_NE(withAnimation(R"({"input":99,"output":7})", channel).find("accessors[99]"), std::string::npos);
  EXPECT_NE(withAnimation(sampler, "7").find("not an object"), std::string::npos);
  const auto with = [](auto change) {
    Tentacle t;
    change(t);
    return problemOf(t);
  };
  EXPECT_NE(with([](Tentacle& t) { t.jointsOf[40] = 9; t.weights[40] = 1; }).find("joint that its skin does not have"), std::string::npos);
  EXPECT_NE(with([](Tentacle& t) { t.skin = R"({"joints":[1,2,77]})"; }).find("node that does not exist"), std::string::npos);
  EXPECT_NE(with([](Tentacle& t) { t.skin = R"({"joints":[]})"; }).find("no joints"), std::string::npos);
  EXPECT_NE(with([](Tentacle& t) { t.skin = R"({"joints":[1,2,3,4,1,2],"inverseBindMatrices":5})"; }).find("inverse bind"), std::string::npos);
  EXPECT_NE(with([](Tentacle& t) { t.targets = R"(,"targets":[{"POSITION":4},{}])"; }).find("accessors[4]"), std::string::npos);
  EXPECT_NE(with([](Tentacle& t) { t.targets = R"(,"targets":[{"POSITION":6},{}])"; }).find("VEC3"), std::string::npos);
  EXPECT_NE(with([](Tentacle& t) { t.weights[8] = std::nanf(""); }).find("finite"), std::string::npos);
  EXPECT_NE(with([](Tentacle& t) { t.attributes = R"("POSITION":0,"JOINTS_0":2,"WEIGHTS_0":0)"; }).find("VEC4"), std::string::npos);
}

TEST(RigPose, StaysFiniteForAnyNumbers) {
  Tentacle t;
  t.positions[3] = 1e30f;
  t.swell[7] = -1e30f;
  auto model = importModel(t.build(), "t.glb");
  if (!model) return;
  Pose pose(model->rig);
  for (const float s : {0.3f, 1e30f, -1e30f})
    for (const int animation : {-1, 0, 1, 2, 99}) {
      pose.set(animation, s);
      for (std::size_t i = 0; i < pose.positions().size(); ++i) {
        ASSERT_TRUE(std::isfinite(glm::dot(pose.normals()[i], pose.tangents()[i])));
        for (int c = 0; c < 3; ++c) ASSERT_TRUE(std::isfinite(pose.positions()[i][c]));
      }
    }
}

}  // namespace
}  // namespace fur::scene
