#include "geometry/HardEdges.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <queue>
#include <utility>

#include "core/Numbering.h"
#include "core/PortableMath.h"
#include "core/Sort.h"
#include "geometry/Adjacency.h"
#include "geometry/Weld.h"

namespace fur::geometry {

namespace {

// From this angle between the normals of its two faces on, 12 degrees, an edge is hard.
constexpr float kHardCosine = 0.978f;
// Normals that turn by more than 50 degrees along a side twice as long as the reach turn too far. It is then halved until
// it is shorter than two of the least steps, or they turn by less than 25, as sides are where fur leans.
constexpr float kFarCosine = 0.643f, kTurnCosine = 0.906f;
constexpr float kLeastStep = 0.3f * kEdgeReach;
// Fur on the rim of a sheet leans out as far as the sheet lies: its coat is closed down to the skin.
constexpr double kLeastSheet = 16.0 * kEdgeReach * kEdgeReach;  // smaller ones are parts of something: scales, feathers, facets
constexpr int kMostRounds = 10;  // of each rule: a side is halved a thousandfold by then
constexpr int kSweeps = 40;      // of relaxing: changes are below a degree after half of them

struct Side {
  std::uint32_t low, high;    // welded
  std::size_t first, count;   // in the sorted sides
  bool hard, rim;
};

class Rounding {
 public:
  explicit Rounding(const Mesh& mesh) : given_(mesh.normals) {
    out_.mesh.positions = mesh.positions;
    out_.mesh.normals = mesh.normals;
    if (mesh.uv.size() == mesh.positions.size()) out_.mesh.uv = mesh.uv;
    if (mesh.otherUv.size() == mesh.positions.size()) out_.mesh.otherUv = mesh.otherUv;
    out_.mesh.indices = mesh.indices;
    for (std::uint32_t t = 0; t < mesh.triangleCount(); ++t) {
      out_.triangleOf.push_back(t);
      for (int k = 0; k < 3; ++k) out_.weights.push_back({k == 0, k == 1, k == 2});
    }
  }

  RoundedMesh run() {
    look();
    findRims();
    if (std::find(rim_.begin(), rim_.end(), true) != rim_.end()) look();
    const auto repeat = [this](auto rule) {
      for (int round = 0; round < kMostRounds && cut(rule); ++round) look();
    };
    // Faces between hard edges get a middle; then they are cut where leaning begins; then where normals turn too far.
    if (anyHard_) {
      repeat([this](const Side& side) { return middleOf(side); });
      repeat([this](const Side& side) { return side.hard ? cornerOf(side) : reachOf(side); });
    }
    share();
    relax();
    for (int round = 0; round < kMostRounds && cut([this](const Side& side) { return turnOf(side); }); ++round) {
      look();
      relax();
    }
    out_.given = std::move(given_);
    return std::move(out_);
  }

 private:
  const std::vector<std::uint32_t>& indices() const { return out_.mesh.indices; }
  const Vec3& position(std::uint32_t vertex) const { return out_.mesh.positions[vertex]; }
  std::uint32_t corner(const TriangleSide& s, std::size_t k) const { return indices()[3 * s.triangle + (s.side + k) % 3]; }
  // The vertices of a triangle's side at its low and its high end.
  std::uint32_t atLow(const TriangleSide& s) const { return corner(s, s.forwards ? 0 : 1); }
  std::uint32_t atHigh(const TriangleSide& s) const { return corner(s, s.forwards ? 1 : 0); }
  std::uint32_t atLow(const Side& s) const { return atLow(sorted_[s.first]); }
  std::uint32_t atHigh(const Side& s) const { return atHigh(sorted_[s.first]); }
  float lengthOf(const Side& s) const { return glm::length(position(atHigh(s)) - position(atLow(s))); }

  // Sides, which of them are hard, and fans: corners that share their normal, as triangles lie side by side there.
  void look() {
    weld_ = weldPositions(out_.mesh.positions);
    sorted_ = sortedSides(indices(), weld_);
    across_ = neighboursAcrossSides(sorted_, indices().size() / 3);
    sides_.clear();
    for (std::size_t i = 0, end = 0; i < sorted_.size(); i = end) {
      Side side{sorted_[i].low, sorted_[i].high, i, 0, false, false};
      for (end = i; end < sorted_.size() && sorted_[end].low == side.low && sorted_[end].high == side.high; ++end)
        side.hard = side.hard || glm::dot(given_[atLow(sorted_[end])], given_[atLow(side)]) < kHardCosine ||
                    glm::dot(given_[atHigh(sorted_[end])], given_[atHigh(side)]) < kHardCosine;
      side.count = end - i;
      side.rim = side.count == 1 && !rim_.empty() && rim_[atLow(side)] && rim_[atHigh(side)];
      side.hard = side.hard || side.rim;
      sides_.push_back(side);
    }
    findHardEnds();
  }

  // The rims of sheets: loops of sides with one triangle, along which the surface ends as round a disc. Round the hole of
  // a body it ends the other way round, and fur would lean over what looks out there, such as an eye.
  void findRims() {
    rim_.assign(given_.size(), false);
    std::vector<std::uint32_t> loop(weld_.count);
    for (std::uint32_t point = 0; point < weld_.count; ++point) loop[point] = point;
    const auto rootOf = [&loop](std::uint32_t point) {
      while (loop[point] != point) point = loop[point] = loop[loop[point]];
      return point;
    };
    std::vector<float> turns(weld_.count, 0.0f);  // of a loop, at its root; until then of its points
    for (const Side& side : sides_)
      if (side.count == 1) loop[rootOf(side.low)] = rootOf(side.high), turns[side.low] = turns[side.high] = kPi;
    for (std::size_t i = 0; i < indices().size(); ++i)
      if (float& turn = turns[weld_.idOf[indices()[i]]]; turn != 0.0f) turn -= angleAt(i);
    std::vector<float> sums(weld_.count, 0.0f);
    for (std::uint32_t point = 0; point < weld_.count; ++point) sums[rootOf(point)] += turns[point];
    const std::vector<double> areas = areasOfPieces();
    for (std::size_t i = 0; i < indices().size(); ++i)
      rim_[indices()[i]] = sums[rootOf(weld_.idOf[indices()[i]])] > kPi && areas[i / 3] > kLeastSheet;
  }

  // Of the piece that each triangle is part of.
  std::vector<double> areasOfPieces() const {
    std::uint32_t count = 0;
    std::vector<std::uint32_t> pieceOf = connectedPieces(across_, [](auto...) { return true; }, count);
    std::vector<double> areas(count, 0.0), out;
    for (std::size_t t = 0; t < pieceOf.size(); ++t) {
      const Vec3& a = position(indices()[3 * t]);
      areas[pieceOf[t]] += 0.5 * glm::length(glm::cross(position(indices()[3 * t + 1]) - a, position(indices()[3 * t + 2]) - a));
    }
    for (const std::uint32_t piece : pieceOf) out.push_back(areas[piece]);
    return out;
  }

  float angleAt(std::size_t corner) const {
    const Vec3& at = position(indices()[corner]);
    const Vec3 e1 = normalizeOr(position(indices()[corner / 3 * 3 + (corner + 1) % 3]) - at, Vec3(0));
    const Vec3 e2 = normalizeOr(position(indices()[corner / 3 * 3 + (corner + 2) % 3]) - at, Vec3(0));
    return 2.0f * portableAtan(glm::length(e1 - e2) / std::max(glm::length(e1 + e2), 1e-6f));
  }

  // Fur on rims, which keeps that way.
  void leanOut() {
    outwards_.assign(parent_.size(), Vec3(0));
    for (const Side& side : sides_) {
      if (!side.rim) continue;
      const TriangleSide& s = sorted_[side.first];
      const Vec3 &a = position(corner(s, 0)), &b = position(corner(s, 1)), &c = position(corner(s, 2));
      const Vec3 out = normalizeOr(glm::cross(b - a, glm::cross(b - a, c - a)), Vec3(0));
      for (const std::uint32_t v : {corner(s, 0), corner(s, 1)}) outwards_[parent_[v]] += out;
    }
    for (std::uint32_t fan = 0; fan < parent_.size(); ++fan) {
      if (outwards_[fan] == Vec3(0)) continue;
      const Vec3& n = given_[fan];
      out_.mesh.normals[fan] = normalizeOr(outwards_[fan] - n * glm::dot(n, outwards_[fan]), n);
      out_.changed = out_.sheets = true;
    }
  }

  void findHardEnds() {
    std::vector<std::uint32_t> counts(weld_.count + 1, 0);
    for (const Side& side : sides_)
      if (side.hard) ++counts[side.low + 1], ++counts[side.high + 1];
    for (std::size_t i = 1; i < counts.size(); ++i) counts[i] += counts[i - 1];
    firstWay_ = counts;
    ways_.resize(counts.back());
    for (const Side& side : sides_) {
      if (!side.hard) continue;
      const Vec3 way = normalizeOr(position(atHigh(side)) - position(atLow(side)), Vec3(0));
      ways_[counts[side.low]++] = way;
      ways_[counts[side.high]++] = -way;
    }
    anyHard_ = !ways_.empty();
  }
  bool onHard(std::uint32_t point) const { return firstWay_[point] < firstWay_[point + 1]; }

  // --- where a side is cut: its share from the low end on, 0: nowhere -------------------------------

  float middleOf(const Side& side) const {
    return !side.hard && onHard(side.low) && onHard(side.high) && lengthOf(side) > kEdgeReach ? 0.5f : 0.0f;
  }

  // How fast one comes away from the hard edges that end at a point, going along `way`.
  float leaving(std::uint32_t point, const Vec3& way) const {
    float least = 1.0f;
    for (std::uint32_t i = firstWay_[point]; i < firstWay_[point + 1]; ++i) {
      const float along = glm::dot(ways_[i], way);
      if (along > 0.0f) least = std::min(least, std::sqrt(std::max(0.0f, 1.0f - along * along)));
    }
    return least;
  }

  float reachOf(const Side& side) const {
    const bool low = onHard(side.low);
    if (low == onHard(side.high)) return 0.0f;
    const Vec3 way = position(atHigh(side)) - position(atLow(side));
    const float length = glm::length(way);
    const float distance = length * leaving(low ? side.low : side.high, way * ((low ? 1.0f : -1.0f) / length));
    if (!(distance > 1.1f * kEdgeReach)) return 0.0f;
    return low ? kEdgeReach / distance : 1.0f - kEdgeReach / distance;
  }

  // A hard edge ends at a corner where another one leaves in another direction.
  bool turnsAt(std::uint32_t point) const {
    const std::uint32_t count = firstWay_[point + 1] - firstWay_[point];
    if (count != 2) return count > 2;
    return glm::dot(ways_[firstWay_[point]], ways_[firstWay_[point] + 1]) > -kTurnCosine;
  }

  float cornerOf(const Side& side) const {
    const Vec3 way = position(atHigh(side)) - position(atLow(side));
    const float length = glm::length(way);
    const bool low = turnsAt(side.low), high = turnsAt(side.high);
    if (length <= 1.1f * kEdgeReach || (!low && !high)) return 0.0f;
    if (low && high && length <= 2.2f * kEdgeReach) return 0.5f;
    return low ? kEdgeReach / length : 1.0f - kEdgeReach / length;
  }

  float turnOf(const Side& side) const {
    const float length = lengthOf(side);
    const auto turns = [this, length](const TriangleSide& s) {
      const std::uint32_t a = atLow(s), b = atHigh(s);
      const bool fine = isOurs(a) || isOurs(b);
      if (length <= 2.0f * (fine ? kLeastStep : kEdgeReach)) return false;
      return glm::dot(out_.mesh.normals[a], out_.mesh.normals[b]) < (fine ? kTurnCosine : kFarCosine);
    };
    return std::any_of(sorted_.begin() + static_cast<std::ptrdiff_t>(side.first),
                       sorted_.begin() + static_cast<std::ptrdiff_t>(side.first + side.count), turns) ? 0.5f : 0.0f;
  }

  // Was inserted, or leans.
  bool isOurs(std::uint32_t v) const {
    return out_.mesh.positions.size() - v <= out_.inserted.size() || out_.mesh.normals[v] != given_[v];
  }

  // --- cutting ------------------------------------------------------------------------------------

  // Cuts sides where `rule` says; whether any was. All triangles at a side are cut at the same place.
  template <class Rule>
  bool cut(Rule rule) {
    std::vector<float> at(sorted_.size(), 0.0f);  // one a side of a triangle: from its own first corner on
    std::size_t cuts = 0;
    for (const Side& side : sides_) {
      const float t = rule(side);
      if (!(t > 0.0f) || out_.inserted.size() + 2 * ++cuts > kMostInserted) continue;
      for (std::size_t i = side.first; i < side.first + side.count; ++i) at[3 * sorted_[i].triangle + sorted_[i].side] = t;
    }
    if (cuts == 0) return false;
    const std::size_t before = out_.triangleOf.size();
    cutTriangles(at);
    return out_.triangleOf.size() > before;
  }

  struct Corner {
    std::uint32_t vertex;
    Vec3 weights;
  };

  void cutTriangles(const std::vector<float>& at) {
    const std::vector<std::uint32_t> indices = std::exchange(out_.mesh.indices, {});
    const std::vector<std::uint32_t> triangleOf = std::exchange(out_.triangleOf, {});
    const std::vector<Vec3> weights = std::exchange(out_.weights, {});
    Numbering pairs;
    const auto firstNew = static_cast<std::uint32_t>(out_.mesh.positions.size());
    for (std::size_t t = 0; t < triangleOf.size(); ++t) {
      Corner c[6];  // corners, and where the sides after them are cut
      int cuts = 0, start = 0;
      for (int k = 0; k < 3; ++k) {
        const std::size_t i = 3 * t + static_cast<std::size_t>(k), j = 3 * t + static_cast<std::size_t>(k + 1) % 3;
        c[k] = {indices[i], weights[i]};
        if (at[i] == 0.0f) continue;
        ++cuts;
        const bool swap = weld_.idOf[indices[i]] > weld_.idOf[indices[j]];
        const std::size_t a = swap ? j : i, b = swap ? i : j;
        c[3 + k] = {firstNew + pairs.of(std::uint64_t{indices[a]} << 32 | indices[b]), weights[a] + (weights[b] - weights[a]) * at[i]};
        if (c[3 + k].vertex == out_.mesh.positions.size()) insert({indices[a], indices[b], at[i]});
      }
      // Turned so that of two sides that are cut, or not, the lone one is the first.
      while (cuts % 3 != 0 && (at[3 * t + static_cast<std::size_t>(start)] > 0.0f) != (cuts == 1)) ++start;
      const auto turned = [&](int k) -> const Corner& { return c[k / 3 * 3 + (k + start) % 3]; };
      emit(triangleOf[t], turned, cuts);
    }
  }

  template <class Turned>
  void emit(std::uint32_t of, Turned c, int cuts) {
    const auto add = [&](int i, int j, int k) {
      out_.triangleOf.push_back(of);
      for (const int n : {i, j, k}) {
        out_.mesh.indices.push_back(c(n).vertex);
        out_.weights.push_back(c(n).weights);
      }
    };
    const auto apart = [&](int i, int j) { return glm::distance(position(c(i).vertex), position(c(j).vertex)); };
    if (cuts == 0) add(0, 1, 2);
    else if (cuts == 1) add(0, 3, 2), add(3, 1, 2);
    else if (cuts == 3) add(0, 3, 5), add(3, 1, 4), add(5, 4, 2), add(3, 4, 5);
    else if (add(4, 2, 5); apart(0, 4) <= apart(1, 5)) add(0, 1, 4), add(0, 4, 5);
    else add(0, 1, 5), add(1, 4, 5);
  }

  void insert(const InsertedVertex& v) {
    out_.inserted.push_back(v);
    out_.mesh.positions.push_back(v.of(out_.mesh.positions));
    for (auto* uv : {&out_.mesh.uv, &out_.mesh.otherUv})
      if (!uv->empty()) uv->push_back(v.of(*uv));
    given_.push_back(normalizeOr(v.of(given_), given_[v.a]));
    rim_.push_back(rim_[v.a] && rim_[v.b]);
    // Halfway a turn is a half whatever it is.
    out_.mesh.normals.push_back(normalizeOr(v.of(out_.mesh.normals), given_.back()));
    out_.changed = true;
  }

  // --- normals ------------------------------------------------------------------------------------

  // Numbers the fans: corners of one position, of triangles that lie side by side there or share the vertex.
  void findFans() {
    parent_.resize(out_.mesh.positions.size());
    for (std::uint32_t v = 0; v < parent_.size(); ++v) parent_[v] = v;
    for (const TriangleSide& s : sorted_) {
      const std::uint32_t other = across_[3 * s.triangle + s.side];
      if (other == kNoTriangle) continue;
      for (std::size_t k = 0; k < 3; ++k)
        for (const std::uint32_t mine : {corner(s, 0), corner(s, 1)})
          if (const std::uint32_t theirs = indices()[3 * other + k]; weld_.idOf[theirs] == weld_.idOf[mine])
            parent_[rootOf(theirs)] = rootOf(mine);
    }
    for (std::uint32_t v = 0; v < parent_.size(); ++v) parent_[v] = rootOf(v);
  }
  std::uint32_t rootOf(std::uint32_t v) {
    while (parent_[v] != v) v = parent_[v] = parent_[parent_[v]];
    return v;
  }

  // One normal a fan where there are several: their mean, by the angles of the corners.
  void share() {
    findFans();
    std::vector<Vec3> sums(parent_.size(), Vec3(0)), inwards(parent_.size(), Vec3(0));
    std::vector<std::uint8_t> several(parent_.size());
    for (std::size_t i = 0; i < indices().size(); ++i) {
      const std::uint32_t v = indices()[i], fan = parent_[v];
      const float angle = angleAt(i);
      const Vec3 e1 = normalizeOr(position(indices()[i / 3 * 3 + (i + 1) % 3]) - position(v), Vec3(0));
      const Vec3 e2 = normalizeOr(position(indices()[i / 3 * 3 + (i + 2) % 3]) - position(v), Vec3(0));
      sums[fan] += given_[v] * angle;
      inwards[fan] += normalizeOr(e1 + e2, Vec3(0)) * angle;
      several[fan] = several[fan] || given_[v] != given_[fan];
    }
    for (std::uint32_t v = 0; v < parent_.size(); ++v) {
      if (!several[parent_[v]]) continue;
      // At the rim of something without thickness the normals of both sides add up to nothing.
      const Vec3& sum = sums[parent_[v]];
      const bool nothing = glm::dot(sum, sum) < 1e-4f;
      out_.mesh.normals[v] = normalizeOr(nothing ? -inwards[parent_[v]] : sum, given_[v]);
      out_.changed = true;
    }
  }

  struct Link {
    std::uint32_t from, to;  // fans
    float length;
  };

  // Where fur leans, normals are those that turn as evenly as they can, between those of the faces beyond.
  void relax() {
    if (!anyHard_) return;
    findFans();
    leanOut();
    std::vector<Link> links;
    for (const TriangleSide& s : sorted_) {
      const std::uint32_t a = parent_[corner(s, 0)], b = parent_[corner(s, 1)];
      const float length = std::max(glm::distance(position(a), position(b)), 1e-6f);
      links.push_back({a, b, length});
      links.push_back({b, a, length});
    }
    sortStably(links.begin(), links.end(), [](const Link& x, const Link& y) { return x.from != y.from ? x.from < y.from : x.to < y.to; });
    std::vector<std::size_t> first(parent_.size() + 1, 0);
    for (const Link& link : links) ++first[link.from + 1];
    for (std::size_t i = 1; i < first.size(); ++i) first[i] += first[i - 1];
    const auto reached = [](float distance) { return distance < 0.99f * kEdgeReach; };
    const std::vector<float> fromHard = distances(links, first, kEdgeReach, [this](std::uint32_t v) { return onHard(weld_.idOf[v]); });
    // A rod has no faces beyond: there corners keep their means, as neighbours on either side would cancel each other out.
    const std::vector<float> fromFaces = distances(links, first, 2.0f * kEdgeReach, [&](std::uint32_t v) { return !reached(fromHard[v]); });
    // Away from corners no end of an edge has a say in how fur leans over it.
    const std::vector<float> fromCorners = distances(links, first, kEdgeReach, [this](std::uint32_t v) { return turnsAt(weld_.idOf[v]); });
    std::vector<Vec3>& normals = out_.mesh.normals;
    for (int sweep = 0; sweep < kSweeps; ++sweep)
      for (std::uint32_t fan = 0; fan < parent_.size(); ++fan) {
        if (parent_[fan] != fan || outwards_[fan] != Vec3(0) || !reached(fromHard[fan]) || fromFaces[fan] > 2.0f * kEdgeReach) continue;
        Vec3 sum(0);
        for (std::size_t i = first[fan]; i < first[fan + 1]; ++i) sum += normals[links[i].to] / links[i].length;
        if (const std::uint32_t point = weld_.idOf[fan]; onHard(point) && !reached(fromCorners[fan]))
          sum -= ways_[firstWay_[point]] * glm::dot(sum, ways_[firstWay_[point]]);
        normals[fan] = normalizeOr(sum, normals[fan]);
      }
    for (std::uint32_t v = 0; v < parent_.size(); ++v)
      if (reached(fromHard[parent_[v]])) normals[v] = normals[parent_[v]];
  }

  // From certain fans along edges (Dijkstra), up to `most`.
  template <class At>
  std::vector<float> distances(const std::vector<Link>& links, const std::vector<std::size_t>& first, float most, At starts) const {
    std::vector<float> distance(parent_.size(), 1e9f);
    using Entry = std::pair<float, std::uint32_t>;
    std::priority_queue<Entry, std::vector<Entry>, std::greater<>> front;
    for (std::uint32_t v = 0; v < parent_.size(); ++v)
      if (parent_[v] == v && starts(v)) front.emplace(distance[v] = 0, v);
    while (!front.empty() && front.top().first < most) {
      const auto [d, from] = front.top();
      front.pop();
      if (d > distance[from]) continue;
      for (std::size_t i = first[from]; i < first[from + 1]; ++i)
        if (const float next = d + links[i].length; next < distance[links[i].to])
          front.emplace(distance[links[i].to] = next, links[i].to);
    }
    return distance;
  }

  RoundedMesh out_;
  std::vector<Vec3> given_;  // one a vertex: of its face
  std::vector<std::uint8_t> rim_;    // one a vertex: on a side that ends a sheet, if that has one triangle
  std::vector<Vec3> outwards_;
  Weld weld_;
  std::vector<TriangleSide> sorted_;
  std::vector<std::uint32_t> across_, firstWay_, parent_;
  std::vector<Vec3> ways_;  // along hard edges, from the points where they end
  std::vector<Side> sides_;
  bool anyHard_ = false;
};

}  // namespace

RoundedMesh roundHardEdges(const Mesh& mesh) {
  RoundedMesh rounded = Rounding(mesh).run();
  if (!rounded.changed) return {};
  return rounded;
}

}  // namespace fur::geometry
