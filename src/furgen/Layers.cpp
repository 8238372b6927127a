#include "furgen/Layers.h"

#include <algorithm>
#include <cmath>

#include "furgen/Canvas.h"
#include "furgen/NearestFill.h"
#include "furgen/Packing.h"
#include "furgen/Strand.h"

namespace fur::furgen {

namespace {

// Pieces of a strand inside one layer that deviate less than this from their chord are drawn as one, texels.
constexpr float kStraight = 0.2f;

// A point of a strand's axis, texels from its root.
struct AxisPoint {
  Vec2 shift;
  float height, radius;
};

AxisPoint pointBetween(const Node& a, const Node& b, float height) {
  const float t = b.height != a.height ? saturate((height - a.height) / (b.height - a.height)) : 0.0f;
  return {a.shift + (b.shift - a.shift) * t, mix(a.height, b.height, t), mix(a.radius, b.radius, t)};
}

// What a strand shows of itself in one layer: a disc swept along a short straight way.
struct Cut {
  Stroke stroke;  // texels of the tile, not wrapped
  Vec2 shift;     // from the root to the middle of the way
  std::int8_t tangent[3];
};

}  // namespace

void packTangent(const Vec2& way, float rise, std::int8_t* out) {
  Vec3 t(way.x, way.y, rise * kHeightTexels);
  // Light on a strand is the same from its root to its tip and back.
  if (t.z < 0.0f) t = -t;
  const float length = std::sqrt(t.x * t.x + t.y * t.y + t.z * t.z);
  const auto byte = [&](float x) { return static_cast<std::int8_t>(std::floor(x / length * 127.0f + 0.5f)); };
  if (length < 1e-9f) {
    out[0] = out[1] = 0, out[2] = 127;
    return;
  }
  out[0] = byte(t.x);
  out[1] = byte(t.y);
  out[2] = std::max<std::int8_t>(byte(t.z), 1);
}

struct LayerPainter::Scratch {
  explicit Scratch(const Coat& c)
      : coat(c), canvas(c.parameters.size, c.parameters.size, true, 1.0f), nearest(c.parameters.size) {}

  void cutStrand(std::uint16_t index, float low, float high);
  void cutChain(std::uint16_t index);
  void addCut(std::uint16_t index, const AxisPoint& a, const AxisPoint& b);
  void write(LayerMaps& out);

  const Coat& coat;
  Canvas canvas;
  NearestFill nearest;
  std::vector<Cut> cuts;
  std::vector<AxisPoint> chain;
  int stage = 0;  // of step()
};

void LayerPainter::Scratch::addCut(std::uint16_t index, const AxisPoint& a, const AxisPoint& b) {
  const float radius = 0.5f * (a.radius + b.radius);
  if (radius <= 0.0f) return;
  Cut cut;
  cut.stroke = {coat.strands[index].root + a.shift, b.shift - a.shift, radius, index};
  cut.shift = 0.5f * (a.shift + b.shift);
  packTangent(cut.stroke.way, b.height - a.height, cut.tangent);
  cuts.push_back(cut);
}

// A chain that runs on nearly straight becomes one cut.
void LayerPainter::Scratch::cutChain(std::uint16_t index) {
  std::size_t from = 0;
  for (std::size_t to = 2; to <= chain.size(); ++to) {
    // As far as the chord from `from` stays near every point on the way.
    bool near = to < chain.size();
    for (std::size_t k = from + 1; near && k < to; ++k) {
      const float t = (chain[k].height - chain[from].height) / (chain[to].height - chain[from].height);
      const Vec2 off = chain[from].shift + (chain[to].shift - chain[from].shift) * t - chain[k].shift;
      near = t > 0.0f && t < 1.0f && std::abs(off.x) + std::abs(off.y) < kStraight;
    }
    if (near) continue;
    addCut(index, chain[from], chain[to - 1]);
    from = to - 1;
  }
  chain.clear();
}

// The strand's pieces between two heights.
void LayerPainter::Scratch::cutStrand(std::uint16_t index, float low, float high) {
  const auto nodes = coat.nodesOf(coat.strands[index]);
  // Upright strands have a node on every plane up to their tip.
  const bool upright = nodes.size() <= kPlanes + 2 && nodes[nodes.size() - 2].height * kPlanes == static_cast<float>(nodes.size() - 2);
  std::size_t first = 0, end = nodes.size() - 1;
  if (upright) {
    first = std::min(static_cast<std::size_t>(low * kPlanes), end);
    end = std::min(static_cast<std::size_t>(high * kPlanes) + 1, end);
  }
  chain.clear();
  for (std::size_t i = first; i < end; ++i) {
    const Node& a = nodes[i];
    const Node& b = nodes[i + 1];
    if (std::max(a.height, b.height) <= low || std::min(a.height, b.height) >= high) {
      if (!chain.empty()) cutChain(index);
      continue;
    }
    if (chain.empty()) chain.push_back(pointBetween(a, b, glm::clamp(a.height, low, high)));
    chain.push_back(pointBetween(a, b, glm::clamp(b.height, low, high)));
    if (b.height <= low || b.height >= high) cutChain(index);
  }
  if (!chain.empty()) cutChain(index);
}

void LayerPainter::Scratch::write(LayerMaps& out) {
  const std::size_t texels = canvas.owners().size();
  out.coverage.resize(texels), out.dominance.resize(texels), out.variance.resize(texels);
  out.tangent.resize(texels * 3), out.offset.resize(texels * 2), out.strandId.resize(texels);
  const std::vector<std::uint32_t>& owner = canvas.owners();
  const int size = coat.parameters.size;
  const float extent = static_cast<float>(size);
  std::size_t texel = 0;
  for (int y = 0; y < size; ++y)
    for (int x = 0; x < size; ++x, ++texel) {
      out.coverage[texel] = unitByte(canvas.cover(texel));
      std::int8_t* tangent = &out.tangent[texel * 3];
      if (owner[texel] == 0) {
        out.dominance[texel] = 255, out.variance[texel] = 0, out.strandId[texel] = 0;
        out.offset[texel * 2] = out.offset[texel * 2 + 1] = 0;
        tangent[0] = tangent[1] = 0, tangent[2] = 127;
        continue;
      }
      const Cut& cut = cuts[owner[texel] - 1];
      const Strand& strand = coat.strands[cut.stroke.strand];
      out.strandId[texel] = static_cast<std::uint16_t>(cut.stroke.strand + 1);
      out.dominance[texel] = unitByte(strand.dominance);
      out.variance[texel] = unitByte(strand.variance);
      std::copy(cut.tangent, cut.tangent + 3, tangent);
      // By the short way to the axis, then along the strand.
      const Vec2 axis = strand.root + cut.shift;
      out.offset[texel * 2] = packOffset(torusDelta(axis.x, static_cast<float>(x) + 0.5f, extent) - cut.shift.x);
      out.offset[texel * 2 + 1] = packOffset(torusDelta(axis.y, static_cast<float>(y) + 0.5f, extent) - cut.shift.y);
    }
}

LayerPainter::LayerPainter(const Coat& coat) : scratch_(std::make_unique<Scratch>(coat)) {}
LayerPainter::~LayerPainter() = default;
LayerPainter::LayerPainter(LayerPainter&&) noexcept = default;

bool LayerPainter::step(int layer, int layers, LayerMaps& out) {
  Scratch& s = *scratch_;
  switch (s.stage++) {
    case 0: {
      const float h = layerHeight(layer, layers), half = 0.5f / static_cast<float>(layers);
      // The lowest layer shows the skin end too, so that the shortest strand is seen.
      const float low = layer == 0 ? 0.0f : h - half, high = std::min(h + half, 1.0f);
      s.cuts.clear();
      for (std::size_t i = 0; i < s.coat.strands.size(); ++i) s.cutStrand(static_cast<std::uint16_t>(i), low, high);
      return false;
    }
    case 1:
      s.canvas.clear();
      for (std::size_t i = 0; i < s.cuts.size(); ++i) s.canvas.draw(s.cuts[i].stroke, static_cast<std::uint32_t>(i + 1));
      return false;
    case 2:
      s.nearest.fill(s.canvas.owners().data());
      return false;
    default:
      s.write(out);
      s.stage = 0;
      return true;
  }
}

void LayerPainter::paint(int layer, int layers, LayerMaps& out) {
  while (!step(layer, layers, out)) {
  }
}

}  // namespace fur::furgen
