// The simulation of water: it dries, soaks into the fur, spreads along combed strands, runs down soaked fur, gathers below,
// drips, falls, and wets what it falls on. Rain, pouring, wiping, a dryer and shaking add and remove water.
//
// The mask (WetnessMask.h) holds the state: the wetness of the fur and the film on it. Changes that others make to the mask
// count as painted. A place of area A with a wetness and a film has A * wetness + A * film of water: amounts are in units of
// what soaks one square model unit of fur. Water is conserved (Accounts).
//
// Steps are fixed, and only + - * / and square roots are used: the same calls give the same bits on every platform. Dry
// places cost nothing. Vectors are in world space unless they say model space; the unit is the model's radius.
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
#include "wet/WetHair.h"
#include "wet/WetnessMask.h"

namespace fur::wet {

// The model; the same for all calls until reset().
struct WetSurface {
  const geometry::Surface& surface;
  const geometry::SurfaceQuery& query;
  const SurfaceWetting& wetting;
  // For an animated model: the current positions and normals of its vertices, and a query over them. Empty: the rest pose.
  std::span<const Vec3> positions{}, normals{};
  const geometry::SurfaceQuery* shown = nullptr;
  WetHair* hair = nullptr;  // that grows on it; none
  // Where it moves by itself, its vertices' positions `seconds` ago: while it shakes, water flies off as they move. Else empty.
  std::span<const Vec3> before{};
  float seconds = 0;
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
  // A hair dryer: adds `blow` to dryRate at its centre, falling to 0 at its radius or before, unevenly. Model space.
  Vec3 blowCentre{0};
  float blowRadius = 0, blow = 0;
};

// painted + rained = held + film + drops + hair + dripped + evaporated + removed.
struct Accounts {
  double painted = 0, rained = 0;                // water that was added; undo reduces `painted`
  double held = 0, film = 0, drops = 0;          // in the fur, on it, in the air or hanging from it
  double hair = 0;                               // in long hair, and hanging from it
  double dripped = 0, evaporated = 0, removed = 0;  // lost to the ground, to the air, and wiped off
};

class Water {
 public:
  static constexpr float kStep = 1.0f / 60.0f;
  // Each step simulates every kTurns-th block, as water in fur is slow. Blocks dry every kDryingTurns steps.
  static constexpr std::uint32_t kTurns = 2;
  static constexpr std::size_t kMostDrops = 1024;

  // For another model or mask.
  void reset() {
    const std::uint32_t revision = groundRevision_ + 1;
    *this = Water();
    groundRevision_ = revision;
  }
  // Finds how places are connected, once for each model, at most `places` of them in one call. True when done; until then step()
  // and the tools do nothing.
  // `clumpSize`: of the climate to come.
  bool prepare(const WetSurface& skin, std::uint32_t places = 0xffffffffu, float clumpSize = Climate{}.clumpSize);
  bool ready() const { return ready_; }
  // Other parts of the skin take water from now on: prepare() begins anew, and what the mask holds stays where it may.
  void forgetPlaces();
  // More than there ever is in one place, or than a drop has of anything.
  static constexpr float kMostAmount = 1e5f;
  // All state but the mask. Restore into a Water that is not prepared yet, for the same model and mask. The reader fails where
  // numbers are not finite or out of bounds.
  void save(ByteWriter& to) const;
  void restore(ByteReader& from);

  // The direction in which fur lies, one for each vertex: a vector along the skin, 0 (upright) to 1 long. Model space.
  void setLay(std::vector<Vec3> lay);
  // How long fur is at most round each vertex, as a share of Climate::furLength; empty: all of it everywhere.
  void setLengths(std::vector<float> lengths) { lengths_ = std::move(lengths); }
  // Advances by kStep seconds; true when anything visible has changed.
  bool step(const WetSurface& skin, WetnessMask& mask, const Climate& climate);
  // By how much the last step has changed wetness, film or what is seen of puddles where it has changed them the most; 1 when drops fall.
  float change() const { return change_; }
  // Whether step() would change anything.
  bool active(const WetnessMask& mask, const Climate& climate) const;

  // Adds water round a point of the skin (model space); counts as `painted`.
  void pour(const WetSurface& skin, WetnessMask& mask, const Vec3& centre, const Vec3& normal, float radius, float amount);
  // The initial velocity of a drop that moves by `way` in `seconds` under gravity, wind and drag.
  static Vec3 velocityFor(const Vec3& way, float seconds, const Vec3& wind);
  // Adds a falling drop; counts as `painted`; ignored when there are kMostDrops. One drop with `jet` = kJet each step is a jet.
  static constexpr float kJet = 2.3f;
  void launch(const Vec3& position, const Vec3& velocity, float amount, float jet = 0);
  // Removes the film and the share `share` of wetness within the radius (model space).
  void wipe(const WetSurface& skin, WetnessMask& mask, const Vec3& centre, const Vec3& normal, float radius, float share);
  // Removes drops and puddles. The caller clears the mask.
  void clear();

  std::span<const Drop> drops() const { return drops_; }
  // Triangles on which drops have come down in the last step.
  std::span<const std::uint32_t> landed() const { return landed_; }
  static float dropRadius(float amount);
  // The puddles on the ground (Puddles.h): water per square unit for each cell; the revision changes with them.
  std::span<const float> ground() const { return puddles_; }
  // The same, or nothing where the ground is dry.
  std::vector<float> wetGround() const { return groundWet_ ? puddles_ : std::vector<float>(); }
  void setGround(const std::vector<float>& puddles);
  std::uint32_t groundRevision() const { return groundRevision_; }
  Accounts accounts() const;
  // FNV-1a over the mask, its film, drops and puddles.
  std::uint64_t hash(const WetnessMask& mask) const;
  const SurfaceTexels* texels() const { return texels_.get(); }
  // The same of a surface whose places may not be known yet; of what is not linked before prepare() no link.
  const SurfaceTexels& texelsOf(const WetSurface& skin);

 private:
  // Smaller amounts count as dry, do not flow, and smaller changes as none.
  static constexpr float kLeast = 1.0f / 1024;
  static constexpr float kCling = 0.06f;  // film that stays where it is
  static constexpr float kHangsFrom = 0.4f;  // film that a drop hangs from
  static constexpr std::uint32_t kDryingTurns = 4, kSlowestTurns = 60;  // steps
  // Steps between two updates of water that only dries: enough for a visible change, so that slow drying does not redraw the
  // picture in every frame.
  static std::uint32_t dryingTurns(const Climate& climate);
  // kChanged: since it was last at rest. kSoaked: all of its places hold so much that water does not creep to them.
  enum : std::uint8_t { kWet = 1, kMoving = 2, kReceived = 4, kFlows = 8, kChanged = 16, kSoaked = 32 };
  // When the ways have changed, so many blocks at most find the new ones in a step.
  static constexpr int kMostAimed = 128;

  static constexpr std::size_t kPlaces = SurfaceTexels::kBlock * SurfaceTexels::kBlock;  // of a block, at most
  struct Amounts {
    float held[kPlaces], film[kPlaces];
  };

  bool isSound() const;
  void notice(const WetSurface& skin, WetnessMask& mask);
  void noticeHair(const WetHair& hair);
  bool meetHair(WetHair& hair, Drop& drop, const Vec3& way);
  void makePlaces();
  void aim(const WetSurface& skin, std::uint32_t block);
  bool isAmongSoaked(std::uint32_t block) const;
  void flow(std::uint32_t block);
  template <bool kCreeps>
  bool flowFrom(std::uint32_t block);
  void crossBorders(std::uint32_t block);
  void receive(const WetSurface& skin, WetnessMask& mask, const Climate* climate, std::uint32_t block);
  void evaporate(const WetSurface& skin, WetnessMask& mask, const Climate& climate, std::uint32_t block);
  void store(const WetSurface& skin, WetnessMask& mask, std::uint32_t place, float held, float film);
  static void carryOn(WetnessMask& mask, std::uint32_t mirror, const Vec4& texel, float film);
  bool soak(std::uint32_t block, Amounts& now);
  bool dry(const Climate& climate, std::uint32_t block, Amounts& now);
  bool rest(std::uint32_t block, const Amounts& now, bool moves);
  void wakeBeside(std::uint32_t block);
  bool storeBlock(const WetSurface& skin, WetnessMask& mask, std::uint32_t block, const Amounts& now);
  void touch(WetnessMask& mask);
  void give(std::uint32_t place, float amount);
  // What the corners of the place's triangle have, one a vertex, on average.
  template <class T>
  static T meanAt(const WetSurface& skin, const SurfaceTexels::Place& place, const std::vector<T>& values) {
    T mean(0);
    for (std::size_t k = 0; k < 3; ++k) mean += values[skin.surface.indices[std::size_t{3} * place.triangle + k]] / 3.0f;
    return mean;
  }
  void hangDrops(std::uint32_t block);
  void feedHanging(const WetSurface& skin, WetnessMask& mask, const Climate& climate);
  void fall(const WetSurface& skin, const Climate& climate);
  void rain(const Climate& climate);
  void shake(const WetSurface& skin, WetnessMask& mask, const Climate& climate);
  float letGo(const WetSurface& skin, WetnessMask& mask, std::uint32_t block, float share);
  void fling(const WetSurface& skin, const Climate& climate, const SurfaceTexels::Place& from, float amount);
  void spray(const Vec3& at, const Vec3& normal, float speed);
  void splash(const Vec3& centre, const Vec3& normal, float radius, float amount, std::uint32_t nearest);
  float wetGround(const Vec3& at, float amount);
  // By how much it changes what is seen of the ground (Puddles.h) where it does the most, 0..1.
  float seepGround(float dries);

  std::unique_ptr<SurfaceTexels> texels_;
  ClumpSites sites_;
  bool ready_ = false;
  // One a place; those of floats with room for a block behind the last.
  std::vector<float> held_, film_, incoming_;
  // How water leaves a place in a turn: the shares of running water that go to the two links next to its direction, and the
  // shares of the difference in wetness that go to the four links along u and v. Missing links lead to the place itself.
  struct Ways {
    std::array<std::uint32_t, 2> down{};
    std::array<float, 2> runs{};
    std::array<std::uint32_t, 4> beside{};
    std::array<float, 4> wicks{};
    std::array<std::uint8_t, 2> sides{};  // the links of `down`
  };
  std::vector<Ways> ways_;
  std::vector<float> areas_;
  std::vector<std::uint32_t> texelOf_;
  std::vector<std::uint8_t> hasDrop_;
  // One a block.
  std::vector<std::uint8_t> flags_, stored_;
  std::vector<std::uint32_t> dried_;  // the step of its last drying
  std::vector<std::uint32_t> aimed_;  // the aim_ for which its ways were computed
  std::uint32_t aim_ = 0;             // changes with gravity and lay
  std::uint32_t aimedUpTo_ = 0;       // by prepare()
  Vec3 down_{0, -1, 0};  // model space
  std::vector<Vec3> lay_;
  std::vector<float> lengths_;
  float clumpSize_ = Climate{}.clumpSize;  // of the last step

  std::vector<Drop> drops_;
  std::vector<std::uint32_t> landed_;
  std::size_t hanging_ = 0;
  std::vector<float> puddles_;
  std::uint32_t groundRevision_ = 0;
  bool groundWet_ = false, groundMoves_ = false;
  Random random_{11};
  float rainDue_ = 0;
  std::uint32_t steps_ = 0, seen_ = 0xffffffffu;
  bool changed_ = false;
  float change_ = 0;
  Accounts accounts_;  // without held, film and drops
};

}  // namespace fur::wet
