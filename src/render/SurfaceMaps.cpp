#include "render/SurfaceMaps.h"

#include <algorithm>
#include <cmath>

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

// Appends it in that size: the mean of the texels that each new one covers, a copy of one where it is larger.
void addScaled(const SurfaceMaps::Picture& from, int width, int height, std::vector<std::uint8_t>& to) {
  if (from.width == width && from.height == height) return void(to.insert(to.end(), from.rgba.begin(), from.rgba.end()));
  const auto first = [](int i, int size, int of) { return static_cast<int>(static_cast<std::int64_t>(i) * of / size); };
  for (int y = 0; y < height; ++y) {
    const int y0 = first(y, height, from.height), y1 = std::max(y0 + 1, first(y + 1, height, from.height));
    for (int x = 0; x < width; ++x) {
      const int x0 = first(x, width, from.width), x1 = std::max(x0 + 1, first(x + 1, width, from.width));
      unsigned sum[4] = {};
      for (int v = y0; v < y1; ++v)
        for (int u = x0; u < x1; ++u)
          for (std::size_t c = 0; c < 4; ++c) sum[c] += from.rgba[4 * (static_cast<std::size_t>(v) * static_cast<std::size_t>(from.width) + static_cast<std::size_t>(u)) + c];
      const auto count = static_cast<unsigned>((y1 - y0) * (x1 - x0));
      for (const unsigned s : sum) to.push_back(static_cast<std::uint8_t>((s + count / 2) / count));
    }
  }
}

}  // namespace

std::size_t SurfaceMaps::create() {
  constexpr groom::EvenTexel kNothing{};
  return updateEvenReach({&kNothing, 1}) + updateGroom(groom::GroomMap(groom::GroomMap::kLeastSize), {});
}

std::size_t SurfaceMaps::setTypePictures(std::span<const Picture> pictures) {
  constexpr int kMost = 2048;
  int width = 0, height = 0, layers = 0;
  typePictures_ = kNoPictures;
  for (std::size_t type = 0; type < std::min(pictures.size(), typePictures_.size()); ++type) {
    if (pictures[type].rgba.empty()) continue;
    width = std::max(width, std::min(pictures[type].width, kMost));
    height = std::max(height, std::min(pictures[type].height, kMost));
    typePictures_[type] = layers++;
  }
  typeColors_ = {};
  if (layers == 0) return 0;
  std::vector<std::uint8_t> all;
  for (std::size_t type = 0; type < typePictures_.size(); ++type)
    if (typePictures_[type] >= 0) addScaled(pictures[type], width, height, all);
  typeColors_ = gl::Texture({gl::TexelFormat::RGBA8, width, height, layers, gl::Filter::Trilinear, true}, gl::bytesOf(all));
  return typeColors_.bytes();
}

std::size_t SurfaceMaps::updateMask(const wet::MaskTexels& mask) {
  const geometry::TexelRect& rect = mask.rect;
  if (rect.empty()) return 0;
  if (mask_.shape().width != mask.size || mask_.bytes() == 0) {
    FUR_ASSERT(rect.x0 == 0 && rect.y0 == 0 && rect.x1 == mask.size, "SurfaceMaps::updateMask()", "a mask of another size from its first row on", mask.texels.size());
    mask_ = gl::Texture({gl::TexelFormat::RGBA32F, mask.size, mask.size, 0, gl::Filter::Nearest, false}, {});
  }
  wetCells_.update(mask);
  // All texels are looked through only until the first water.
  if (lockCentres_.bytes() == 0 && std::any_of(mask.texels.begin(), mask.texels.end(), [](const Vec4& texel) { return texel.w > 0; })) makeLockCentres();
  mask_.update(rect.x0, rect.y0, rect.x1 - rect.x0, rect.y1 - rect.y0, gl::bytesOf(mask.texels), 0);
  return mask.texels.size() * sizeof(Vec4);
}

std::size_t SurfaceMaps::setChartBorders(int maskSize, std::span<const Vec4> texels) {
  const int rows = static_cast<int>(texels.size()) / maskSize;
  mask_ = gl::Texture({gl::TexelFormat::RGBA32F, maskSize, maskSize + rows, 0, gl::Filter::Nearest, false}, {});
  if (rows > 0) mask_.update(0, maskSize, maskSize, rows, std::as_bytes(texels), 0);
  return texels.size_bytes();
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

std::size_t SurfaceMaps::updateEvenReach(std::span<const groom::EvenTexel> texels) {
  const int size = static_cast<int>(std::lround(std::sqrt(texels.size())));
  if (evenReach_.shape().width != size || evenReach_.bytes() == 0) evenReach_ = gl::Texture({gl::TexelFormat::RGBA8, size, size, 0, gl::Filter::Nearest}, {});
  evenReach_.update(0, 0, size, size, std::as_bytes(texels), 0);
  return texels.size_bytes();
}

std::size_t SurfaceMaps::updatePaint(const groom::GroomMap& paint, const geometry::TexelRect& changed) { return update(paint_, paint, changed); }

void SurfaceMaps::makeLockCentres() {
  if (lockCentres_.bytes() > 0) return;
  constexpr int kSize = static_cast<int>(FUR_LOCKS_ACROSS * FUR_LOCK_TEXELS);
  const std::vector<std::array<std::uint8_t, 2>> texels = furgen::lockCentres(kSize, static_cast<int>(FUR_LOCKS_ACROSS));
  lockCentres_ = gl::Texture({gl::TexelFormat::RG8, kSize, kSize, 0, gl::Filter::Nearest, true}, gl::bytesOf(texels));
}

std::size_t SurfaceMaps::updateShape(const groom::GroomMap& shape, const geometry::TexelRect& changed) {
  makeLockCentres();
  return update(shape_, shape, changed);
}

void SurfaceMaps::bind(const Frame& frame) const {
  mask_.bind(FUR_UNIT_MASK);
  bends_.bind(FUR_UNIT_BEND);
  groom_.bind(FUR_UNIT_GROOM);
  if (frame.painted) paint_.bind(FUR_UNIT_PAINT);
  if (frame.shaped) shape_.bind(FUR_UNIT_SHAPE);
  if (frame.shaped || frame.wet) lockCentres_.bind(FUR_UNIT_LOCK_CENTRES);
  if (frame.types) evenReach_.bind(FUR_UNIT_EVEN_REACH);
  if (hasTypePictures()) typeColors_.bind(FUR_UNIT_TYPE_COLORS);
}

std::size_t SurfaceMaps::bytes() const {
  std::size_t sum = 0;
  for (const gl::Texture* texture : {&mask_, &bends_, &groom_, &paint_, &shape_, &lockCentres_, &typeColors_, &evenReach_}) sum += texture->bytes();
  return sum;
}

}  // namespace fur::render
