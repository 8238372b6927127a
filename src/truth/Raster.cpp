#include "truth/Raster.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/Srgb.h"
#include "hair/StrandShading.h"
#include "truth/Parallel.h"
#include "truth/Spans.h"
#include "truth/Wetting.h"

namespace fur::truth {

namespace {

constexpr float kNearest = 0.02f;
// Pixels along the side of a square that is drawn at a time: its samples stay in a processor's cache.
constexpr int kSquare = 32;

// A point of the picture: samples from the top left, and the distance along the view.
struct Projected {
  Vec2 at;
  float depth;
};

// Where a ray along the view meets a tube: how far along its axis, and how far beyond the disc `a`, in samples.
struct Hit {
  float along, beyond;
};

// `way` leads from a's centre to b's and `at` from there to the sample, whose nearest point of the axis, as the flat
// picture shows it, is at `flat`. Seen along its axis a tube shows its side from one end to the other, the flat
// picture its ends alone.
Hit meetTube(const Disc& a, const Disc& b, const Vec3& way, const Vec2& at, float flat) {
  const auto end = [&](float t) {
    const float radius = glm::mix(a.radius, b.radius, t), off = glm::length(at - Vec2(way) * t);
    return Hit{t, way.z * t - std::sqrt(std::max(radius * radius - off * off, 0.0f))};
  };
  // |P|^2 - (P . way)^2 / |way|^2 = radius^2 with P = (at, z), solved for the lesser z.
  const float squared = glm::dot(way, way), across = glm::dot(Vec2(way), Vec2(way)) / std::max(squared, 1e-12f);
  if (across < 1e-6f) return end(way.z < 0 ? 1.0f : 0.0f);
  const float foot = glm::dot(at, Vec2(way)) / squared, radius = glm::mix(a.radius, b.radius, flat);
  const float half = foot * way.z, rest = glm::dot(at, at) - squared * foot * foot - radius * radius;
  const float z = (half - std::sqrt(std::max(half * half - across * rest, 0.0f))) / across;
  const float along = foot + z * way.z / squared;
  return along >= 0 && along <= 1 ? Hit{along, z} : end(flat <= 0 || flat >= 1 ? flat : saturate(along));
}

struct Lists {
  std::vector<std::uint32_t> tubes, triangles;
};

class Raster {
 public:
  Raster(const Scene& scene, const Tubes& tubes, const std::vector<Vec3>& light, const Shadows& shadows, int width,
         int height, const Options& options)
      : scene_(scene), tubes_(tubes), light_(light), shadows_(shadows), options_(options), samples_(options.samples),
        size_(width * samples_, height * samples_), perUnit_(scene.frame.pixelsPerUnit * static_cast<float>(samples_)),
        squares_((width + kSquare - 1) / kSquare, (height + kSquare - 1) / kSquare) {
    picture_.width = width, picture_.height = height;
    picture_.pixels.resize(static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
    for (const TubeNode& node : tubes.nodes) nodes_.push_back(project(node.position));
    for (const auto& v : scene.surface.vertices) corners_.push_back(project(v.position));
    rootCover_ = rootShare();
    sortIntoSquares();
  }

  Picture draw() {
    inParallel(lists_.size(), [&](std::size_t square) { drawSquare(static_cast<int>(square)); });
    return std::move(picture_);
  }

 private:
  struct Square {
    Window window;  // samples
    int side;       // samples
    std::vector<float> depth;  // infinite where nothing is
    std::vector<Vec3> color;
    std::size_t index(int x, int y) const {
      return static_cast<std::size_t>(y - window.y0) * static_cast<std::size_t>(side) + static_cast<std::size_t>(x - window.x0);
    }
    float farthest() const {
      float out = 0;
      for (int y = window.y0; y < window.y1; ++y)
        for (int x = window.x0; x < window.x1; ++x) out = std::max(out, depth[index(x, y)]);
      return out;
    }
  };

  Projected project(const Vec3& p) const {
    const Vec4 clip = scene_.frame.clipFromModel * Vec4(p, 1);
    const Vec2 ndc = Vec2(clip) / std::max(clip.w, 1e-6f);
    return {Vec2(0.5f + 0.5f * ndc.x, 0.5f - 0.5f * ndc.y) * Vec2(size_), clip.w};
  }
  Disc disc(std::uint32_t node) const {
    const Projected& p = nodes_[node];
    return {p.at, tubes_.nodes[node].radius * perUnit_ / p.depth, p.depth};
  }

  float rootShare() const;
  template <class Corners>
  void sortOne(const Corners& corners, float margin, std::vector<std::uint32_t> Lists::*list, std::uint32_t index);
  void sortIntoSquares();
  void drawSquare(int index);
  void drawTubes(std::vector<std::uint32_t>& list, Square& square) const;
  void drawTube(const Tube& tube, Square& square) const;
  template <class Found>
  void drawSkin(std::uint32_t triangle, const Square& square, const Found& found) const;
  Vec3 skinColor(std::uint32_t triangle, const Vec3& weights) const;
  void resolve(const Square& square);
  Vec3 background(float row) const;

  const Scene& scene_;
  const Tubes& tubes_;
  const std::vector<Vec3>& light_;
  const Shadows& shadows_;
  const Options options_;
  int samples_;
  IVec2 size_;     // of the picture in samples
  float perUnit_;  // samples that a model unit covers at distance 1
  IVec2 squares_;
  float rootCover_ = 0;
  std::vector<Projected> nodes_, corners_;
  std::vector<float> nearest_;  // of each tube, the depth of what lies nearest to the eye
  std::vector<Lists> lists_;
  Picture picture_;
};

// What the lowest layer's mipmaps come to: the share of the skin that roots cover.
float Raster::rootShare() const {
  if (scene_.coat.furLength <= 0 || scene_.coat.densest <= 0.001f) return 0;
  float area = 0;
  for (const furgen::Strand& strand : scene_.strands.strands) {
    const float radius = scene_.strands.nodesOf(strand)[0].radius;
    area += kPi * radius * radius;
  }
  const auto size = static_cast<float>(scene_.strands.parameters.size);
  return std::min(area / (size * size), 1.0f);
}

template <class Corners>
void Raster::sortOne(const Corners& corners, float margin, std::vector<std::uint32_t> Lists::*list, std::uint32_t index) {
  Vec2 low(1e9f), high(-1e9f);
  for (const Projected& p : corners) {
    if (p.depth < kNearest) return;
    low = glm::min(low, p.at), high = glm::max(high, p.at);
  }
  const float side = static_cast<float>(kSquare * samples_);
  if (high.x + margin < 0 || high.y + margin < 0) return;
  const IVec2 first = glm::max(IVec2((low - margin) / side), IVec2(0)), last = glm::min(IVec2((high + margin) / side), squares_ - 1);
  for (int y = first.y; y <= last.y; ++y)
    for (int x = first.x; x <= last.x; ++x) (lists_[static_cast<std::size_t>(y * squares_.x + x)].*list).push_back(index);
}

void Raster::sortIntoSquares() {
  lists_.resize(static_cast<std::size_t>(squares_.x) * static_cast<std::size_t>(squares_.y));
  for (std::uint32_t t = 0; t < tubes_.tubes.size(); ++t) {
    const Tube& tube = tubes_.tubes[t];
    const std::span nodes = std::span(nodes_).subspan(tube.firstNode, tube.nodeCount);
    float widest = 0, nearest = std::numeric_limits<float>::infinity();
    for (std::uint32_t k = 0; k < tube.nodeCount; ++k) {
      widest = std::max(widest, disc(tube.firstNode + k).radius);
      nearest = std::min(nearest, nodes[k].depth - tubes_.nodes[tube.firstNode + k].radius);
    }
    nearest_.push_back(nearest);
    sortOne(nodes, widest, &Lists::tubes, t);
  }
  const auto& indices = scene_.surface.indices;
  for (std::uint32_t i = 0; i + 2 < indices.size(); i += 3)
    sortOne(std::array{corners_[indices[i]], corners_[indices[i + 1]], corners_[indices[i + 2]]}, 0, &Lists::triangles, i);
}

// From near to far, until none that is left could be seen.
void Raster::drawTubes(std::vector<std::uint32_t>& list, Square& square) const {
  constexpr std::size_t kBetweenLooks = 128;
  std::sort(list.begin(), list.end(), [&](auto a, auto b) { return std::pair(nearest_[a], a) < std::pair(nearest_[b], b); });
  float farthest = 0;
  for (std::size_t i = 0; i < list.size(); ++i) {
    if (i % kBetweenLooks == 0) farthest = square.farthest();
    if (nearest_[list[i]] > farthest) return;
    drawTube(tubes_.tubes[list[i]], square);
  }
}

void Raster::drawTube(const Tube& tube, Square& square) const {
  for (std::uint32_t k = 1; k < tube.nodeCount; ++k) {
    const std::uint32_t node = tube.firstNode + k;
    const Disc a = disc(node - 1), b = disc(node);
    const float perDepth = perUnit_ / a.depth;
    const Vec3 way(b.centre - a.centre, (b.depth - a.depth) * perDepth);
    const float front = std::min(a.depth, b.depth) - std::max(a.radius, b.radius) / perDepth;
    sweep(a, b, square.window, [&](int x, int y, float t) {
      const std::size_t i = square.index(x, y);
      if (front >= square.depth[i]) return;
      const Hit hit = meetTube(a, b, way, Vec2(x, y) + 0.5f - a.centre, t);
      const float depth = a.depth + hit.beyond / perDepth;
      if (depth >= square.depth[i]) return;
      square.depth[i] = depth;
      square.color[i] = glm::mix(light_[node - 1], light_[node], hit.along);
    });
  }
}

// found(index of the sample, depth, weights of the corners) for every sample of a triangle that faces the eye.
template <class Found>
void Raster::drawSkin(std::uint32_t triangle, const Square& square, const Found& found) const {
  Vec3 c[3];
  for (std::uint32_t k = 0; k < 3; ++k) {
    const Projected& corner = corners_[scene_.surface.indices[triangle + k]];
    c[k] = Vec3(corner.at, corner.depth);
  }
  // Rows run downwards: what faces the eye turns clockwise here.
  if ((c[1].x - c[0].x) * (c[2].y - c[0].y) - (c[1].y - c[0].y) * (c[2].x - c[0].x) >= 0) return;
  fillTriangle(c, square.window, [&](int x, int y, const Vec3& flat) {
    const Vec3 overDepth = flat / Vec3(c[0].z, c[1].z, c[2].z);
    const float depth = 1 / (overDepth.x + overDepth.y + overDepth.z);
    found(square.index(x, y), depth, overDepth * depth);
  });
}

Vec3 Raster::skinColor(std::uint32_t triangle, const Vec3& weights) const {
  Vec3 point(0), normal(0);
  Vec2 atlas(0);
  for (std::uint32_t k = 0; k < 3; ++k) {
    const geometry::SurfaceVertex& v = scene_.surface.vertices[scene_.surface.indices[triangle + k]];
    point += weights[static_cast<int>(k)] * v.position;
    normal += weights[static_cast<int>(k)] * v.normal;
    atlas += weights[static_cast<int>(k)] * v.atlas;
  }
  const float held = scene_.mask ? wetnessAt(*scene_.mask, atlas) : 0.0f;
  return shadeSkin(scene_, point, normalizeOr(normal, Vec3(scene_.frame.up)), rootCover_, held, shadows_, options_.light);
}

void Raster::drawSquare(int index) {
  Square square;
  square.side = kSquare * samples_;
  const IVec2 corner = IVec2(index % squares_.x, index / squares_.x) * square.side;
  square.window = {corner.x, corner.y, std::min(corner.x + square.side, size_.x), std::min(corner.y + square.side, size_.y)};
  const std::size_t count = static_cast<std::size_t>(square.side) * static_cast<std::size_t>(square.window.y1 - corner.y);
  square.depth.assign(count, std::numeric_limits<float>::infinity());
  square.color.resize(count);
  Lists& lists = lists_[static_cast<std::size_t>(index)];
  for (const std::uint32_t t : lists.triangles)
    drawSkin(t, square, [&](std::size_t i, float depth, const Vec3&) { square.depth[i] = std::min(square.depth[i], depth); });
  drawTubes(lists.tubes, square);
  // Skin is lit only where no strand has come before it.
  for (const std::uint32_t t : lists.triangles)
    drawSkin(t, square, [&](std::size_t i, float depth, const Vec3& weights) {
      if (depth == square.depth[i]) square.color[i] = skinColor(t, weights);
    });
  resolve(square);
}

// background.frag, less its noise.
Vec3 Raster::background(float row) const {
  const float up = 1 - (row + 0.5f) / static_cast<float>(picture_.height);
  return Vec3(glm::mix(scene_.frame.backgroundBottom, scene_.frame.backgroundTop, glm::smoothstep(0.0f, 1.0f, up)));
}

void Raster::resolve(const Square& square) {
  const Window& w = square.window;
  for (int y = w.y0 / samples_; y < w.y1 / samples_; ++y) {
    const Vec3 behind = background(static_cast<float>(y));
    for (int x = w.x0 / samples_; x < w.x1 / samples_; ++x) {
      Vec3 sum(0);
      int covered = 0;
      for (int k = 0; k < samples_ * samples_; ++k) {
        const std::size_t i = square.index(x * samples_ + k % samples_, y * samples_ + k / samples_);
        if (std::isinf(square.depth[i])) continue;
        sum += square.color[i];
        ++covered;
      }
      Vec3& pixel = picture_.pixels[static_cast<std::size_t>(y * picture_.width + x)];
      pixel = behind;
      if (covered == 0) continue;
      const Vec3 shown = hair::toneMap(sum / static_cast<float>(covered), scene_.frame.exposure);
      const float share = static_cast<float>(covered) / static_cast<float>(samples_ * samples_);
      pixel = encodeSrgb(glm::mix(decodeSrgb(behind), shown, share));
    }
  }
}

}  // namespace

Picture drawPicture(const Scene& scene, const Tubes& tubes, const std::vector<Vec3>& light, const Shadows& shadows,
                    int width, int height, const Options& options) {
  return Raster(scene, tubes, light, shadows, width, height, options).draw();
}

}  // namespace fur::truth
