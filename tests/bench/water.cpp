// How long water takes: strokes, picks and steps on a torus of 142 thousand triangles, mask of 512 x 512. Built for
// Node as wet-fur-water-bench.js of the wasm preset, or natively. The best of some rounds each.
#include <chrono>
#include <cstdio>
#include <optional>

#include "geometry/Primitives.h"
#include "wet/MaskEncoding.h"
#include "wet/Water.h"

using namespace fur;

namespace {

template <class Work>
double best(int rounds, Work work) {
  double least = 1e9;
  for (int i = 0; i < rounds; ++i) {
    const auto begun = std::chrono::steady_clock::now();
    work(i);
    least = std::min(least, std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - begun).count());
  }
  return least;
}

void show(const char* what, double ms) { std::printf("%-52s %8.3f ms\n", what, ms); }

}  // namespace

int main() {
  constexpr int kSize = 512;
  geometry::Mesh mesh = geometry::makeTorus(377, 188);
  mesh.uv.clear();
  const geometry::Surface surface = geometry::buildSurface(mesh).value();
  const geometry::SurfaceQuery query(surface);
  const wet::SurfaceWetting wetting(surface, kSize);
  const wet::WetSurface skin{surface, query, wetting};
  wet::WetnessMask mask(kSize);
  Random random(1);
  const auto anywhere = [&] { return static_cast<std::uint32_t>(random.uniform() * static_cast<float>(surface.triangleCount())); };
  std::printf("%zu triangles, mask %d\n", surface.triangleCount(), kSize);

  show("pick, mean of 1000", best(5, [&](int) {
    for (int i = 0; i < 1000; ++i) query.castRay(Vec3(random.uniform(-1, 1), 2, random.uniform(-1, 1)), Vec3(0.1f, -1, 0));
  }) / 1000);
  show("60 droplets of radius 0.05, on the surface", best(20, [&](int) {
    const geometry::SurfacePoint start{anywhere(), Vec3(1 / 3.0f), 0};
    const Vec3 at = positionAt(surface, start), normal = normalAt(surface, start);
    for (int i = 0; i < 60; ++i) wetting.addDroplet(mask, surface, query, at, normal, 0.05f, 0.35f);
  }));
  mask.clear();

  wet::Water water;
  show("ways of the water, once a model", best(1, [&](int) { water.prepare(skin); }));
  wet::Climate climate;
  const auto step = [&](int) { water.step(skin, mask, climate); };
  show("step, dry", best(50, step));
  const auto& places = water.texels()->places();
  std::printf("%zu places\n", places.size());
  for (int i = 0; i < 60; ++i) wetting.addDroplet(mask, surface, query, places[9].position, places[9].normal, 0.05f, 0.35f);
  show("first step after a stroke: locks for the model", best(1, step));
  show("step, one stroke", best(50, step));
  for (int round = 0; round < 2; ++round)
    for (std::size_t i = 0; i < places.size(); i += 40) wetting.addDroplet(mask, surface, query, places[i].position, places[i].normal, 0.06f, 0.7f);
  show("first step after a flood", best(1, step));
  std::optional<wet::WaterAround> around;
  show("cells of the water round each place, once a model", best(1, [&](int) { around.emplace(*water.texels()); }));
  const auto encode = [&](int) {
    around->update(mask, mask.takeChangedParts());
    for (const wet::TexelRect& part : around->takeChanged()) wet::encodeMask(mask, part, wetting.chartOfTexel(), &*around);
  };
  encode(0);
  double worst = 0, sum = 0;
  for (int i = 0; i < 60; ++i) {
    const double ms = best(1, step);
    worst = std::max(worst, ms);
    sum += ms / 60;
  }
  show("step, flooded: mean of a second", sum);
  show("step, flooded: worst of a second", worst);
  sum = 0;
  for (int i = 0; i < 20; ++i) {
    step(0);
    sum += best(1, encode) / 20;
  }
  show("what the picture takes of it, flooded: mean", sum);
  show("step, flooded, that a stroke goes on in", best(20, [&](int) {
    wetting.addDroplet(mask, surface, query, places[9].position, places[9].normal, 0.05f, 0.35f);
    step(0);
  }));
  for (int i = 0; i < 1200; ++i) step(0);
  sum = 0;
  for (int i = 0; i < 60; ++i) sum += best(1, step) / 60;
  show("step, twenty seconds later: mean of a second", sum);
  climate.rain = 1;
  for (int i = 0; i < 120; ++i) step(0);
  sum = 0;
  for (int i = 0; i < 60; ++i) sum += best(1, step) / 60;
  show("step, in the rain: mean of a second", sum);
  std::printf("the same everywhere: %016llx\n", static_cast<unsigned long long>(water.hash(mask)));
}
