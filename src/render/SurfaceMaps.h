// What lies on the model: the textures over its atlas, and a bend a vertex.
#pragma once

#include <cstdint>
#include <span>

#include "geometry/AtlasTexels.h"
#include "gl/Objects.h"
#include "groom/EvenReach.h"
#include "render/Blocks.h"
#include "render/WetCells.h"
#include "wet/MaskTexels.h"

namespace fur::render {

// What fills them returns the bytes that were uploaded.
class SurfaceMaps {
 public:
  // Fur of full length everywhere. Needs a context.
  std::size_t create();
  // A colour map of each fur type and of the skin, straight RGBA8 in sRGB; empty: it has none. All are made as large as the largest, up to a limit.
  struct Picture {
    int width = 0, height = 0;
    std::span<const std::uint8_t> rgba{};
  };
  std::size_t setTypePictures(std::span<const Picture> pictures);
  // What gutters of the mask lead to by their numbers (wet/ChartBorders.h). The whole mask, of that size, is to be uploaded after it.
  std::size_t setChartBorders(int maskSize, std::span<const Vec4> texels);
  // A mask of another size than the one before comes whole.
  std::size_t updateMask(const wet::MaskTexels& mask);
  // One a vertex; w: length of the fur there, a share; for View::Forces the forces.
  std::size_t updateBends(std::span<const Vec4> bends);
  // Only what has changed; all of a map of another size.
  std::size_t updateGroom(const groom::GroomMap& map, const geometry::TexelRect& changed);
  // groom/EvenReach.h, all of it.
  std::size_t updateEvenReach(std::span<const groom::EvenTexel> texels);
  std::size_t updatePaint(const groom::GroomMap& paint, const geometry::TexelRect& changed);
  std::size_t updateShape(const groom::GroomMap& shape, const geometry::TexelRect& changed);

  // Those that the frame's shaders read, to their units.
  void bind(const Frame& frame) const;
  bool hasTypePictures() const { return typeColors_.bytes() > 0; }
  const TypePictures& typePictures() const { return typePictures_; }
  const WetCells& wetCells() const { return wetCells_; }
  int maskSize() const { return mask_.shape().width; }
  // Another number whenever strands stand otherwise: bends or groom are others.
  unsigned long revision() const { return revision_; }
  std::size_t bytes() const;

 private:
  void makeLockCentres();  // the first time that strands gather in locks

  gl::Texture mask_, bends_, groom_, paint_, shape_, lockCentres_, typeColors_, evenReach_;
  WetCells wetCells_;
  TypePictures typePictures_ = kNoPictures;
  unsigned long revision_ = 0;
};

}  // namespace fur::render
