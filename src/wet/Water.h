// Water in time: it dries, soaks into the fur, spreads along the combed strands, runs down what is soaked, gathers
// below, drips, falls, and wets what it falls on. Rain, pouring, wiping, blowing and shaking are ways in and out.
//
// What is wet is the mask's (WetnessMask.h: wetness that fur holds, and the film on it); this follows it, and what is
// painted meanwhile counts as painted. A place of area A holds A times its wetness, and its film A times that: the
// unit of all amounts here is what soaks one square model unit of fur. No amount is lost (Accounts).
//
// Fixed steps; + - * / and square roots alone decide: the same calls give the same bits on every platform. Nothing is
// done where nothing is wet. Vectors are in world space unless they say model space; their unit is the model's radius.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "core/Bytes.h"
#include "core/Math.h"
#include "core/Random.h"
#include "wet/ClumpSites.h"
#include "wet/Drop.h"
#include "wet/Puddles.h"
#include "wet/SurfaceTexels.h"
#include "wet/SurfaceWetting.h"
#include "wet/WetnessMask.h"

namespace fur::wet {

// What the water is on; the same for all calls between two of reset().
struct WetSurface {
  const geometry::Surface& surface;
  const geometry::SurfaceQuery& query;
  const SurfaceWetting& wetting;
  // Of a model that is posed: where its vertices are shown, and what finds a way to them. None: as the surface was made.
  std::span<const Vec3> positions{}, normals{};
  const geometry::SurfaceQuery* shown = nullptr;
};

struct Climate {
  Mat4 worldFromModel{1.0f};  // rigid
  Vec3 wind{0};               // model radii a second
  float dryRate = 0.02f;      // per second, see Drying.h
  float furLength = 0.12f;
  float clumpSize = 0.05f;    // radius of the clumps that form by themselves
  float groundHeight = -1;
  float rain = 0;             // 0..1
  float shaking = 0;          // 0..1: how hard the model throws its water off
  // A hair dryer: what lies within the radius dries by `blow` wetness a second more, less towards its rim. Model space.
  Vec3 blowCentre{0};
  float blowRadius = 0, blow = 0;
};

// painted + rained = held + film + drops + dripped + evaporated + removed.
struct Accounts {
  double painted = 0, rained = 0;                // came in; undo takes back by painting less
  double held = 0, film = 0, drops = 0;          // in the fur, on it, in the air or hanging
  double dripped = 0, evaporated = 0, removed = 0;  // fell to the ground or away; wiped off
};

class Water {
 public:
  static constexpr float kStep = 1.0f / 60.0f;
  // Blocks run by turns, a half of them in each step: water in fur is slow. All dry in every fourth, which looks
  // continuous, and between which nothing has changed where water only dries: kDryingTurns.
  static constexpr std::uint32_t kTurns = 2;
  static constexpr std::size_t kMostDrops = 1024;

  // Forgets everything: another model or mask.
  void reset() {
    const std::uint32_t revision = groundRevision_ + 1;
    *this = Water();
    groundRevision_ = revision;
  }
  // Finds the ways of the water, once a model: `places` of them at most. True when all are there; before that
  // step() and the tools do nothing.
  bool prepare(const WetSurface& skin, std::uint32_t places = 0xffffffffu);
  bool ready() const { return ready_; }
  // All that is here beside the mask: for one that is not prepared yet, on the same model, with the same mask.
  void save(ByteWriter& to) const;
  void restore(ByteReader& from);

  // How the fur lies, one a vertex of the surface: along the skin, 0 (upright) to 1 long. Model space.
  void setLay(std::vector<Vec3> lay);
  // Advances by kStep seconds. Whether anything that can be seen has changed.
  bool step(const WetSurface& skin, WetnessMask& mask, const Climate& climate);
  // Whether time alone changes anything.
  bool active(const WetnessMask& mask, const Climate& climate) const;

  // Lays water on the skin round a point (model space), as `painted`.
  void pour(const WetSurface& skin, WetnessMask& mask, const Vec3& centre, const Vec3& normal, float radius, float amount);
  // How fast a drop has to set out that is to come so far in so many seconds, against gravity, wind and air.
  static Vec3 velocityFor(const Vec3& way, float seconds, const Vec3& wind);
  // A drop on its way, as `painted`; more than kMostDrops are not taken. Those with a `jet` of kJet, one each step, are a jet.
  static constexpr float kJet = 2.3f;
  void launch(const Vec3& position, const Vec3& velocity, float amount, float jet = 0);
  // Takes the film and `share` of wetness off all within the radius (model space).
  void wipe(const WetSurface& skin, WetnessMask& mask, const Vec3& centre, const Vec3& normal, float radius, float share);
  // All that is on its way, and the ground; the mask is its owner's to clear.
  void clear();

  std::span<const Drop> drops() const { return drops_; }
  // Amount of water on a square unit of each cell (Puddles.h); another revision whenever any has changed.
  std::span<const float> ground() const { return puddles_; }
  std::uint32_t groundRevision() const { return groundRevision_; }
  Accounts accounts() const;
  // FNV-1a over drops, ground and what the mask knows.
  std::uint64_t hash(const WetnessMask& mask) const;
  const SurfaceTexels* texels() const { return texels_.get(); }

 private:
  // Below this fur is dry, nothing flows, and a change in a turn is not worth following.
  static constexpr float kLeast = 1.0f / 1024;
  static constexpr float kCling = 0.06f;  // film that no place lets go of
  static constexpr std::uint32_t kDryingTurns = 4, kSlowestTurns = 60;  // steps
  // Steps between two losses to the air of what is at rest: where it dries slowly as many as it takes to see one, so that
  // a picture of fur that dries for minutes is not drawn all the time.
  static std::uint32_t dryingTurns(const Climate& climate);
  enum : std::uint8_t { kWet = 1, kMoving = 2, kReceived = 4, kFlows = 8 };

  // Of the places of a block.
  static constexpr std::size_t kPlaces = SurfaceTexels::kBlock * SurfaceTexels::kBlock;  // at most
  struct Amounts {
    float held[kPlaces], film[kPlaces];
  };

  void notice(const WetSurface& skin, WetnessMask& mask);
  void aim(const WetSurface& skin, std::uint32_t block);
  void flow(std::uint32_t block);
  void crossBorders(std::uint32_t block);
  void receive(const WetSurface& skin, WetnessMask& mask, const Climate* climate, std::uint32_t block);
  void evaporate(const WetSurface& skin, WetnessMask& mask, const Climate& climate, std::uint32_t block);
  void store(const WetSurface& skin, WetnessMask& mask, std::uint32_t place, float held, float film);
  static void carryOn(WetnessMask& mask, std::uint32_t mirror, const Vec4& texel, float film);
  bool soak(std::uint32_t block, Amounts& now);
  bool dry(const Climate& climate, std::uint32_t block, Amounts& now);
  float rest(std::uint32_t block, const Amounts& now, bool moves);
  bool storeBlock(const WetSurface& skin, WetnessMask& mask, std::uint32_t block, const Amounts& now);
  void touch(WetnessMask& mask);
  void give(std::uint32_t place, float amount);
  void feedHanging(const WetSurface& skin, WetnessMask& mask, const Climate& climate);
  void fall(const WetSurface& skin, const Climate& climate);
  void rain(const Climate& climate);
  void shake(const WetSurface& skin, WetnessMask& mask, const Climate& climate);
  void spray(const Vec3& at, const Vec3& normal, float speed);
  void splash(const Vec3& centre, const Vec3& normal, float radius, float amount, std::uint32_t nearest);
  float wetGround(const Vec3& at, float amount);
  void seepGround(float dries);

  std::unique_ptr<SurfaceTexels> texels_;
  ClumpSites sites_;
  bool ready_ = false;
  // One a place.
  std::vector<float> held_, film_, incoming_;
  // How water leaves a place in a turn: the share of what runs by the two links that its way lies between, and of a difference
  // in wetness to the four along u and v. A link that leads nowhere leads to the place itself.
  struct Ways {
    std::array<std::uint32_t, 2> down{};
    std::array<float, 2> runs{};
    std::array<std::uint32_t, 4> beside{};
    std::array<float, 4> wicks{};
    std::array<std::uint8_t, 2> sides{};  // that `down` is by
  };
  std::vector<Ways> ways_;
  std::vector<float> areas_;
  std::vector<std::uint32_t> texelOf_;
  std::vector<std::uint8_t> hasDrop_;
  // One a block.
  std::vector<std::uint8_t> flags_, stored_;
  std::vector<std::uint32_t> dried_;  // the step in which it has last dried
  std::vector<std::uint32_t> aimed_;  // the number of the gravity and lay that its ways are for
  std::uint32_t aim_ = 0;
  Vec3 down_{0, -1, 0};  // model space
  std::vector<Vec3> lay_;
  float clumpSize_ = Climate{}.clumpSize;  // as the last step had it

  std::vector<Drop> drops_;
  std::size_t hanging_ = 0;
  std::vector<float> puddles_;
  std::uint32_t groundRevision_ = 0;
  bool groundWet_ = false, groundMoves_ = false;
  Random random_{11};
  float rainDue_ = 0;
  std::uint32_t steps_ = 0, seen_ = 0xffffffffu;
  bool changed_ = false;
  Accounts accounts_;  // but held, film and drops
};

}  // namespace fur::wet
