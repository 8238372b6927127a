#include "app/commands/WaterStrokes.h"

#include <algorithm>
#include <cmath>

#include "core/Json.h"
#include "core/NumberText.h"

namespace fur::app {

namespace {

// Values before the points, and of each point.
constexpr std::size_t kHead = 7, kPoint = 5;

std::optional<Command> commandIn(const Json& value) {
  return value.isString() ? commandNamed(value.text()) : commandNumbered(value.number());
}

// The stroke in one array of the text; none where a value is missing, no number or out of range.
std::optional<WaterStroke> readStroke(const Json& read, std::size_t triangles) {
  const std::size_t count = read.count();
  if (!read.isArray() || count <= kHead || (count - kHead) % kPoint != 0) return std::nullopt;
  std::vector<double> n;
  WaterStroke stroke;
  for (const Json& value : read) {
    const std::size_t i = n.size();
    if (i == 0) {
      const auto command = commandIn(value);
      if (!command || !isRecorded(*command)) return std::nullopt;
      stroke.what = *command;
      n.push_back(0);
      continue;
    }
    const bool isEye = i >= 4 && i < kHead, isTriangle = i >= kHead && (i - kHead) % kPoint == 1;
    n.push_back(value.number());
    // Weights may lie a hair outside their triangle.
    if (!(n[i] >= (isEye ? -1e4 : -1e-3) && n[i] < (isTriangle ? static_cast<double>(triangles) : 4e9))) return std::nullopt;
  }
  const auto at = [&n](std::size_t i, float low, float high) { return glm::clamp(static_cast<float>(n[i]), low, high); };
  stroke.radius = at(1, 0, 10);
  stroke.flow = at(2, 0, 3600);
  stroke.clump = at(3, 0.01f, 0.3f);
  stroke.eye = {at(4, -1e4f, 1e4f), at(5, -1e4f, 1e4f), at(6, -1e4f, 1e4f)};
  for (std::size_t i = kHead; i < count; i += kPoint) {
    const float y = at(i + 2, -1e-3f, 1), z = at(i + 3, -1e-3f, 1.001f);
    const float both = at(i + 4, 0, 2001), thousandths = std::floor(0.5f * both);
    stroke.points.push_back({static_cast<std::uint32_t>(std::max(n[i], 0.0)),
                             {static_cast<std::uint32_t>(std::max(n[i + 1], 0.0)), Vec3(1 - y - z, y, z), 0},
                             std::min(both - 2 * thousandths, 1.0f), 0.001f * thousandths});
  }
  return stroke;
}

}  // namespace

std::string writeStrokes(const std::vector<WaterStroke>& strokes) {
  std::string out = "[";
  for (const WaterStroke& stroke : strokes) {
    if (out.size() > 1) out += ',';
    const auto add = [&out](double value) { out.append(1, ',').append(shortDecimal(value)); };
    out.append("[\"").append(nameOf(stroke.what)).append(1, '"');
    for (const float value : {stroke.radius, stroke.flow, stroke.clump, stroke.eye.x, stroke.eye.y, stroke.eye.z}) add(value);
    for (const WaterStroke::Point& point : stroke.points) {
      add(point.step);
      add(point.at.triangle);
      for (const float value : {point.at.weights.y, point.at.weights.z, point.pressure + 2 * std::round(1000 * point.height)}) add(value);
    }
    out += ']';
  }
  return out + ']';
}

Result<std::vector<WaterStroke>> readStrokes(std::string_view json, std::size_t triangles) {
  const Error unsound{ErrorId::BadFile, "these are no strokes on this model"};
  const std::vector<Json> nodes = parseJson(json);
  if (nodes.empty() || !nodes[0].isArray()) return unsound;
  std::vector<WaterStroke> strokes;
  for (const Json& read : nodes[0]) {
    auto stroke = readStroke(read, triangles);
    if (!stroke) return unsound;
    strokes.push_back(std::move(*stroke));
  }
  return strokes;
}

void saveStrokes(ByteWriter& to, const std::vector<WaterStroke>& strokes) {
  to(static_cast<std::uint32_t>(strokes.size()));
  for (const WaterStroke& one : strokes) to(nameOf(one.what), one.radius, one.flow, one.clump, one.eye, one.points);
}

std::vector<WaterStroke> restoreStrokes(ByteReader& from) {
  std::vector<WaterStroke> strokes;
  std::uint32_t count = 0;
  for (from(count); count > 0 && from.sound(); --count) {
    const auto command = commandNamed(from.text());
    if (!command || !isRecorded(*command)) from.fail();
    WaterStroke& one = strokes.emplace_back();
    one.what = command.value_or(Command::Droplet);
    from(one.radius, one.flow, one.clump, one.eye, one.points);
  }
  return strokes;
}

}  // namespace fur::app
