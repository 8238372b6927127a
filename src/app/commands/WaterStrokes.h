// What was done with water, so that it can be done again: in links, in scenes, and after another program has taken over.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "app/commands/Commands.h"
#include "core/Bytes.h"
#include "core/Result.h"
#include "geometry/SurfaceQuery.h"

namespace fur::app {

struct WaterStroke {
  // Where it was at a step of the water's clock. Tools that go on while they are held are where their newest point says, up
  // to the last one, where they end.
  struct Point {
    std::uint32_t step;
    geometry::SurfacePoint at;
    float pressure;    // of a pen, 0..1
    float height = 0;  // above 0: on the long hair that grows there, at that share of its length
  };
  Command what = Command::Droplet;
  float radius = 0, flow = 0, clump = 0;  // of the brush; radius of clumps. Model units
  Vec3 eye{0};                            // where it was done from, model space
  std::vector<Point> points{};
};

// JSON: [[name, radius, flow, clump, eye x, y, z, step, triangle, weight, weight, pressure, ...], ...]; the last five are a
// point, as many times as there are points. To the pressure of one on long hair, 0..1, twice the thousandths of its height are added.
std::string writeStrokes(const std::vector<WaterStroke>& strokes);
// The way back, on a surface of so many triangles; commands may also be numbers (Commands.inc). bad-file unless all is sound.
Result<std::vector<WaterStroke>> readStrokes(std::string_view json, std::size_t triangles);

void saveStrokes(ByteWriter& to, const std::vector<WaterStroke>& strokes);
// Unsound bytes leave `from` unsound.
std::vector<WaterStroke> restoreStrokes(ByteReader& from);

}  // namespace fur::app
