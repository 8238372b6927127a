// The long hair of one scalp in GL objects (Halen & Wester 2007, 5.5). Per frame only the nodes of its guides are uploaded, 16 bytes
// each; a small draw then brings the points of all wisps up to date in a texture, which strips, strands and shadows read.
#pragma once

#include "gl/Objects.h"
#include "render/Hair.h"
#include "render/Programs.h"
#include "shared/Hair.h"

namespace fur::render {

// How much of a scalp's hair is drawn.
struct HairLevel {
  int strandWisps = 0;   // drawn strand by strand
  int strands = 1;       // of each of them
  float wispShare = 1;   // of wisps, in (0, 1]
  int step = 1;          // points of a wisp from one that is drawn to the next: 1, 2, 4 or 8
};

class HairScalp {
 public:
  // Both return the bytes that were uploaded.
  std::size_t grow(const HairGrowth& growth);
  std::size_t move(std::span<const hair::GuideNode> nodes);  // model space, guide after guide

  // What is drawn until the next one is set.
  void setLevel(const HairLevel& level);
  const HairLevel& level() const { return level_; }
  int wispsDrawn() const;
  // How far its nodes are from where they were at the last castShadow(); what is wetter or drier counts as well.
  float wayFromShadow() const { return wayFromShadow_; }
  void castShadow();
  // Brings the points of those wisps up to date after move(); leaves the platform's framebuffer bound, and another viewport.
  bool update(Programs& programs);
  // Binds all that the shaders of hair read.
  void bind(const shared::HairBlock& drawn) const;
  const shared::HairBlock& block() const { return block_; }
  // Has the shaders draw strips from the farthest wisp to the nearest.
  void sortFrom(const Vec3& eye);
  bool hasSkin() const { return baseTangents_.bytes() > 0; }

  int wisps() const { return wispCount_; }
  int strands() const { return strandCount_; }  // of a wisp
  float width() const { return width_; }        // of its widest wisp
  // The ball round all nodes, wisps included; model space.
  Vec4 bounds() const { return bounds_; }
  // Of its longest guide.
  float length() const { return length_; }
  // How far from the model's origin they come.
  float reach() const { return reach_; }
  std::size_t bytes() const;

 private:
  void noteWay(std::span<const hair::GuideNode> nodes);
  void fillBlock(const hair::HairValues& values, int nodes);

  gl::Texture nodes_, wisps_, points_, members_, strips_, ambient_, baseTangents_, order_;
  gl::Target pointsTarget_;
  mutable gl::Buffer blockBuffer_;
  std::vector<hair::Wisp> grown_;  // for sortFrom()
  std::vector<Vec4> shown_, cast_;  // nodes and their wetness, now and at castShadow()
  float wayFromShadow_ = 0;
  std::vector<Vec3> middles_;      // of guides, as shown
  shared::HairBlock block_{};
  int wispCount_ = 0, strandCount_ = 0, guideCount_ = 0, nodesEach_ = 0;
  float width_ = 0, margin_ = 0;  // margin_: how far wisps reach beyond the nodes
  Vec4 bounds_{0};
  float reach_ = 0, length_ = 0;
  HairLevel level_;
  int wispsReady_ = 0;  // whose points are up to date
};

}  // namespace fur::render
