// Draws a furry model with OpenGL ES 3.0. Takes fields and volumes, never sees a solver, a file or a window.
// README.md in this folder lists the frame in order.
#pragma once

#include <optional>
#include <span>

#include "furgen/Packing.h"
#include "geometry/Surface.h"
#include "groom/Groom.h"
#include "gl/Objects.h"
#include "render/Blocks.h"
#include "render/Drops.h"
#include "render/Frame.h"
#include "render/FurShadow.h"
#include "render/FurTextures.h"
#include "render/MovingSurface.h"
#include "render/Programs.h"
#include "render/SmallPicture.h"
#include "render/StrandTables.h"
#include "render/Whiskers.h"
#include "wet/MaskTexels.h"

namespace fur::render {

class Renderer {
 public:
  // Needs a current context, in which the driver begins to compile what usual frames need.
  static Result<Renderer> create();

  // `tangents`, one a vertex, for a surface that will change its shape: setSkin(). What the shape was like at setSurface()
  // stays where it matters little: curvature, the stretch of the tile.
  void setSurface(const geometry::Surface& surface, std::span<const Vec3> tangents = {});
  void setSkin(const Skin& skin);
  // A coat comes in pieces, while the one before stays in the picture: beginFur(), each layer and the fin
  // map with their mipmaps in any order, showFur(). beginFur() anew drops what came.
  void beginFur(int size, int layers, int finRows, int types) { fur_.begin(size, layers, finRows, types); }
  void setFurLayer(int type, int layer, std::span<const furgen::PackedLevel> levels);
  void setFinMap(int type, std::span<const furgen::PackedLevel> levels);
  // `densities`, one a type: the share of its densest layer that strands cover; 0: it is bald.
  void showFur(std::span<const float> densities);
  // Straight RGBA8 in sRGB. {} makes it white.
  void setBaseColor(int width, int height, std::span<const std::uint8_t> rgba);
  // A mask of another size than the one before comes whole.
  void updateMask(const wet::MaskTexels& mask);
  void updateBends(std::span<const Vec4> bends);  // w: length of the fur there, a share; for View::Forces the forces
  // The same for the groom's map of lengths and types, and for its paint.
  void updateGroom(const groom::GroomMap& map, const geometry::TexelRect& changed);
  void updatePaint(const groom::GroomMap& paint, const geometry::TexelRect& changed) { updateMap(paint_, paint, changed); }
  void updateShape(const groom::GroomMap& shape, const geometry::TexelRect& changed);
  // Which triangles shells are drawn on, in place of all of the surface, and the length at every vertex: fins
  // between two of none are left out. What is bald costs nothing. Until the next setSurface().
  void setFurry(geometry::FurPatches patches, std::span<const float> vertexLengths);

  // Those that stand on the surface; until the next call.
  void setWhiskers(std::span<const groom::WhiskerHair> hairs) { uploadedBytes_ += whiskers_.set(hairs); }

  // Before there is a coat: has the driver make ready, in its own time, for pictures like this one. Drivers compile
  // for good when something is first drawn: that is one pixel, which the next picture paints over.
  void warmUp(const Frame& frame);
  // Into the platform's framebuffer, which is bound. A shader that the driver refuses is the error.
  Status draw(const Frame& frame);

  std::size_t gpuBytes() const;
  // Of the last picture: less than the framebuffer has when it was drawn small and enlarged.
  long drawnPixels() const { return drawnPixels_; }
  // Since the last call.
  std::size_t takeUploadedBytes();

 private:
  Renderer() = default;
  Status drawPasses(const Frame& frame);
  Status drawBackground(const Frame& frame);
  Status drawGroundShadow(const Frame& frame);
  Status drawShells(const Frame& frame, unsigned variant);
  Status drawFins(const Frame& frame, unsigned variant);
  Status drawSkin(unsigned variant);
  Status drawArrows(unsigned variant);
  void uploadBlocks(const Frame& frame);
  void updateMap(gl::Texture& texture, const groom::GroomMap& map, const geometry::TexelRect& changed);
  void showPuddles(const wet::Puddles& puddles);
  FurShadow::Key furShadowKey(const Frame& frame) const;
  void selectFins(const Vec3& eyeModel, float pixels);
  void orderShells(const Vec3& eyeModel, float reach, bool overlapping);

  Programs programs_;
  StrandTables strandTables_;
  FurShadow furShadow_;
  Whiskers whiskers_;
  Drops drops_;
  unsigned long furShadowScene_ = 0;  // see FurShadow::Key
  SmallPicture small_;
  gl::Buffer frameBlock_, coatBlock_;
  gl::Buffer vertices_, furVertices_, indices_, furIndices_, edges_;
  gl::VertexArray surface_, shells_, fins_, arrows_;
  FurTextures fur_;
  gl::Texture mask_, bends_, baseColor_, groom_, paint_, shape_, lockCentres_, puddles_;
  gl::Texture groundShadow_[2];
  gl::Target groundTarget_[2];
  int vertexCount_ = 0, indexCount_ = 0, shellIndexCount_ = 0;
  bool sheets_ = false;  // the skin is seen from both sides
  // All patches of fur, and the eye, fur length and overlap that those on the GPU were put in order for.
  geometry::FurPatches patches_;
  std::optional<Vec4> shellsFor_;
  bool shellsOverlap_ = false;
  // Every edge as the GPU takes it, and the eye that the uploaded selection was made for.
  std::vector<FinEdge> finEdges_;
  std::optional<MovingSurface> moving_;
  std::vector<float> vertexLengths_;  // empty: 1 everywhere
  std::optional<Vec4> finEye_;  // w: pixels, see selectFins()
  int finCount_ = 0;
  int bendCapacity_ = 0;
  FurDensities densities_{};
  bool hasFur_ = false, hasPicture_ = false;
  // What the ground shadow was drawn for; it is redrawn when this changes.
  struct ShadowKey {
    Mat4 worldFromModel;
    Vec3 light;
    float length, height;
    Vec4 ball;
    Vec3 mirrorsTo;  // the eye, where the ground is wet
    bool operator==(const ShadowKey&) const = default;
  };
  std::optional<ShadowKey> shadowKey_;
  std::size_t uploadedBytes_ = 0;
  std::uint32_t puddlesRevision_ = 0;  // of those that the texture has
  long drawnPixels_ = 0;
};

}  // namespace fur::render
