// How long a step of guides takes, by model and by what acts on them, and to show them; and a step of the water in them, soaked
// and in the rain. Built for Node as wet-fur-hair-bench.js of the wasm preset,
// or natively. The best of some rounds of a second each, taken in turn, so that what else the machine does meets all alike.
#include <algorithm>
#include <chrono>
#include <cstdio>
#include <vector>

#include "hair/HairWater.h"
#include "tests/hair/Mane.h"

using namespace fur;
using namespace fur::hair;

namespace {

constexpr int kStepsEach = 4;  // in a frame

struct Case {
  const char* what = "";
  int across, nodes;
  Model model;
  bool storm, colliders, volume, adaptive, calm = false;
  double best = 1e9, bestShown = 1e9;  // microseconds a frame
};

double microseconds(std::chrono::steady_clock::duration time) { return std::chrono::duration<double, std::micro>(time).count(); }

// A second of frames; and of as many frames without a step between the least.
void run(Case& one) {
  Shaken hair{Mane(one.across, one.nodes)};
  hair.values.model = one.model;
  hair.values.volume = one.volume ? 0.5f : 0.0f;
  hair.values.adaptive = one.adaptive;
  if (one.calm) hair.wind = {Vec3(0.12f, 0, 0.05f), 0.3f, 0, 0};
  if (one.storm) hair.wind = {Vec3(0.5f, 0.1f, 0.2f), 0.6f, 0.4f, 0};
  if (one.colliders)
    for (int i = 0; i < 4; ++i) {
      const Vec3 at(0.3f * static_cast<float>(i) - 0.4f, 0.9f, 0.1f * static_cast<float>(i));
      hair.colliders.push_back({at, at, 0.15f});
    }
  if (one.calm) hair.run(2);
  double sum = 0;
  constexpr int kFrames = 30;
  for (int frame = 0; frame < kFrames; ++frame) {
    const float t = static_cast<float>(frame) / 30.0f;
    if (!one.calm) hair.place(glm::rotate(kHere, 0.5f * portableSin(6 * t), Vec3(0.2f, 1, 0.1f)));
    hair.wind.time = t;
    auto begun = std::chrono::steady_clock::now();
    hair.advance(0.01f * kStep);
    one.bestShown = std::min(one.bestShown, microseconds(std::chrono::steady_clock::now() - begun));
    begun = std::chrono::steady_clock::now();
    hair.advance(kStepsEach * kStep * 0.9975f);
    sum += microseconds(std::chrono::steady_clock::now() - begun);
  }
  one.best = std::min(one.best, sum / kFrames);
}

struct WaterCase {
  const char* what = "";
  int across, nodes, wisps;
  double best = 1e9, bestRain = 1e9, bestGrid = 1e9;  // microseconds a step, a step of rain, to find where hair lies
};

// Soaked hair that swings, runs and dries: as much work as there is.
void run(WaterCase& one) {
  Shaken hair{Mane(one.across, one.nodes)};
  HairWater water;
  std::vector<Wisp> wisps;
  const auto guides = static_cast<std::uint32_t>(hair.mane.guides.count());
  const std::vector<float> lengths(guides, hair.mane.length);
  for (int w = 0; w < one.wisps; ++w) {
    Wisp wisp;
    wisp.guides = {static_cast<std::uint32_t>(w) % guides, static_cast<std::uint32_t>(w + 1) % guides, static_cast<std::uint32_t>(w + 2) % guides};
    wisp.weights = {0.6f, 0.3f, 0.1f};
    wisps.push_back(wisp);
  }
  const auto shown = [&] { return ShownHair{wisps, hair.nodes(), one.nodes, {}}; };
  water.assign(shown(), lengths);
  water.soak(1);
  const HairAir air{0.02f, Vec3(0), 0, 0};
  std::vector<HairDrop> left;
  double sum = 0, rain = 0, grid = 0;
  constexpr int kFrames = 30;
  for (int frame = 0; frame < kFrames; ++frame) {
    hair.place(glm::rotate(kHere, 0.5f * portableSin(0.2f * static_cast<float>(frame)), Vec3(0.2f, 1, 0.1f)));
    hair.advance(HairWater::kStep);
    auto begun = std::chrono::steady_clock::now();
    water.move(hair.nodes(), HairWater::kStep);
    water.step(shown(), air, left, 1000);
    sum += microseconds(std::chrono::steady_clock::now() - begun);
    begun = std::chrono::steady_clock::now();
    water.meet(shown(), Vec3(9, 9, 9), Vec3(0, 1, 0));
    grid += microseconds(std::chrono::steady_clock::now() - begun);
    begun = std::chrono::steady_clock::now();
    // As many drops as there are in the air.
    for (int i = 0; i < 250; ++i) water.take(shown(), Vec3(0.005f * static_cast<float>(i) - 0.6f, 0.8f, 0), Vec3(0, -0.08f, 0), 1.6e-3f);
    rain += microseconds(std::chrono::steady_clock::now() - begun);
  }
  one.best = std::min(one.best, sum / kFrames);
  one.bestRain = std::min(one.bestRain, rain / kFrames);
  one.bestGrid = std::min(one.bestGrid, grid / kFrames);
}

}  // namespace

int main() {
  constexpr Model kModels[] = {Model::Spring, Model::Cascade, Model::Forest};
  constexpr const char* kNames[] = {"spring", "cascade", "forest"};
  std::vector<Case> cases;
  for (int m = 0; m < 3; ++m) {
    cases.push_back({"121 x 8, alone", 11, 8, kModels[m], false, false, false, false});
    cases.push_back({"121 x 8, crowding", 11, 8, kModels[m], false, false, true, false});
    cases.push_back({"121 x 8, crowding, wind", 11, 8, kModels[m], true, false, true, false});
    cases.push_back({"121 x 16, crowding, wind", 11, 16, kModels[m], true, false, true, false});
    cases.push_back({"529 x 8, crowding, wind", 23, 8, kModels[m], true, false, true, false});
    cases.push_back({"529 x 16, crowding, wind, 4 spheres", 23, 16, kModels[m], true, true, true, false});
    cases.push_back({"529 x 16, crowding, a breath of wind", 23, 16, kModels[m], false, false, true, false, true});
    cases.push_back({"the same, adaptive", 23, 16, kModels[m], false, false, true, true, true});
  }
  for (int round = 0; round < 7; ++round)
    for (Case& one : cases) run(one);
  for (const Case& one : cases)
    std::printf("%-8s %-38s %8.1f us a step %8.1f us to show\n", kNames[static_cast<int>(one.model)], one.what,
                (one.best - one.bestShown) / kStepsEach, one.bestShown);
  WaterCase waters[] = {{"121 x 8, 600 wisps", 11, 8, 600}, {"529 x 16, 2500 wisps", 23, 16, 2500}};
  for (int round = 0; round < 7; ++round)
    for (WaterCase& one : waters) run(one);
  for (const WaterCase& one : waters)
    std::printf("water    %-38s %8.1f us a step %8.1f us for 250 drops of rain %8.1f us to find where it lies\n", one.what, one.best, one.bestRain, one.bestGrid);
}
