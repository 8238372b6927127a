// Draws a furry model with OpenGL ES 3.0. Takes fields and volumes, never sees a solver, a file or a window.
// README.md in this folder lists the frame in order; each pass has a folder of its own below passes/.
#pragma once

#include <memory>
#include <span>

#include "furgen/Packing.h"
#include "geometry/Surface.h"
#include "groom/Groom.h"
#include "render/Blocks.h"
#include "render/ContextObjects.h"
#include "render/Frame.h"
#include "render/FurTextures.h"
#include "render/Materials.h"
#include "render/StrandTables.h"
#include "render/SurfaceBuffers.h"
#include "render/SurfaceMaps.h"
#include "render/Views.h"
#include "render/passes/arrow/ArrowPass.h"
#include "render/passes/bead/BeadPass.h"
#include "render/passes/drop/DropPass.h"
#include "render/passes/enlarge/SmallPicture.h"
#include "render/passes/fin/FinPass.h"
#include "render/passes/gather/Gathered.h"
#include "render/passes/ground/GroundPass.h"
#include "render/passes/ground/GroundShadow.h"
#include "render/passes/shadow/FurShadow.h"
#include "render/passes/shell/ShellPass.h"
#include "render/passes/hair/HairPass.h"
#include "render/passes/hairview/HairViews.h"
#include "render/passes/whisker/WhiskerPass.h"

namespace fur::render {

class Renderer {
 public:
  // Needs a current context, in which the driver begins to compile what every frame needs. `shared`: what other renderers in it
  // have; none: there is no other.
  static Result<Renderer> create(std::shared_ptr<ContextObjects> shared = nullptr);

  // `tangents`, one a vertex, for a surface that will change its shape: setSkin(). `materialOf`: one a vertex, the same for all of a
  // triangle; none: the first.
  void setSurface(const geometry::Surface& surface, std::span<const Vec3> tangents = {}, std::span<const std::uint8_t> materialOf = {});
  // See Materials.
  void setMaterials(std::span<const scene::Material> materials, std::size_t main) { uploadedBytes_ += materials_.set(materials, main); }
  void setBare(std::span<const std::uint8_t> bare) { materials_.setBare(bare); }
  void setImage(std::size_t image, int width, int height, const Pixels& rgba) { uploadedBytes_ += materials_.setImage(image, width, height, rgba, shared_->pictures); }
  void setSkin(const Skin& skin);
  // Which triangles shells are drawn on, in place of all of the surface, and the length at every vertex: fins
  // between two of none are left out. What is bald costs nothing. Until the next setSurface().
  void setFurry(geometry::FurPatches patches, std::span<const float> vertexLengths);
  // ShellPass::setCrowded(), until the next setSurface().
  void setCrowded(std::vector<std::uint8_t> vertices) { shells_.setCrowded(std::move(vertices)); }
  void setWhiskers(std::span<const groom::WhiskerHair> hairs) { uploadedBytes_ += whiskers_.set(hairs); }
  // Long hair: so many scalps; what grows on one; where the nodes of its guides are, model space, guide after guide.
  void setScalps(std::size_t count) { hair_->setScalps(count); }
  void growHair(std::size_t scalp, const HairGrowth& growth) { uploadedBytes_ += hair_->grow(scalp, growth); }
  void moveHair(std::size_t scalp, std::span<const hair::GuideNode> nodes) { uploadedBytes_ += hair_->move(scalp, nodes); }

  // What views and tools show of it; nullptr: nothing. Looked at while frames are drawn. Without HairViews it is not shown.
  void viewHair(const hair::HairView* view) { if (hairViews_) hairViews_->show(view); }

  // A coat comes in pieces, while the one before stays in the picture: beginFur(), each layer and the fin
  // map with their mipmaps in any order, showFur(). beginFur() anew drops what came.
  void beginFur(const furgen::CoatShape& shape) { fur_.begin(shape); }
  void setFurLayer(int type, int layer, std::span<const furgen::PackedLevel> levels) { uploadedBytes_ += fur_.setLayer(type, layer, levels); }
  void setFinMap(int type, std::span<const furgen::PackedLevel> levels) { uploadedBytes_ += fur_.setFin(type, levels); }
  // `densities`, one a type: the share of its densest layer that strands cover; 0: it is bald.
  void showFur(std::span<const float> densities) { fur_.show(densities); }
  // That of another renderer in the same context.
  void showFur(std::shared_ptr<FurTextures::Coat> coat) { fur_.show(std::move(coat)); }
  const std::shared_ptr<FurTextures::Coat>& shownFur() const { return fur_.shown(); }

  // See SurfaceMaps.
  void setTypePictures(std::span<const SurfaceMaps::Picture> pictures) { uploadedBytes_ += maps_.setTypePictures(pictures); }
  bool hasTypePictures() const { return maps_.hasTypePictures(); }
  void setChartBorders(int maskSize, std::span<const Vec4> texels) { uploadedBytes_ += maps_.setChartBorders(maskSize, texels); }
  void updateMask(const wet::MaskTexels& mask) { uploadedBytes_ += maps_.updateMask(mask); }
  void updateBends(std::span<const Vec4> bends) { uploadedBytes_ += maps_.updateBends(bends); }
  void updateGroom(const groom::GroomMap& map, const geometry::TexelRect& changed) { uploadedBytes_ += maps_.updateGroom(map, changed); }
  void updateEvenReach(std::span<const groom::EvenTexel> texels) { uploadedBytes_ += maps_.updateEvenReach(texels); }
  void updatePaint(const groom::GroomMap& paint, const geometry::TexelRect& changed) { uploadedBytes_ += maps_.updatePaint(paint, changed); }
  void updateShape(const groom::GroomMap& shape, const geometry::TexelRect& changed) { uploadedBytes_ += maps_.updateShape(shape, changed); }

  // What of a model says which shaders it needs.
  struct Parts {
    bool textured = false, skinPictured = false;  // as Look has them
    bool bare = false, whiskers = false;          // it has some
  };
  // Has the driver compile what pictures like this one need: of the model that is there, or of one that is about to come.
  void begin(const Frame& frame);
  void begin(const Frame& frame, const Parts& parts);
  // Whether all that was begun is compiled: draw() would wait for it.
  bool ready() const { return programs().ready(); }
  // Before there is a coat: has the driver make ready, in its own time, for pictures like this one. Drivers compile
  // for good when something is first drawn: that is one pixel, which the next picture paints over.
  void warmUp(const Frame& frame);
  // Into the platform's framebuffer, which is bound. A shader that the driver refuses is the error.
  Status draw(const Frame& frame);
  // The mean of the samples that have been gathered for a frame like this one, once more.
  Status showGathered(const Frame& frame);
  // The picture stays as it is: gives back the memory that only another one needs.
  void rest();

  std::size_t gpuBytes() const;
  // Of the last picture: less than the framebuffer has when it was drawn small and enlarged.
  long drawnPixels() const { return drawnPixels_; }
  // Since the last call.
  std::size_t takeUploadedBytes();

 private:
  Renderer() = default;
  void beginPrograms(const Frame& frame, const Parts& parts);
  bool drawPasses(const Drawing& drawing);
  bool gather(const Drawing& drawing, const Frame& frame);
  bool drawFinal(const Drawing& drawing);
  bool drawClassic(const Drawing& drawing);
  bool drawView(const Drawing& drawing, View view);
  bool drawCounts(const Drawing& drawing, View view);
  bool drawModel(const Drawing& drawing, VariantBits view);
  bool drawPart(const Drawing& drawing, const ViewPart& part);
  FurShadow::Key furShadowKey(const Frame& frame) const;
  void uploadBlocks(const Frame& frame, const FurShadow::Key& shadow);

  Programs& programs() const { return shared_->programs; }

  std::shared_ptr<ContextObjects> shared_;
  // What passes share.
  gl::Buffer frameBlock_;
  SurfaceBuffers surface_;
  SurfaceMaps maps_;
  Materials materials_;
  FurTextures fur_;
  StrandTables strandTables_;

  // In the order in which they draw; the others have no objects of their own.
  GroundShadow groundShadow_;
  FurShadow furShadow_;
  ShellPass shells_;
  FinPass fins_;
  ArrowPass arrows_;
  std::unique_ptr<HairPass> hair_ = HairPass::make();
  std::unique_ptr<HairViews> hairViews_ = HairViews::make();
  WhiskerPass whiskers_;
  GroundPass ground_;
  BeadPass beads_;
  DropPass drops_;
  SmallPicture small_;
  Gathered gathered_;

  std::size_t uploadedBytes_ = 0;
  long drawnPixels_ = 0;
};

}  // namespace fur::render
