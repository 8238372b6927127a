// Strands of a file as guides: few of them stand for all.
#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include "core/NumberText.h"
#include "scene/HairFile.h"

namespace fur::scene {

namespace {

using hair::Guides;

constexpr int kShapeNodes = 4;          // of a strand's shape as it is compared
constexpr float kShapeWeight = 0.5f;    // of differences in shape, beside those of roots
constexpr int kRounds = 4;              // of k-means
constexpr std::size_t kMostCompared = 4'000'000;  // strands times groups: every so many'th strand is enough
constexpr int kProbes = 400;            // places on a scalp by which it is measured

Error badFile(const std::string& name, const char* text) { return {ErrorId::BadFile, name + ": " + text}; }

Vec3 turned(const Vec3& p, HairUp up) { return up == HairUp::Z ? Vec3(p.x, p.z, -p.y) : p; }

struct Strand {
  std::size_t first, count;  // points
};

// A strand as it is compared: its root and where its shape is from there.
using Shape = std::array<Vec3, kShapeNodes>;

float apart(const Shape& a, const Shape& b) {
  float sum = 0;
  for (std::size_t i = 0; i < a.size(); ++i) sum += glm::dot(a[i] - b[i], a[i] - b[i]);
  return sum;
}

class Strands {
 public:
  Strands(const HairFile& hair, HairUp up) : hair_(hair), up_(up) {
    std::size_t first = 0;
    for (const std::uint16_t segments : hair.segments) {
      const Strand strand{first, segments + std::size_t{1}};
      first += strand.count;
      if (hair::lengthOf(std::span(hair.points).subspan(strand.first, strand.count)) > 0) strands_.push_back(strand);
    }
  }

  std::size_t size() const { return strands_.size(); }
  std::vector<Vec3> chain(std::size_t strand, int nodes) const {
    std::vector<Vec3> points;
    for (std::size_t i = 0; i < strands_[strand].count; ++i) points.push_back(turned(hair_.points[strands_[strand].first + i], up_));
    return hair::resampled(points, nodes);
  }
  Shape shape(std::size_t strand) const {
    const std::vector<Vec3> chain = this->chain(strand, kShapeNodes);
    Shape out;
    out[0] = chain[0];
    for (std::size_t i = 1; i < out.size(); ++i) out[i] = kShapeWeight * (chain[i] - chain[0]);
    return out;
  }

 private:
  const HairFile& hair_;
  HairUp up_;
  std::vector<Strand> strands_;
};

// Each the farthest from those before it, beginning with the first: an even start for k-means.
std::vector<Shape> farthest(const std::vector<Shape>& shapes, std::size_t count) {
  std::vector<Shape> out;
  std::vector<float> distance(shapes.size(), std::numeric_limits<float>::max());
  std::size_t next = 0;
  while (out.size() < count) {
    out.push_back(shapes[next]);
    for (std::size_t i = 0; i < shapes.size(); ++i) distance[i] = std::min(distance[i], apart(shapes[i], out.back()));
    next = static_cast<std::size_t>(std::max_element(distance.begin(), distance.end()) - distance.begin());
  }
  return out;
}

std::size_t nearest(const std::vector<Shape>& to, const Shape& shape) {
  std::size_t best = 0;
  float least = apart(to[0], shape);
  for (std::size_t i = 1; i < to.size(); ++i)
    if (const float distance = apart(to[i], shape); distance < least) least = distance, best = i;
  return best;
}

// The middles of the groups that are nearest to them.
void moveToMiddles(std::vector<Shape>& middles, const std::vector<Shape>& shapes) {
  std::vector<Shape> sums(middles.size(), Shape{});
  std::vector<float> counts(middles.size());
  for (const Shape& shape : shapes) {
    const std::size_t group = nearest(middles, shape);
    for (std::size_t i = 0; i < shape.size(); ++i) sums[group][i] += shape[i];
    ++counts[group];
  }
  for (std::size_t g = 0; g < middles.size(); ++g)
    for (std::size_t i = 0; counts[g] > 0 && i < kShapeNodes; ++i) middles[g][i] = sums[g][i] / counts[g];
}

// One strand for each group of strands that are alike, ascending.
std::vector<std::size_t> representatives(const Strands& strands, std::size_t count) {
  const std::size_t step = std::max(strands.size() * count / kMostCompared, std::size_t{1});
  std::vector<Shape> shapes;
  for (std::size_t i = 0; i < strands.size(); i += step) shapes.push_back(strands.shape(i));
  std::vector<std::size_t> chosen;
  if (shapes.size() > count) {
    std::vector<Shape> middles = farthest(shapes, count);
    for (int round = 0; round < kRounds; ++round) moveToMiddles(middles, shapes);
    for (const Shape& middle : middles) chosen.push_back(nearest(shapes, middle) * step);
  } else {
    for (std::size_t i = 0; i < shapes.size(); ++i) chosen.push_back(i * step);
  }
  std::vector<bool> taken(strands.size());
  for (const std::size_t i : chosen) taken[i] = true;
  chosen.clear();
  for (std::size_t i = 0; i < taken.size(); ++i)
    if (taken[i]) chosen.push_back(i);
  return chosen;
}

// The middle of places and how far they lie from it.
struct Extent {
  glm::dvec3 middle{0};
  double radius = 0;  // root of the mean square

  template <class Place>
  Extent(std::size_t count, Place place) {
    for (std::size_t i = 0; i < count; ++i) middle += glm::dvec3(place(i)) / static_cast<double>(count);
    double sum = 0;
    for (std::size_t i = 0; i < count; ++i) sum += glm::dot(glm::dvec3(place(i)) - middle, glm::dvec3(place(i)) - middle);
    radius = std::sqrt(sum / static_cast<double>(count));
  }
};

Vec3 footOf(const Guides& guides, std::size_t guide, const hair::ScalpSurface& scalp, const geometry::SurfaceQuery& query) {
  return hair::skinAt(scalp.surface, query, guides.root(guide), guides.of(guide)[1] - guides.root(guide));
}

// Whether hair may grow everywhere and nine of ten roots are near the skin as they are.
bool lieOnAll(const Guides& guides, const hair::ScalpSurface& scalp, const geometry::SurfaceQuery& query) {
  constexpr float kNear = 0.1f;  // model units
  const auto& texels = scalp.scalp.texels();
  if (!std::all_of(texels.begin(), texels.end(), [](const groom::GroomMap::Texel& texel) { return texel[0] == 255; })) return false;
  std::size_t near = 0;
  for (std::size_t g = 0; g < guides.count(); ++g) near += glm::distance(footOf(guides, g, scalp, query), guides.root(g)) < kNear;
  return 10 * near >= 9 * guides.count();
}

}  // namespace

Result<Guides> guidesOf(const HairFile& hair, const HairAsGuides& as, const std::string& name) {
  if (as.count < 1 || static_cast<std::size_t>(as.count) > hair::kMostGuides)
    return Error{ErrorId::TooLarge, name + ": " + decimal(as.count) + " guides; a scalp has 1 to " + decimal(hair::kMostGuides)};
  const Strands strands(hair, as.up);
  if (strands.size() == 0) return badFile(name, "none of its strands has a length");
  Guides out;
  out.nodes = std::clamp(as.nodes, hair::kLeastNodes, hair::kMostNodes);
  for (const std::size_t strand : representatives(strands, static_cast<std::size_t>(as.count))) {
    const std::vector<Vec3> chain = strands.chain(strand, out.nodes);
    out.positions.insert(out.positions.end(), chain.begin(), chain.end());
    out.flags.push_back(0);
  }
  return out;
}

Result<Guides> guidesOf(const HairFile& hair, const HairAsGuides& as, const std::string& name, const hair::ScalpSurface& scalp,
                        const geometry::SurfaceQuery& query) {
  Result<Guides> guides = guidesOf(hair, as, name);
  if (!guides) return guides;
  const std::vector<hair::Dart> darts = hair::throwDarts(scalp, kProbes, 1);
  if (darts.empty()) return badFile(name, "the scalp for its strands covers nothing: its density is 0 everywhere");
  if (!lieOnAll(*guides, scalp, query)) {
    const Extent from(guides->count(), [&](std::size_t i) { return guides->root(i); }), to(darts.size(), [&](std::size_t i) { return darts[i].position; });
    // One strand, or all from one place, has no extent: then as large as it is.
    const double scale = from.radius > 1e-6 && to.radius > 0 ? to.radius / from.radius : 1;
    for (Vec3& p : guides->positions) p = Vec3((glm::dvec3(p) - from.middle) * scale + to.middle);
  }
  for (std::size_t g = 0; g < guides->count(); ++g) {
    const Vec3 move = footOf(*guides, g, scalp, query) - guides->root(g);
    for (Vec3& p : guides->of(g)) p += move;
  }
  return guides;
}

}  // namespace fur::scene
