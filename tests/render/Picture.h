// A drawing buffer for tests: an offscreen target, a context, and questions to the picture.
#pragma once

#include <gtest/gtest.h>

#include <array>
#include <cstdlib>
#include <initializer_list>
#include <optional>
#include <utility>
#include <vector>

#include "app/App.h"
#include "geometry/Primitives.h"
#include "gl/Objects.h"
#include "native/headless/EglContext.h"
#include "scene/Model.h"
#include "scene/Png.h"

namespace fur::test {

struct Picture {
  int width = 0, height = 0;
  std::vector<std::uint8_t> rgba;

  const std::uint8_t* at(int x, int y) const { return &rgba[4 * (static_cast<std::size_t>(y) * width + x)]; }
  // Share of pixels in which some channel differs by more than `tolerance`.
  float differingShare(const Picture& other, int tolerance) const {
    std::size_t count = 0;
    for (std::size_t i = 0; i < rgba.size(); i += 4) {
      int most = 0;
      for (std::size_t k = 0; k < 3; ++k) most = std::max(most, std::abs(rgba[i + k] - other.rgba[i + k]));
      count += most > tolerance;
    }
    return static_cast<float>(count) / static_cast<float>(rgba.size() / 4);
  }
  // Mean of all channels, 0..255.
  float brightness() const {
    double sum = 0;
    for (std::size_t i = 0; i < rgba.size(); i += 4) sum += rgba[i] + rgba[i + 1] + rgba[i + 2];
    return static_cast<float>(sum / (static_cast<double>(rgba.size()) * 0.75));
  }
};

// Means over all channels of blocks of 10 by 10 pixels, row by row; and how far two of them are apart on average, 0..255.
inline std::vector<float> blocksOf(const Picture& picture) {
  const int across = picture.width / 10;
  std::vector<float> means(static_cast<std::size_t>(across * (picture.height / 10)));
  for (int y = 0; y < picture.height; ++y)
    for (int x = 0; x < picture.width; ++x)
      for (int k = 0; k < 3; ++k) means[static_cast<std::size_t>(y / 10 * across + x / 10)] += static_cast<float>(picture.at(x, y)[k]) / 300;
  return means;
}
inline float meanDifference(const std::vector<float>& a, const std::vector<float>& b) {
  float sum = 0;
  for (std::size_t i = 0; i < a.size(); ++i) sum += std::abs(a[i] - b[i]);
  return sum / static_cast<float>(a.size());
}

// One context a test program; each test draws into its own target.
class Stage {
 public:
  Stage(int width, int height, int samples = 0) : width_(width), height_(height) {
    static std::optional<native::EglContext> context = [] {
      auto made = native::EglContext::create();
      return made ? std::optional<native::EglContext>(std::move(*made)) : std::nullopt;
    }();
    EXPECT_TRUE(context.has_value()) << "no EGL context without a window";
    auto target = gl::Target::offscreen(width, height, samples);
    auto resolved = gl::Target::offscreen(width, height, 0);
    EXPECT_TRUE(target && resolved);
    target_ = std::move(*target);
    resolved_ = std::move(*resolved);
    target_.bind();
  }

  Picture draw(app::App& app) {
    target_.bind();
    const Status status = app.draw();
    EXPECT_TRUE(status) << (status ? "" : status.error().message);
    return read();
  }
  Picture read() {
    resolved_.resolve(target_, width_, height_);
    Picture picture{width_, height_, gl::readPixels(width_, height_)};
    EXPECT_EQ(gl::takeError(), "");
    target_.bind();
    return picture;
  }
  void attachTarget() const { target_.bind(); }
  // With the sphere that tests look at, unless it has a model.
  void attach(app::App& app) {
    target_.bind();
    if (app.modelName() == "plane") EXPECT_TRUE(app.loadPrimitive("sphere"));
    app.setField("lie", "0");  // upright, as what tests are about
    app.resize(width_, height_, 1);
    const Status status = app.attach();
    ASSERT_TRUE(status) << (status ? "" : status.error().message);
  }

 private:
  int width_, height_;
  gl::Target target_, resolved_;
};

// A plane in nine parts, each too small for a sheet: fur ends at their borders, and fins stand there.
inline std::vector<std::uint8_t> planeInParts() {
  const geometry::Mesh plane = geometry::makePlane(3);
  geometry::Mesh parts;
  for (std::size_t i = 0; i < plane.indices.size(); i += 6) {
    Vec3 middle(0);
    for (std::size_t k = 0; k < 6; ++k) middle += plane.positions[plane.indices[i + k]] / 6.0f;
    for (std::size_t k = 0; k < 6; ++k) {
      parts.indices.push_back(static_cast<std::uint32_t>(parts.positions.size()));
      parts.positions.push_back(middle + 0.98f * (plane.positions[plane.indices[i + k]] - middle));
      parts.normals.push_back(Vec3(0, 1, 0));
    }
  }
  return scene::exportGlb(parts, "parts");
}

// The app with a sphere, these settings and its fur at rest, in a small square picture.
struct Room {
  Stage stage;
  app::App app;

  Room(int side, std::initializer_list<std::pair<const char*, const char*>> settings) : stage(side, side) {
    stage.attach(app);
    for (const auto& [name, value] : settings) app.setField(name, value);
    app.settle();
    app.tick(0);
  }
  ~Room() { app.detach(false); }

  // Without time passing.
  void stroke(app::Tool tool, Vec2 from, Vec2 to) {
    constexpr int kMoves = 12;
    app.setTool(tool);
    app.pointer({.phase = app::PointerPhase::Down, .position = from, .buttons = 1});
    for (int i = 1; i <= kMoves; ++i)
      app.pointer({.phase = app::PointerPhase::Move, .position = glm::mix(from, to, static_cast<float>(i) / kMoves), .buttons = 1});
    app.pointer({.phase = app::PointerPhase::Up, .position = to});
  }
  Picture settled() {
    app.settle();
    app.tick(0);
    return stage.draw(app);
  }
};

// A picture of one colour, as a file and as it is.
struct OneColor {
  explicit OneColor(std::array<std::uint8_t, 4> color) : rgba(color.begin(), color.end()), png(scene::writePng(1, 1, 4, rgba)) {}
  std::vector<std::uint8_t> rgba, png;
};

// Of RGBA8.
inline double meanChannel(const std::vector<std::uint8_t>& pixels, std::size_t channel) {
  double sum = 0;
  for (std::size_t i = channel; i < pixels.size(); i += 4) sum += pixels[i];
  return sum / static_cast<double>(pixels.size() / 4);
}

// The app with a sphere and water that stays.
struct Scene {
  Stage stage;
  app::App app;

  explicit Scene(int width = 240, int height = 180, int samples = 4) : stage(width, height, samples) {
    stage.attach(app);
    app.setField("dryRate", "0");
    app.settle();
  }
  ~Scene() { app.detach(false); }
  Picture draw() { return stage.draw(app); }
  Picture with(const char* field, const char* value) {
    EXPECT_TRUE(app.setField(field, value));
    app.settle();
    return draw();
  }
};

}  // namespace fur::test
