// The way that one strand takes from its root: Sheppard's sine curves (3.3.3), and beyond them waves
// that neighbours share, frizz, locks and coils. What neighbours share comes from fields that are smooth
// round the torus, so that they move together and seldom run into each other.
#pragma once

#include <cstdint>
#include <vector>

#include "core/Random.h"
#include "furgen/Coat.h"

namespace fur::furgen {

// A sum of a few waves, periodic in the tile and as steep whatever its size; values within about -1..1.
class SmoothField {
 public:
  SmoothField(std::uint32_t seed, std::uint64_t stream, int size);
  float at(const Vec2& tile) const;  // tile coordinates, period 1

 private:
  static constexpr int kWaves = 5;
  float turns_, phase_[kWaves], weight_[kWaves];
};

// Centres of locks, one in each cell of a jittered grid.
class Locks {
 public:
  Locks(const FurParameters& parameters, int strandsOfFullCoat);
  // From the root to the centre of the nearest lock, texels.
  Vec2 towardsNearest(const Vec2& root) const;

 private:
  float size_;
  int side_;
  std::vector<Vec2> centres_;
};

// What chance decides about a strand.
struct StrandDraws {
  Vec2 root;
  float radius = 0;  // nominal, texels
  float length = 0;  // volume heights
  float dominance = 1, variance = 0;
  Vec2 magnitude[2], phase[2];  // of the two sine curves of each axis; magnitude in -1..1, radians over a height
  float bound = 0;              // 0..1: below `stray` no lock holds it
  float tipOpening = 0, turnJitter = 0;
  Vec2 frizzPhase[3];
};

class StrandPath {
  // Coils differ by where on their circle they begin and by the direction in which they lie: along and
  // across that direction in texels, and the height.
  struct CoilSample {
    float along, across, height;
  };

 public:
  explicit StrandPath(const FurParameters& parameters);

  // One strand on its way. It grows node by node, so that a strand which runs into another is given up at
  // once.
  class Walk {
   public:
    // Appends the next nodes; false at the tip, when there are none. The first call gives the root.
    bool next(std::vector<Node>& nodes);

   private:
    friend class StrandPath;
    explicit Walk(const StrandPath& path) : path_(path) {}
    bool nextUpright(std::vector<Node>& nodes);
    bool nextFree(std::vector<Node>& nodes);
    Vec2 shiftAt(float height) const;
    Vec3 pointAt(int sample) const;
    Node nodeAt(const Vec3& point, float way) const;

    const StrandPath& path_;
    StrandDraws draws_;
    float curl_ = 0, frizz_ = 0;      // texels
    Vec2 frizzAtRoot_{0};
    float wave_ = 0, wavePhase_ = 0, waveAtRoot_ = 0;  // texels, radians
    Vec2 waveWay_{0}, coilWay_{0};
    const CoilSample* coil_ = nullptr;  // none: the strand stands upright
    Vec2 toLock_{0};                  // texels; 0 where no lock holds the strand
    float opening_ = 0;               // of the lock, for this strand
    int step_ = 0;
    Vec3 last_{0};
  };

  // `calm` in [0, 1] takes that much off what is the strand's own: curl and frizz.
  Walk start(const StrandDraws& draws, bool undercoat, float calm) const;

 private:
  void windCoils();
  float spreadAt(float s) const;

  FurParameters parameters_;
  Locks locks_;
  SmoothField wavePhase_, waveTurn_, coilTurn_, coilPhase_;
  float lockedSpread_;  // how near, against their thinning, the strands of a lock may come
  std::vector<CoilSample> coils_;  // [phase][sample]
};

}  // namespace fur::furgen
