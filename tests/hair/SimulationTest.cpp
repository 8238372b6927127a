#include "hair/Simulation.h"

#include <gtest/gtest.h>

#include <limits>

#include "hair/Mane.h"

namespace fur::hair {
namespace {

constexpr Model kModels[] = {Model::Spring, Model::Cascade, Model::Forest};

// To and fro and round, as one drags a model about.
Mat4 dragged(float t) {
  const Mat4 moved = glm::translate(kHere, Vec3(0.3f * portableSin(3 * t), 0.15f * portableSin(5 * t), 0.1f * portableSin(2 * t)));
  return glm::rotate(moved, 0.8f * portableSin(2.5f * t), glm::normalize(Vec3(0.3f, 1, 0.2f)));
}

TEST(Simulation, StaysInItsRestShapeUntilSomethingMovesIt) {
  for (const Model model : kModels) {
    Shaken hair;
    hair.values.model = model;
    hair.run(3);
    EXPECT_LT(farFromRest(hair.mane, hair.nodes()), 1e-4f) << static_cast<int>(model);
    EXPECT_TRUE(hair.simulation.atRest());
  }
}

TEST(Simulation, KeepsEverySegmentsLength) {
  for (const Model model : kModels) {
    Shaken hair;
    hair.values.model = model;
    hair.wind.force = Vec3(0.5f, 0.1f, 0);
    hair.wind.gust = 0.5f;
    float worst = 0;
    for (int frame = 0; frame < 600; ++frame) {
      hair.place(dragged(static_cast<float>(frame) / 60.0f));
      hair.wind.time = frame / 60.0;
      hair.advance(1 / 60.0f);
      worst = std::max(worst, stretch(hair.mane, hair.nodes()));
    }
    EXPECT_LT(worst, 1e-4f) << static_cast<int>(model);
  }
}

TEST(Simulation, ReturnsToItsRestShapeAfterBeingThrownAbout) {
  for (const Model model : kModels)
    for (const float stiffness : {0.0f, 0.35f, 1.0f}) {
      Shaken hair;
      hair.values.model = model;
      hair.values.stiffness = stiffness;
      float most = 0;
      for (int frame = 0; frame < 120; ++frame) {
        hair.place(dragged(static_cast<float>(frame) / 60.0f));
        hair.advance(1 / 60.0f);
        most = std::max(most, farFromRest(hair.mane, hair.nodes(), dragged(static_cast<float>(frame) / 60.0f)));
      }
      EXPECT_GT(most, 0.03f);
      hair.place(kHere);
      hair.run(20);
      EXPECT_TRUE(hair.simulation.atRest()) << static_cast<int>(model) << ' ' << stiffness;
      EXPECT_LT(farFromRest(hair.mane, hair.nodes()), 0.01f) << static_cast<int>(model) << ' ' << stiffness;
    }
}

TEST(Simulation, LeavesTheSkinAsItWasModelled) {
  for (const Model model : kModels) {
    Shaken hair;
    hair.values.model = model;
    for (int frame = 0; frame < 120; ++frame) {
      const Mat4 where = dragged(static_cast<float>(frame) / 60.0f);
      hair.place(where);
      hair.advance(1 / 60.0f);
      for (std::size_t k = 0; k < hair.mane.roots.size(); ++k)
        for (std::size_t i = 0; i < 2; ++i)
          EXPECT_LT(glm::length(hair.nodes()[k * 8 + i].position - Vec3(where * Vec4(hair.mane.guides.of(k)[i], 1))), 1e-5f);
    }
  }
}

TEST(Simulation, TurnedAboutThePlumbLineMovesTheSame) {
  const Mat4 turned = glm::rotate(kHere, 1.1f, Vec3(0, 1, 0));
  for (const Model model : kModels) {
    Shaken a, b;
    a.values.model = b.values.model = model;
    a.values.volume = b.values.volume = 0;  // its grid stands in the world
    b.place(turned);
    float worst = 0, most = 0;
    for (int frame = 0; frame < 60; ++frame) {
      const Mat4 where = dragged(0.5f * static_cast<float>(frame) / 60.0f);
      a.place(where);
      b.place(turned * where);
      a.advance(1 / 60.0f);
      b.advance(1 / 60.0f);
      for (std::size_t k = 0; k < a.nodes().size(); ++k)
        worst = std::max(worst, glm::length(Vec3(turned * Vec4(a.nodes()[k].position, 1)) - b.nodes()[k].position));
      most = std::max(most, farFromRest(a.mane, a.nodes(), where));
    }
    EXPECT_GT(most, 0.04f);
    // Rounding, which swings magnify.
    EXPECT_LT(worst, 0.01f * most) << static_cast<int>(model);
  }
}

TEST(Simulation, HasNothingToDoForGravityAtRestHoweverMuchItIs) {
  for (const Model model : kModels) {
    Shaken hair;
    hair.values.model = model;
    for (const float gravity : {0.0f, 0.5f, 1.0f}) {
      hair.values.gravity = gravity;
      hair.run(2);
      EXPECT_LT(farFromRest(hair.mane, hair.nodes()), 1e-4f) << static_cast<int>(model) << ' ' << gravity;
    }
  }
}

TEST(Simulation, HangsWhereTheHeadIsTilted) {
  for (const Model model : kModels) {
    Shaken hair;
    hair.values.model = model;
    const Mat4 tilted = glm::rotate(kHere, 1.5f, Vec3(0, 0, 1));
    hair.place(tilted);
    hair.run(20);
    double now = 0, rest = 0;
    for (std::size_t k = 0; k < hair.nodes().size(); ++k) {
      now += static_cast<double>(hair.nodes()[k].position.y);
      rest += static_cast<double>((tilted * Vec4(hair.mane.guides.positions[k], 1)).y);
    }
    EXPECT_LT(now, rest - 0.02 * static_cast<double>(hair.nodes().size())) << static_cast<int>(model);
    EXPECT_TRUE(hair.simulation.atRest()) << static_cast<int>(model);
  }
}

TEST(Simulation, HangsLowerWhenWetAndSwingsLess) {
  for (const Model model : kModels) {
    Shaken dry, wet;
    dry.values.model = wet.values.model = model;
    wet.wetness.assign(wet.mane.guides.positions.size(), 1.0f);
    double heights[2] = {};
    for (Shaken* hair : {&dry, &wet}) {
      hair->run(8);
      for (const GuideNode& node : hair->nodes()) heights[hair == &wet] += static_cast<double>(node.position.y);
    }
    EXPECT_LT(heights[1], heights[0] - 0.01 * static_cast<double>(dry.nodes().size())) << static_cast<int>(model);
    EXPECT_EQ(wet.nodes()[9].wetness, 1);
    // How fast the tip still goes two seconds after a push.
    float speed[2] = {};
    for (Shaken* hair : {&dry, &wet}) {
      hair->wind.force = Vec3(0.4f, 0, 0.4f);
      hair->run(0.5f);
      hair->wind.force = Vec3(0);
      hair->run(1);
      for (int frame = 0; frame < 60; ++frame) {
        const Vec3 before = hair->nodes().back().position;
        hair->advance(1 / 60.0f);
        speed[hair == &wet] = std::max(speed[hair == &wet], glm::length(hair->nodes().back().position - before));
      }
    }
    EXPECT_LT(speed[1], 0.5f * speed[0]) << static_cast<int>(model);
  }
}

// Kinetic, and of height, per mass: without stiffness and volume there is no other.
double energyOf(std::span<const GuideNode> before, std::span<const GuideNode> now, float gravity) {
  double sum = 0;
  for (std::size_t k = 0; k < now.size(); ++k) {
    const Vec3 v = (now[k].position - before[k].position) * 120.0f;
    sum += 0.5 * static_cast<double>(glm::dot(v, v)) + static_cast<double>(gravity * now[k].position.y);
  }
  return sum;
}

TEST(Simulation, LosesEnergyWhenNothingDrivesIt) {
  for (const Model model : kModels) {
    Shaken hair{Mane(4, 8, 0.0f)};
    hair.values = {model, 0, 2, 0, 0.5f, 0.25f, 0, false};
    hair.place(glm::rotate(kHere, 2.5f, Vec3(0, 0, 1)));
    hair.run(4);  // it hangs
    hair.wind.force = Vec3(0.5f, 0, 0.2f);
    hair.run(1);
    hair.wind.force = Vec3(0);
    hair.run(0.1f);
    // Against what springs may hold in between, from swing to swing: the largest of each second.
    std::vector<double> largest;
    for (int second = 0; second < 8; ++second) {
      largest.push_back(-1e30);
      for (int step = 0; step < 120; ++step) {
        const std::vector<GuideNode> before(hair.nodes().begin(), hair.nodes().end());
        hair.advance(kStep);
        largest.back() = std::max(largest.back(), energyOf(before, hair.nodes(), 10));
      }
    }
    for (std::size_t i = 1; i < largest.size(); ++i) EXPECT_LE(largest[i], largest[i - 1] + 0.01) << static_cast<int>(model) << ' ' << i;
    EXPECT_LT(largest.back(), largest.front() - 0.1);
  }
}

TEST(Simulation, OfMirroredGuidesIsMirrored) {
  for (const Model model : kModels) {
    Mane mane;
    Mane other = mane;
    const auto mirrored = [](const Vec3& v) { return Vec3(-v.x, v.y, v.z); };
    for (Vec3& p : other.guides.positions) p = mirrored(p);
    // A mirrored frame is left-handed; with its tangent turned back it is right-handed again.
    for (RootFrame& r : other.roots) r = {mirrored(r.position), mirrored(r.normal), -mirrored(r.tangent)};
    Shaken a(mane), b(other);
    a.values.model = b.values.model = model;
    a.values.adaptive = b.values.adaptive = false;  // clusters are other ones
    float worst = 0;
    for (int frame = 0; frame < 60; ++frame) {
      const Vec3 at(0.3f * portableSin(0.1f * static_cast<float>(frame)), 0.1f, 0.1f * portableSin(0.07f * static_cast<float>(frame)));
      a.place(glm::translate(kHere, at));
      b.place(glm::translate(kHere, mirrored(at)));
      a.advance(1 / 60.0f);
      b.advance(1 / 60.0f);
      for (std::size_t k = 0; k < a.nodes().size(); ++k) worst = std::max(worst, glm::length(mirrored(a.nodes()[k].position) - b.nodes()[k].position));
    }
    EXPECT_LT(worst, 2e-3f) << static_cast<int>(model);
  }
}

TEST(Simulation, TakesTheSamePathAtEveryFrameRateBitForBit) {
  for (const Model model : kModels) {
    std::vector<std::vector<GuideNode>> seen;
    for (const int rate : {30, 60, 144, 240}) {
      Shaken hair;
      hair.values.model = model;
      hair.wind.force = Vec3(0.4f, 0.1f, 0.2f);
      for (int frame = 0; frame < rate; ++frame) hair.advance(1.0f / static_cast<float>(rate));
      seen.emplace_back(hair.nodes().begin(), hair.nodes().end());
    }
    EXPECT_GT(farFromRest(Mane(), seen[0]), 0.05f);
    EXPECT_EQ(farApart(seen[0], seen[1]), 0);
    EXPECT_EQ(farApart(seen[0], seen[3]), 0);
    // 144 frames of a float's 1/144 s are not quite a second: what is shown lies that much nearer to the step before.
    EXPECT_LT(farApart(seen[0], seen[2]), 1e-5f);
  }
}

TEST(Simulation, LooksTheSameAtEveryFrameRateWhenDragged) {
  for (const Model model : kModels) {
    std::vector<std::vector<GuideNode>> seen;
    float most = 0;
    for (const int rate : {30, 60, 144}) {
      Shaken hair;
      hair.values.model = model;
      hair.values.damping = 0.6f;
      for (int frame = 0; frame <= rate; ++frame) {
        hair.place(dragged(0.6f * static_cast<float>(frame) / static_cast<float>(rate)));
        hair.advance(1.0f / static_cast<float>(rate));
      }
      most = farFromRest(hair.mane, hair.nodes(), dragged(0.6f));
      seen.emplace_back(hair.nodes().begin(), hair.nodes().end());
    }
    EXPECT_LT(farApart(seen[0], seen[1]), 0.3f * most) << static_cast<int>(model);
    EXPECT_LT(farApart(seen[2], seen[1]), 0.15f * most) << static_cast<int>(model);
  }
}

TEST(Simulation, SleepsWhenStillAndWakesForEveryChange) {
  Shaken hair;
  hair.run(3);
  ASSERT_TRUE(hair.simulation.atRest());
  const std::size_t steps = hair.simulation.nodeSteps();
  EXPECT_FALSE(hair.advance(1 / 60.0f));
  EXPECT_EQ(hair.simulation.nodeSteps(), steps);
  const auto wakes = [&](auto change) {
    change();
    const bool woke = hair.advance(1 / 60.0f) && !hair.simulation.atRest();
    hair.run(30);
    return woke && hair.simulation.atRest();
  };
  EXPECT_TRUE(wakes([&] { hair.place(glm::translate(kHere, Vec3(0.01f, 0, 0))); }));
  EXPECT_TRUE(wakes([&] { hair.wind.force = Vec3(0.1f, 0, 0); }));
  EXPECT_TRUE(wakes([&] { hair.values.stiffness = 0.5f; }));
  EXPECT_TRUE(wakes([&] { hair.wetness.assign(hair.mane.guides.positions.size(), 0.5f); }));
  EXPECT_TRUE(wakes([&] { hair.colliders = {{Vec3(0, 0.8f, 0), Vec3(0, 0.8f, 0), 0.1f}}; }));
  EXPECT_TRUE(wakes([&] { hair.up = Vec3(1, 0, 0); }));
  hair.wind.gust = 0.5f;
  hair.run(5);
  EXPECT_FALSE(hair.simulation.atRest());
}

TEST(Simulation, SettlesAtOnceToWhereItWouldComeToRest) {
  for (const Model model : kModels) {
    Shaken stepped, settled;
    for (Shaken* hair : {&stepped, &settled}) {
      hair->values.model = model;
      hair->values.stiffness = 0.8f;
      hair->wind.force = Vec3(0.3f, 0, 0);
      hair->place(glm::rotate(kHere, 0.6f, Vec3(0, 0, 1)));
    }
    settled.simulation.settle(settled.values, settled.around());
    EXPECT_TRUE(settled.simulation.atRest());
    EXPECT_FALSE(settled.advance(1 / 60.0f));
    stepped.run(20);
    EXPECT_LT(farApart(stepped.nodes(), settled.nodes()), 0.01f) << static_cast<int>(model);
  }
}

TEST(Simulation, WorksInProportionToGuidesAndNodes) {
  const auto stepsOf = [](int across, int nodes) {
    Shaken hair{Mane(across, nodes)};
    hair.values.adaptive = false;
    hair.wind.force = Vec3(0.5f, 0, 0);
    for (int i = 0; i < 10; ++i) hair.advance(kStep);
    return hair.simulation.nodeSteps();
  };
  EXPECT_EQ(stepsOf(4, 8), 10u * 16 * 8);
  EXPECT_EQ(stepsOf(8, 8), 4 * stepsOf(4, 8));
  EXPECT_EQ(stepsOf(4, 32), 4 * stepsOf(4, 8));
}

TEST(Simulation, OfStaticGuidesGoesRigidlyWithTheirRoots) {
  Mane mane;
  mane.guides.flags[3] = mane.guides.flags[9] = kStatic;
  Shaken hair(mane);
  hair.wind.force = Vec3(0.5f, 0, 0);
  for (int frame = 0; frame < 60; ++frame) {
    const Mat4 where = dragged(static_cast<float>(frame) / 60.0f);
    hair.place(where);
    hair.advance(1 / 60.0f);
    for (const std::size_t guide : {3, 9})
      for (std::size_t i = 0; i < 8; ++i)
        EXPECT_LT(glm::length(hair.nodes()[guide * 8 + i].position - Vec3(where * Vec4(mane.guides.of(guide)[i], 1))), 1e-4f);
  }
  EXPECT_GT(farFromRest(mane, hair.nodes(), dragged(59 / 60.0f)), 0.05f);
}

// A breath of wind over many guides.
Shaken breathed(bool adaptive, int across = 12) {
  Shaken hair{Mane(across, 8)};
  hair.values.adaptive = adaptive;
  hair.wind = {Vec3(0.12f, 0, 0.05f), 0.3f, 0, 0};
  return hair;
}

TEST(Simulation, SimulatesCalmHairWithFewerGuidesAndLooksTheSame) {
  Shaken all = breathed(false), few = breathed(true);
  float worst = 0, most = 0, jump = 0;
  double apart = 0;
  for (int frame = 0; frame < 600; ++frame) {
    const std::vector<GuideNode> before(few.nodes().begin(), few.nodes().end());
    for (Shaken* hair : {&all, &few}) {
      hair->wind.time = frame / 60.0;
      hair->advance(1 / 60.0f);
    }
    worst = std::max(worst, farApart(all.nodes(), few.nodes()));
    for (std::size_t k = 0; k < few.nodes().size(); ++k)
      apart += static_cast<double>(glm::length(few.nodes()[k].position - all.nodes()[k].position)) / static_cast<double>(600 * few.nodes().size());
    most = std::max(most, farFromRest(all.mane, all.nodes()));
    if (frame > 0) jump = std::max(jump, farApart(before, few.nodes()));
  }
  EXPECT_LT(few.simulation.nodeSteps(), all.simulation.nodeSteps() * 6 / 10);
  EXPECT_GT(most, 0.03f);
  // Neighbours stand a little differently to the wind.
  EXPECT_LT(worst, 0.4f * most);
  EXPECT_LT(apart, 0.03 * static_cast<double>(most));
  EXPECT_LT(jump, 0.03f);
}

TEST(Simulation, TakesEveryGuideAsSoonAsHairIsThrownAbout) {
  Shaken hair = breathed(true);
  hair.run(4);
  const std::size_t calm = hair.simulation.nodeSteps();
  hair.run(1);
  const std::size_t second = hair.simulation.nodeSteps() - calm;
  for (int frame = 0; frame < 60; ++frame) {
    hair.place(dragged(static_cast<float>(frame) / 60.0f));
    hair.advance(1 / 60.0f);
  }
  const std::size_t thrown = hair.simulation.nodeSteps() - calm - second;
  EXPECT_LT(second, thrown / 2);
  EXPECT_GT(thrown, 120u * 144 * 8 * 9 / 10);
}

TEST(Simulation, KeepsCrowdedGuidesApart) {
  // Wind presses all guides to one side, where they would lie on each other.
  const auto spreadOf = [](float volume) {
    Shaken hair{Mane(8, 8, 0.3f)};
    hair.values.volume = volume;
    hair.values.stiffness = 0;
    hair.wind.force = Vec3(0.8f, -0.2f, 0);
    hair.run(6);
    Vec3 mean(0);
    for (std::size_t k = 7; k < hair.nodes().size(); k += 8) mean += hair.nodes()[k].position / 64.0f;
    float spread = 0;
    for (std::size_t k = 7; k < hair.nodes().size(); k += 8) spread += glm::length(hair.nodes()[k].position - mean) / 64.0f;
    return spread;
  };
  EXPECT_GT(spreadOf(1), 1.05f * spreadOf(0));
}

}  // namespace
}  // namespace fur::hair
