#include "furgen/Coat.h"

#include <algorithm>
#include <bit>
#include <cmath>

#include "core/Random.h"
#include "furgen/Occupancy.h"
#include "furgen/Strand.h"
#include "furgen/StrandPath.h"

namespace fur::furgen {

namespace {

constexpr float kStrandsPerTile = 1500.0f;  // m of Sheppard Eq. 4.1, for 256 x 256 texels
constexpr float kReferenceArea = 256.0f * 256.0f;
constexpr int kRedraws = 100;
constexpr float kMaxPhase = 7.0f;  // radians (Sheppard 3.3.3)
constexpr float kRadiusSpread = 0.25f;

// Share of the tile that the root discs of the densest coat would cover if every strand found a
// place, from the finest to the thickest strands.
constexpr float kFineCover = 0.34f;
constexpr float kThickCover = 0.64f;
// Equal discs placed at random jam at 0.547 of the plane. Hence a candidate gets finer, the more often
// it has been drawn in vain, down to this share of its radius: late strands fill the gaps.
constexpr float kLastRadius = 0.5f;

// And it curls less of its own after so many draws: in a dense coat the last strands stand straight.
constexpr float kCalmAfter = 20.0f;

constexpr float kUndercoatRadius = 0.55f;  // of a guard hair's
constexpr float kUndercoatCount = 1.5f;    // of the guard hairs', at undercoat 1
constexpr float kShortest = 1.0f / kPlanes;

float cleanUnit(float x, float fallback) { return std::isnan(x) ? fallback : saturate(x); }

float areaOf(const FurParameters& p) {
  return static_cast<float>(p.size) * static_cast<float>(p.size) / kReferenceArea;
}

// What can be told before the path is known: most candidates fail on the skin already.
void drawRoot(Random& random, const FurParameters& p, float radius, StrandDraws& draws) {
  // One draw a line: the order of evaluation inside an expression is the compiler's.
  const float size = static_cast<float>(p.size);
  draws.root.x = random.uniform() * size;
  draws.root.y = random.uniform() * size;
  draws.radius = radius * random.uniform(1.0f - kRadiusSpread, 1.0f + kRadiusSpread);
}

void drawRest(Random& random, const FurParameters& p, bool undercoat, StrandDraws& draws) {
  const float longest = p.length * (undercoat ? p.undercoatLength : 1.0f);
  draws.length = std::max(longest * (1.0f - p.lengthVariation * random.uniform()), kShortest);
  draws.dominance = random.uniform(0.5f, 1.0f);
  draws.variance = random.uniform();
  for (int curve = 0; curve < 2; ++curve)
    for (int axis = 0; axis < 2; ++axis) {
      draws.magnitude[curve][axis] = random.uniform(-1.0f, 1.0f);
      draws.phase[curve][axis] = kMaxPhase * random.uniform();
    }
  draws.bound = random.uniform();
  draws.tipOpening = random.uniform();
  draws.turnJitter = random.uniform(-1.0f, 1.0f);
  for (Vec2& phase : draws.frizzPhase) {
    phase.x = random.uniform(0.0f, 2.0f * kPi);
    phase.y = random.uniform(0.0f, 2.0f * kPi);
  }
}

}  // namespace

float meanRadius(float thickness) {
  // The radius at which the wanted strands of the densest coat cover the wanted share of the skin:
  // cover * area = count * pi * (radius * thinning(0))^2.
  const float cover = kFineCover + (kThickCover - kFineCover) * thickness;
  const float areaOfOne = kReferenceArea / (kStrandsPerTile * (1.0f - 0.7f * thickness));
  return std::sqrt(cover * areaOfOne / kPi) / strandThinning(0.0f);
}

int wantedStrands(const FurParameters& p) {
  if (p.density <= 0.0f) return 0;
  const float count = p.density * kStrandsPerTile * areaOf(p) * (1.0f - 0.7f * p.thickness);  // Sheppard Eq. 4.1
  return std::max(1, static_cast<int>(count + 0.5f));
}

int wantedUndercoat(const FurParameters& p) {
  return static_cast<int>(kUndercoatCount * p.undercoat * static_cast<float>(wantedStrands(p)) + 0.5f);
}

FurParameters clampedParameters(const FurParameters& given) {
  const FurParameters standard;
  FurParameters p = given;
  p.size = static_cast<int>(std::bit_floor(static_cast<unsigned>(std::clamp(given.size, 64, 1024))));
  p.layers = std::clamp(given.layers, 4, 128);
  for (float FurParameters::*field :
       {&FurParameters::density, &FurParameters::thickness, &FurParameters::taper, &FurParameters::lengthVariation,
        &FurParameters::length, &FurParameters::curl, &FurParameters::wave, &FurParameters::coil, &FurParameters::frizz,
        &FurParameters::clump, &FurParameters::lockSize, &FurParameters::roll, &FurParameters::stray,
        &FurParameters::tipBreak, &FurParameters::undercoat, &FurParameters::undercoatLength})
    p.*field = cleanUnit(given.*field, standard.*field);
  return p;
}

struct CoatGrower::State {
  explicit State(const FurParameters& given)
      : coat{clampedParameters(given), {}, {}, 0},
        guards(wantedStrands(coat.parameters)),
        total(guards + wantedUndercoat(coat.parameters)),
        radius(meanRadius(coat.parameters.thickness)),
        path(coat.parameters),
        occupancy(coat.parameters.size, radius * (1.0f + kRadiusSpread)) {
    coat.strands.reserve(static_cast<std::size_t>(total));
  }

  // Follows the strand up to its tip, or to where it touches another.
  bool growFree(const StrandDraws& draws, bool undercoat, float calm) {
    nodes.clear();
    StrandPath::Walk walk = path.start(draws, undercoat, calm);
    walk.next(nodes);
    for (std::size_t free = nodes.size(); walk.next(nodes); free = nodes.size())
      if (occupancy.collides(draws.root, std::span(nodes).subspan(free - 1))) return false;
    return true;
  }

  void tryFor(int index) {
    const FurParameters& p = coat.parameters;
    const bool undercoat = index >= guards;
    const float wanted = radius * (undercoat ? kUndercoatRadius : 1.0f);
    // Guard hairs and undercoat draw from streams of their own, so that neither slider moves the other.
    Random random(p.seed, undercoat ? (1u << 24) + static_cast<unsigned>(index - guards) : static_cast<unsigned>(index) + 1);
    StrandDraws draws;
    // When strand after strand finds no room the coat is full: fewer draws settle the rest.
    const int redraws = kRedraws / (1 + failures / 4);
    for (int attempt = 0; attempt <= redraws; ++attempt) {
      const float finer = 1.0f - (1.0f - kLastRadius) * static_cast<float>(attempt) / kRedraws;
      drawRoot(random, p, wanted * finer, draws);
      if (occupancy.collides(draws.root, draws.radius * strandThinning(0.0f))) continue;
      drawRest(random, p, undercoat, draws);
      if (!growFree(draws, undercoat, saturate((static_cast<float>(attempt) - kCalmAfter) / (kRedraws - kCalmAfter)))) continue;
      accept(draws);
      failures = 0;
      return;
    }
    ++failures;
  }

  void accept(const StrandDraws& draws) {
    occupancy.add(draws.root, nodes);
    float highest = 0;
    for (const Node& node : nodes) highest = std::max(highest, node.height);
    coat.strands.push_back({draws.root, highest, draws.dominance, draws.variance,
                            static_cast<std::uint32_t>(coat.nodes.size()), static_cast<std::uint32_t>(nodes.size())});
    coat.nodes.insert(coat.nodes.end(), nodes.begin(), nodes.end());
    volume += draws.radius * draws.radius * draws.length;
  }

  // A strand's volume goes with radius^2 * length; the densest straight coat is thickness 1, density 1.
  float weight() const {
    FurParameters densest = coat.parameters;
    densest.density = densest.thickness = 1.0f;
    const float full = meanRadius(1.0f);
    return saturate(volume / (static_cast<float>(wantedStrands(densest)) * full * full));
  }

  Coat coat;
  int guards, total, next = 0;
  int failures = 0;  // in a row
  float radius, volume = 0;
  StrandPath path;
  Occupancy occupancy;
  std::vector<Node> nodes;
};

CoatGrower::CoatGrower(const FurParameters& parameters) : state_(std::make_unique<State>(parameters)) {}
CoatGrower::~CoatGrower() = default;
CoatGrower::CoatGrower(CoatGrower&&) noexcept = default;
CoatGrower& CoatGrower::operator=(CoatGrower&&) noexcept = default;

bool CoatGrower::step(int strands) {
  State& s = *state_;
  for (int k = 0; k < strands && s.next < s.total; ++k) s.tryFor(s.next++);
  return s.next >= s.total;
}

float CoatGrower::progress() const {
  return state_->total == 0 ? 1.0f : static_cast<float>(state_->next) / static_cast<float>(state_->total);
}

Coat CoatGrower::take() {
  state_->coat.weight = state_->weight();
  return std::move(state_->coat);
}

Coat growCoat(const FurParameters& parameters) {
  CoatGrower grower(parameters);
  while (!grower.step(1 << 20)) {
  }
  return grower.take();
}

}  // namespace fur::furgen
