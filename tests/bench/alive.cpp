// What a step of an animal takes that is soaked and shakes itself: its behaviour and pose, bends, whiskers, water. Built for Node as
// wet-fur-alive-bench.js of the wasm preset, or natively.
//   wet-fur-alive-bench [animal.glb]    by default two balls with the joints of one
// Of the steps of three shakes, each part by itself.
#include <algorithm>
#include <chrono>
#include <cstdio>
#include <fstream>
#include <iterator>
#include <numeric>

#include "app/stages/Animal.h"
#include "app/stages/MotionStage.h"
#include "app/stages/WaterStage.h"
#include "scene/Model.h"

using namespace fur;

namespace {

struct Part {
  const char* what;
  double last = 0;
  std::vector<double> all{};
  template <class Work>
  void time(Work work) {
    const auto begun = std::chrono::steady_clock::now();
    work();
    last = std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - begun).count();
    add(last);
  }
  void add(double ms) { all.push_back(ms); }
  // Of the steps a quick one, as on a machine that does nothing else, the middle one and the mean.
  void show() {
    std::sort(all.begin(), all.end());
    const double mean = std::accumulate(all.begin(), all.end(), 0.0) / static_cast<double>(all.size());
    std::printf("%-12s %7.3f ms, middle %7.3f, mean %7.3f\n", what, all[all.size() / 10], all[all.size() / 2], mean);
  }
};

scene::Model modelFrom(const char* path) {
  if (path) {
    std::ifstream file(path, std::ios::binary);
    const std::vector<std::uint8_t> bytes{std::istreambuf_iterator<char>(file), {}};
    auto model = scene::importModel(bytes, path);
    if (model && !model->rig.animations.empty()) return std::move(*model);
    std::printf("%s: %s\n", path, model ? "has no animations" : model.error().message.c_str());
  }
  test::Animal animal({"shake"}, "head", "breathe", 96);
  scene::Model model;
  model.mesh = animal.mesh;
  model.rig = animal.rig;
  for (Vec4& weights : model.rig.weights) weights = Vec4(0.4f, 0.3f, 0.2f, 0.1f);
  for (auto& joints : model.rig.joints) joints = {joints[0], 0, 2, 1};
  return model;
}

}  // namespace

int main(int count, char** words) {
  scene::Model model = modelFrom(count > 1 ? words[1] : nullptr);
  auto surface = geometry::buildSurface(model.mesh, geometry::FurMapping::Charts);
  settings::Settings settings;
  app::ShapeStage shape;
  app::BehaviourStage behaviour;
  app::GroomStage groom;
  app::WaterStage water;
  app::MotionStage motion;
  Warnings warnings;
  shape.setModel(std::move(model.mesh), std::move(*surface), std::move(model.rig), std::move(model.materialOf));
  groom.read(shape, model.fur, warnings);
  groom.update({shape, settings});
  std::printf("%zu triangles, %zu vertices of %zu, %zu joints, %zu whiskers\n", shape.surface().triangleCount(), shape.surface().vertices.size(), shape.mesh().positions.size(),
              shape.rig().nodes.size(), groom.groom().whiskers.size());
  water.beginStroke({app::Command::Soak, 0, 1, 0.05f, Vec3(0, 0, 3)});
  water.strokeAt(shape, {0, Vec3(1, 0, 0), 0});
  water.endStroke();

  Part parts[] = {{"behaviour"}, {"pose"}, {"bends"}, {"whiskers"}, {"water"}};
  Part all{"a step"};
  std::size_t drops = 0;
  const auto step = [&](bool counts) {
    app::BehaviourStage::Inputs in{.shape = shape, .settings = settings};
    in.landed = water.landed();
    in.wetness = 0.5f;
    in.seconds = 1 / 60.0f;
    app::MotionStage::Inputs moves{.shape = shape, .groom = groom, .water = water, .settings = settings};
    moves.seconds = in.seconds;
    app::WaterStage::Inputs wets{.shape = shape, .groom = groom, .settings = settings};
    wets.seconds = in.seconds;
    Part now[] = {{"behaviour"}, {"pose"}, {"bends"}, {"whiskers"}, {"water"}};
    now[0].time([&] { behaviour.update(in), water.forgetLanded(); });
    now[1].time([&] { shape.update({in.seconds, 0, 1, behaviour.mix(), behaviour.revision(), behaviour.played()}); });
    groom.update({shape, settings});
    now[2].time([&] { motion.update(moves); });
    now[3].time([&] { (void)groom.hairs(shape); });
    wets.shaking = behaviour.shaking();
    wets.bySkin = wets.shaking > 0;
    now[4].time([&] { water.update(wets); });
    drops = std::max(drops, water.water().drops().size());
    if (!counts) return;
    double sum = 0;
    for (std::size_t i = 0; i < std::size(parts); ++i) parts[i].add(now[i].last), sum += now[i].last;
    all.add(sum);
  };
  for (int i = 0; i < 5; ++i) step(false);
  for (int round = 0; round < 3; ++round) {
    behaviour.act("shake");
    for (int i = 0; i < 90; ++i) step(true);
  }
  for (Part& part : parts) part.show();
  all.show();
  std::printf("at most %zu drops\n", drops);
}
