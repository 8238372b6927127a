#include "render/SurfaceMaps.h"

#include <algorithm>

#include "core/Assert.h"
#include "furgen/LockCentres.h"
#include "shared/Blocks.h"

namespace fur::render {

namespace {

std::size_t update(gl::Texture& texture, const groom::GroomMap& map, const geometry::TexelRect& changed) {
  const int size = map.size();
  const auto bytes = gl::bytesOf(map.texels());
  if (texture.shape().width != size) {
    texture = gl::Texture({gl::TexelFormat::RGBA8, size, size, 0, gl::Filter::Linear, false}, bytes);
    return texture.bytes();
  }
  if (changed.empty()) return 0;
  const int width = changed.x1 - changed.x0, height = changed.y1 - changed.y0;
  texture.update(changed.x0, changed.y0, width, height, bytes, size);
  return sizeof(groom::GroomMap::Texel) * static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
}

}  // namespace

std::size_t SurfaceMaps::create() {
  return updateGroom(groom::GroomMap(groom::GroomMap::kLeastSize), {});
}

std::size_t SurfaceMaps::updateMask(const wet::MaskTexels& mask) {
  const geometry::TexelRect& rect = mask.rect;
  if (rect.empty()) return 0;
  if (mask_.shape().width != mask.size || mask_.bytes() == 0) {
    const geometry::TexelRect whole{0, 0, mask.size, mask.size};
    FUR_ASSERT(rect == whole, "SurfaceMaps::updateMask()", "the whole of a mask of another size", mask.texels.size());
    mask_ = gl::Texture({gl::TexelFormat::RGBA32F, mask.size, mask.size, 0, gl::Filter::Nearest, false}, {});
  }
  mask_.update(rect.x0, rect.y0, rect.x1 - rect.x0, rect.y1 - rect.y0, gl::bytesOf(mask.texels), 0);
  return mask.texels.size() * sizeof(Vec4);
}

std::size_t SurfaceMaps::updateBends(std::span<const Vec4> bends) {
  ++revision_;
  const int rows = std::max(1, (static_cast<int>(bends.size()) + FUR_BEND_ROW - 1) / FUR_BEND_ROW);
  if (bends_.shape().height != rows || bends_.bytes() == 0)
    bends_ = gl::Texture({gl::TexelFormat::RGBA32F, FUR_BEND_ROW, rows, 0, gl::Filter::Nearest, false}, {});
  const int fullRows = static_cast<int>(bends.size()) / FUR_BEND_ROW;
  const int rest = static_cast<int>(bends.size()) % FUR_BEND_ROW;
  const auto bytes = std::as_bytes(bends);
  if (fullRows) bends_.update(0, 0, FUR_BEND_ROW, fullRows, bytes, FUR_BEND_ROW);
  if (rest) bends_.update(0, fullRows, rest, 1, bytes.subspan(sizeof(Vec4) * fullRows * FUR_BEND_ROW), 0);
  return bytes.size();
}

std::size_t SurfaceMaps::updateGroom(const groom::GroomMap& map, const geometry::TexelRect& changed) {
  ++revision_;
  return update(groom_, map, changed);
}

std::size_t SurfaceMaps::updatePaint(const groom::GroomMap& paint, const geometry::TexelRect& changed) { return update(paint_, paint, changed); }

std::size_t SurfaceMaps::updateShape(const groom::GroomMap& shape, const geometry::TexelRect& changed) {
  if (lockCentres_.bytes() == 0) {
    constexpr int kSize = 128;
    const std::vector<std::array<std::uint8_t, 2>> texels = furgen::lockCentres(kSize, static_cast<int>(FUR_LOCKS_ACROSS));
    lockCentres_ = gl::Texture({gl::TexelFormat::RG8, kSize, kSize, 0, gl::Filter::Nearest, true}, gl::bytesOf(texels));
  }
  return update(shape_, shape, changed);
}

void SurfaceMaps::bind(const Frame& frame) const {
  mask_.bind(FUR_UNIT_MASK);
  bends_.bind(FUR_UNIT_BEND);
  groom_.bind(FUR_UNIT_GROOM);
  if (frame.painted) paint_.bind(FUR_UNIT_PAINT);
  if (frame.shaped) shape_.bind(FUR_UNIT_SHAPE), lockCentres_.bind(FUR_UNIT_LOCK_CENTRES);
}

std::size_t SurfaceMaps::bytes() const {
  std::size_t sum = 0;
  for (const gl::Texture* texture : {&mask_, &bends_, &groom_, &paint_, &shape_, &lockCentres_}) sum += texture->bytes();
  return sum;
}

}  // namespace fur::render
