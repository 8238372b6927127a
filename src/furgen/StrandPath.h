// The path of one strand from its root: Sheppard's sine curves (3.3.3), and waves, frizz, locks and coils. Waves and coils come
// from fields that are smooth on the torus, so that neighbours move together and seldom collide.
#pragma once

#include <cstdint>
#include <vector>

#include "core/Random.h"
#include "furgen/Coat.h"

namespace fur::furgen {

// A sum of a few waves, periodic in the tile, with the same slope for every tile size; values within about -1..1.
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

// The random numbers of one strand.
struct StrandDraws {
  Vec2 root;
  float radius = 0;  // nominal, texels
  float length = 0;  // volume heights
  float dominance = 1, variance = 0;
  Vec2 magnitude[2], phase[2];  // of the two sine curves of each axis; magnitude in -1..1, radians over a height
  float bound = 0;              // 0..1: below `stray` the strand is in no lock
  float tipOpening = 0, turnJitter = 0;
  Vec2 frizzPhase[3];
};

class StrandPath {
  // A point of a coil: along and across the direction in which the coil lies, in texels, and its height.
  struct CoilSample {
    float along, across, height;
  };

 public:
  explicit StrandPath(const FurParameters& parameters);

  // Builds one strand node by node, so that a strand that collides can be dropped at once.
  class Walk {
   public:
    // Appends the next nodes, the root first; false when the tip has been reached.
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
    const CoilSample* coil_ = nullptr;  // null: no coil
    Vec2 toLock_{0};                  // from the root to the lock's centre, texels; 0 without a lock
    float opening_ = 0;               // how far the lock opens at its tip, for this strand
    int step_ = 0;
    Vec3 last_{0};
  };

  // `calm`, 0..1: reduces the strand's own curl and frizz by this share.
  Walk start(const StrandDraws& draws, bool undercoat, float calm) const;

 private:
  void windCoils();
  float spreadAt(float s) const;

  FurParameters parameters_;
  Locks locks_;
  SmoothField wavePhase_, waveTurn_, coilTurn_, coilPhase_;
  float lockedSpread_;  // how far the strands of a lock may be drawn together without touching
  std::vector<CoilSample> coils_;  // [phase][sample]
};

}  // namespace fur::furgen
