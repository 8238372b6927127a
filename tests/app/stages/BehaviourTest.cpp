// What animals do by themselves and when they are told to.
#include <gtest/gtest.h>

#include <set>

#include "app/stages/Animal.h"
#include "core/Fnv1a.h"
#include "tests/OnEveryPlatform.h"

namespace fur::app {
namespace {

using test::Animal;
using test::Zoo;

std::string problemsOf(Zoo& zoo, float seconds, std::set<Action>& done) {
  for (int i = 0; i < static_cast<int>(seconds * 60); ++i) {
    zoo.step(1 / 60.0f);
    done.insert(zoo.behaviour.action());
    for (const Vec3& p : zoo.shape.skin()->positions)
      if (!(glm::dot(p, p) < 4)) return "a vertex has left";
  }
  return "";
}

TEST(Behaviour, NeedsTheNamesOfAnAnimal) {
  EXPECT_EQ(Zoo().behaviour.actions(), "stand\nsit\ngroom\nshake\nwalk\nswim\n");
  EXPECT_EQ(Zoo(Animal({"toss"})).behaviour.actions(), "stand\ntoss\n");
  for (const Animal& other : {Animal({}, "Head01"), Animal({}, "head", "respire")}) {
    Zoo zoo(other);
    EXPECT_FALSE(zoo.behaviour.behaves());
    EXPECT_EQ(zoo.behaviour.actions(), "");
    EXPECT_EQ(zoo.behaviour.mix(), nullptr);
    EXPECT_FALSE(zoo.behaviour.act("stand"));
    // Its first animation plays, as that of any model.
    EXPECT_TRUE(zoo.active());
    EXPECT_TRUE(zoo.step(0.1f));
  }
}

TEST(Behaviour, ReachesWhatItDoesByItselfAndComesBackToStanding) {
  Zoo zoo;
  std::set<Action> done;
  for (int minute = 0; minute < 4; ++minute) {
    zoo.idleTime = 0;
    ASSERT_EQ(problemsOf(zoo, 55, done), "");
  }
  EXPECT_EQ(done, (std::set<Action>{Action::Stand, Action::Sit, Action::Groom}));
}

TEST(Behaviour, DoesWhatItIsToldAndThenStands) {
  Zoo zoo;
  for (const char* name : {"sit", "groom", "shake", "walk", "swim"}) {
    ASSERT_TRUE(zoo.behaviour.act(name));
    zoo.run(0.1f);
    EXPECT_STREQ(traitsOf(zoo.behaviour.action()).name, name);
    for (int i = 0; i < 15 * 60 && zoo.behaviour.action() != Action::Stand; ++i) zoo.step(1 / 60.0f);
    EXPECT_EQ(zoo.behaviour.action(), Action::Stand) << name;
  }
  EXPECT_FALSE(zoo.behaviour.act("canter"));
  EXPECT_FALSE(zoo.behaviour.act("fly"));
}

// However often it is told something else. Faster than any of its animations it is where one is faded into the other.
TEST(Behaviour, NoJointJumpsFromActionToAction) {
  Zoo zoo;
  const char* names[] = {"sit", "shake", "walk", "groom", "swim", "stand"};
  const auto nodes = static_cast<int>(zoo.shape.rig().nodes.size());
  Random random(5);
  float most = 0;
  std::vector<Vec3> before;
  for (int i = 0; i < 40 * 60; ++i) {
    if (random.uniform() < 0.05f) zoo.behaviour.act(names[random.next() % 6]);
    if (i % 97 == 0) zoo.pointer = Vec3(random.uniform(-2, 2), random.uniform(-1, 1), 2);
    zoo.step(1 / 60.0f);
    std::vector<Vec3> now;
    for (int node = 0; node < nodes; ++node) now.push_back(zoo.placeOf(node)), now.push_back(zoo.facing(node));
    for (std::size_t k = 0; k < before.size(); ++k) most = std::max(most, 60 * glm::distance(before[k], now[k]));
    before = now;
  }
  // The shake turns by 0.4 rad at 8 / 1.5 Hz, 13 rad/s at most; the gaze adds Gaze::kHeadSpeed and kEyeSpeed, a fade 0.7 rad in a quarter
  // of a second, half as fast again in its middle. A jump of 0.3 rad in a step would be 18 more.
  EXPECT_LT(most, 13.5f + Gaze::kHeadSpeed + Gaze::kEyeSpeed + 1.5f * 0.7f / 0.25f);
  EXPECT_GT(most, 5);
}

TEST(Behaviour, WetEnoughItShakesItselfAFewTimesAndGrowsCalm) {
  Zoo zoo;
  zoo.wetness = 0.05f;
  zoo.run(10);
  EXPECT_NE(zoo.behaviour.action(), Action::Shake);
  zoo.wetness = 0.6f;
  int shakes = 0;
  float strength = 0;
  for (int i = 0; i < 50 * 60; ++i) {
    zoo.idleTime = 0;
    const Action before = zoo.behaviour.action();
    zoo.step(1 / 60.0f);
    shakes += before != Action::Shake && zoo.behaviour.action() == Action::Shake;
    strength = std::max(strength, zoo.behaviour.shaking());
    if (zoo.behaviour.shaking() > 0.5f) zoo.wetness = std::max(zoo.wetness - 0.003f, 0.3f);
  }
  EXPECT_EQ(shakes, 2);
  EXPECT_EQ(strength, 1);
  EXPECT_EQ(zoo.behaviour.shaking(), 0);
  // Wetted anew it does again.
  zoo.wetness = 0.7f;
  zoo.run(2.8f);
  EXPECT_GT(zoo.behaviour.shaking(), 0.5f);
}

TEST(Behaviour, LooksWhereAPointerIsEyesFirst) {
  Zoo zoo;
  const int head = 3, eye = 4;
  zoo.pointer = zoo.placeOf(head) + Vec3(1.5f, 0.3f, 2);
  const auto off = [&](int node) { return glm::dot(zoo.facing(node), glm::normalize(*zoo.pointer - zoo.placeOf(node))); };
  const float before = off(eye);
  zoo.run(0.1f);
  EXPECT_GT(off(eye) - before, 2 * (off(head) - before));
  zoo.run(2);
  // The eyes see to what the head leaves.
  EXPECT_GT(off(eye), 0.99f);
  EXPECT_GT(off(head), 0.95f);
}

TEST(Behaviour, SquintsAndFlicksAnEarUnderDropsOnItsHeadOnly) {
  const auto playsUnder = [](const Vec3& place) {
    Zoo zoo;
    zoo.run(0.5f);
    const std::uint32_t triangle = zoo.triangleAt(place);
    std::set<std::string> played;
    for (int i = 0; i < 30; ++i) {
      zoo.landed.assign(i == 0, triangle);
      zoo.step(1 / 60.0f);
      for (const scene::PlayedClip& layer : zoo.behaviour.mix()->layers)
        if (layer.weight > 0.5f) played.insert(zoo.shape.rig().animations[static_cast<std::size_t>(layer.animation)].name);
    }
    return played;
  };
  EXPECT_TRUE(playsUnder({0.1f, 0.55f, 0.5f}).contains("squint"));
  EXPECT_TRUE(playsUnder({0.1f, 0.55f, 0.5f}).contains("earFlickL"));
  EXPECT_TRUE(playsUnder({-0.1f, 0.55f, 0.5f}).contains("earFlickR"));
  EXPECT_FALSE(playsUnder({0, 0.4f, -0.2f}).contains("squint"));
}

TEST(Behaviour, LeansIntoTheHandThatPetsIt) {
  const auto leanOf = [](float side) {
    Zoo zoo;
    zoo.reducedMotion = true;
    zoo.run(2);
    const Vec3 up = Vec3(zoo.shape.pose()->transform(1)[1]);
    zoo.hand = Vec3(side, 0.2f, 0);
    zoo.run(1);
    return Vec3(zoo.shape.pose()->transform(1)[1]).x - up.x;
  };
  // leanL turns the chest by 0.2 rad about z, leanR back.
  EXPECT_NEAR(leanOf(0.4f), -std::sin(0.2f), 0.01f);
  EXPECT_NEAR(leanOf(-0.4f), std::sin(0.2f), 0.01f);
}

TEST(Behaviour, NoneIsStillUntilItIsToldToAct) {
  Zoo zoo;
  zoo.settings.behaviour = 1;
  zoo.run(2);
  EXPECT_FALSE(zoo.active());
  zoo.pointer = Vec3(1, 0, 2);
  zoo.wetness = 1;
  EXPECT_FALSE(zoo.active());
  EXPECT_FALSE(zoo.step(1 / 60.0f));
  EXPECT_TRUE(zoo.behaviour.act("sit"));
  EXPECT_TRUE(zoo.active());
  zoo.run(1);
  EXPECT_EQ(zoo.behaviour.action(), Action::Sit);
  zoo.run(15);
  EXPECT_EQ(zoo.behaviour.action(), Action::Stand);
  EXPECT_FALSE(zoo.active());
  // Another animation than standing plays as that of any model.
  zoo.settings.animation = 2;
  EXPECT_TRUE(zoo.step(1 / 60.0f));
  EXPECT_EQ(zoo.behaviour.mix(), nullptr);
}

TEST(Behaviour, LessMotionKeepsItStillButForWhatAPersonDoes) {
  Zoo zoo;
  zoo.reducedMotion = true;
  zoo.run(2);
  EXPECT_FALSE(zoo.active());
  zoo.wetness = 1;
  zoo.run(5);
  EXPECT_EQ(zoo.behaviour.action(), Action::Stand);
  EXPECT_FALSE(zoo.active());
  zoo.hand = Vec3(0.4f, 0.2f, 0);
  EXPECT_TRUE(zoo.step(1 / 60.0f));
  zoo.hand.reset();
  zoo.run(2);
  EXPECT_FALSE(zoo.active());
  EXPECT_TRUE(zoo.behaviour.act("shake"));
  zoo.run(0.5f);
  EXPECT_EQ(zoo.behaviour.action(), Action::Shake);
}

TEST(Behaviour, LeftAloneItDozesAndWakesWhenSomebodyComes) {
  Zoo zoo;
  zoo.run(110);
  EXPECT_FALSE(zoo.active());
  EXPECT_FALSE(zoo.step(1 / 60.0f));
  zoo.idleTime = 0;
  EXPECT_TRUE(zoo.active());
  EXPECT_TRUE(zoo.step(1 / 60.0f));
}

TEST(Behaviour, YawnsOnceBeforeItDozes) {
  Zoo zoo(Animal({"yawn"}));
  int yawns = 0;
  bool before = false;
  for (int i = 0; i < 110 * 60; ++i) {
    zoo.step(1 / 60.0f);
    const bool now = zoo.behaviour.action() == Action::Yawn;
    if (now && !before) {
      ++yawns;
      EXPECT_GT(zoo.idleTime, 50);
    }
    before = now;
  }
  EXPECT_EQ(yawns, 1);
  EXPECT_FALSE(zoo.active());
}

TEST(Behaviour, TheExtentHoldsWhatItDoesNowAndNoMore) {
  Animal large;
  large.rig.scale = 1.5f;
  for (Vec3& p : large.mesh.positions) p *= 1.5f;
  Zoo zoo(large);
  zoo.settings.behaviour = 1;
  zoo.run(1);
  const app::ShapeStage::Extent stands = zoo.shape.extent();
  zoo.behaviour.act("sit");
  float widest = 0;
  for (int i = 0; i < 13 * 60; ++i) {
    zoo.step(1 / 60.0f);
    const auto [centre, radius] = zoo.shape.extent();
    widest = std::max(widest, radius);
    // It is measured at some poses, between which vertices move by a hundredth.
    for (const Vec3& p : zoo.shape.skin()->positions) ASSERT_LT(glm::distance(p, centre), radius + 0.02f) << i;
  }
  EXPECT_GT(widest, stands.radius);
  EXPECT_EQ(zoo.shape.extent().radius, stands.radius);
  EXPECT_EQ(zoo.shape.extent().centre, stands.centre);
}

TEST(Behaviour, HeldItStandsWhereItIs) {
  Zoo zoo;
  zoo.run(1);
  zoo.settings.animationSpeed = 0;
  EXPECT_FALSE(zoo.step(1 / 60.0f));
  EXPECT_FALSE(zoo.active());
}

TEST(Behaviour, TheSameSeedDoesTheSameOnEveryPlatform) {
  Zoo zoo;
  Fnv1a hash;
  for (int i = 0; i < 60 * 60; ++i) {
    zoo.wetness = i > 1800 ? 0.5f : 0.0f;
    if (i % 240 == 100) zoo.pointer = Vec3(0.01f * static_cast<float>(i % 700) - 3, 0.2f, 1.5f);
    if (i % 240 == 200) zoo.pointer.reset();
    if (i % 400 == 399) zoo.landed.push_back(zoo.triangleAt({0.1f, 0.55f, 0.5f}));
    zoo.step(1 / 60.0f);
    hash.add(static_cast<int>(zoo.behaviour.action()));
    if (i % 30 == 0)
      for (const Vec3& p : zoo.shape.skin()->positions) hash.add(p);
  }
  test::printOnEveryPlatform("a minute of an animal", hash.value());
}

}  // namespace
}  // namespace fur::app
