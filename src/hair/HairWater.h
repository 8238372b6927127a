// Water in long hair: what it catches of falling drops, what runs along it, hangs at its tips and lets go, dries, and is thrown out
// of it where it is shaken.
//
// Each node of a guide has a wetness: its water as a share of what soaks the hair that follows the guide there, 1 being soaked,
// kFull where water runs down it as well. Up to three drops hang from the wisps that follow a guide. Amounts are in units of what soaks a square model unit
// of fur (wet/Water.h), and are conserved: what comes is what was taken, what goes is a drop or has dried.
//
// Hair dries the faster the thinner it is: tips first. What it does not hold runs to the lower node; at the lowest it gathers in
// drops at the tips of wisps there, which fall when they are too heavy. Where a node is jerked harder than water clings, drops fly
// off with its velocity.
//
// Steps are fixed; the same calls give the same bits on every platform. Nothing is done for dry hair. Positions are in world space.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/Bytes.h"
#include "core/Random.h"
#include "hair/WispGrid.h"

namespace fur::hair {

// How fast hair dries.
struct HairAir {
  float dryRate = 0;   // per second, as wet/Drying.h has it
  Vec3 blowCentre{0};  // of a hair dryer, which adds `blow` there, falling to 0 at its radius
  float blowRadius = 0, blow = 0;
};

// What leaves hair.
struct HairDrop {
  Vec3 position{0}, velocity{0};
  float water = 0;
};

class HairWater {
 public:
  static constexpr float kStep = 1.0f / 60;  // s
  static constexpr float kFull = 1.25f;      // no wetness is higher

  // Other hair: dry, unless it has as many guides and nodes, which then keep their wetness. `lengths`: of the guides.
  void assign(const ShownHair& hair, std::span<const float> lengths);
  // Tells where the nodes are after so many seconds; of 0 they were put there. To be called before anything below when they have moved.
  void move(std::span<const GuideNode> nodes, float seconds);
  void rest() { jerks_.clear(), placed_ = false; }  // they stand still

  // What it takes of a drop of so much water that goes `way` in a step.
  float take(const ShownHair& hair, const Vec3& from, const Vec3& way, float water);
  // A step; returns what has dried. Appends what leaves, `most` drops at most: the rest waits.
  double step(const ShownHair& hair, const HairAir& air, std::vector<HairDrop>& drops, std::size_t most);
  // Whether step() would change anything.
  bool active(const HairAir& air) const { return wet_ && (moves_ || air.dryRate > 0 || air.blow > 0); }
  bool isDry() const { return !wet_; }

  // Hair within the radius gets wetter by `amount` in the middle, less round it; or drier by what is below 0.
  void wetNear(const ShownHair& hair, const Vec3& centre, float radius, float amount);
  void soak(float wetness);  // all of it
  void dry(float drying);    // all of it, for a long time at once: rate times seconds
  // Where a ray meets hair.
  std::optional<WispSpot> meet(const ShownHair& hair, const Vec3& origin, const Vec3& direction);

  std::span<const float> wetness() const { return wetness_; }  // of each node
  double water() const;
  // The drops that hang: their amounts, and where on which wisp.
  struct Hanging {
    float water = 0;
    WispSpot at;
  };
  std::vector<Hanging> hanging(const ShownHair& hair) const;

  // A wetness for each node, then the hanging water of each guide.
  std::vector<float> state() const;
  std::size_t stateSize() const { return wetness_.size() + drops_.size(); }
  void setState(std::span<const float> state);

 private:
  const WispGrid& grid(const ShownHair& hair);
  float add(std::size_t node, float water);
  double evaporate(const ShownHair& hair, const HairAir& air, std::size_t guide);
  bool run(const ShownHair& hair, std::size_t guide);
  bool gather(const ShownHair& hair, std::size_t guide);
  void drip(const ShownHair& hair, std::size_t guide, float share, std::vector<HairDrop>& drops);
  bool throwOut(const ShownHair& hair, std::size_t guide, std::vector<HairDrop>& drops);
  WispSpot dropSpot(const ShownHair& hair, std::size_t guide, std::uint32_t which) const;
  void wake() { wet_ = moves_ = true; }

  std::size_t nodes_ = 0;
  // Of each node.
  std::vector<float> wetness_, capacity_;
  std::vector<Vec3> positions_, velocities_;
  std::vector<float> jerks_;  // size of its acceleration; empty: it stands still
  // Of each guide.
  struct Drop {
    float water = 0;
    std::uint16_t node = 0;    // where it hangs
    std::uint32_t chosen = 0;  // of the wisps that follow the guide: the one from which a drop falls next; others hang from those after it
  };
  std::vector<Drop> drops_;
  std::vector<std::uint16_t> last_;  // its last node that holds water
  std::vector<std::uint32_t> followers_, followersOf_;  // wisps that follow it most: guide after guide, and where each one's begin
  WispGrid grid_;
  bool gridStale_ = true, wet_ = false, moves_ = false, placed_ = false;
  std::uint32_t steps_ = 0;
  Random random_{5};
};

}  // namespace fur::hair
