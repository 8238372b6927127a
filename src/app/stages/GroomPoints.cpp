// The numbers of single places and whiskers, which the editor shows and sets.
#include "app/stages/Brushes.h"
#include "app/stages/GroomStage.h"
#include "app/stages/Mirror.h"

namespace fur::app {

namespace {

// The nearest of the triangle's corners: the vertex that Sheppard's program would have selected.
std::uint32_t nearestVertexOf(const groom::GroomSurface& skin, const geometry::SurfacePoint& at) {
  int corner = 0;
  for (int k = 1; k < 3; ++k)
    if (at.weights[k] > at.weights[corner]) corner = k;
  return skin.surface.indices[std::size_t{3} * at.triangle + static_cast<std::size_t>(corner)];
}

}  // namespace

FurAt GroomStage::numbersAt(const ShapeStage& shape, const geometry::SurfacePoint& at) {
  const groom::GroomSurface skin = groomSurface(shape);
  const Vec2 atlas = atlasAt(skin.surface, at);
  const Vec4 texel = groom_.map.at(atlas);
  FurAt out;
  out.place = positionAt(skin.surface, at);
  out.normal = normalAt(skin.surface, at);
  out.length = texel.x;
  out.types = {saturate(1 - texel.y - texel.z - texel.w), texel.y, texel.z, texel.w};
  for (int k = 0; k < 3; ++k)
    out.comb += at.weights[k] * groom::bendAt(groom_, skin.lie, skin.points.pointOf[skin.surface.indices[std::size_t{3} * at.triangle + static_cast<std::size_t>(k)]]);
  out.comb -= out.normal * glm::dot(out.comb, out.normal);
  return out;
}

void GroomStage::setNumber(const ShapeStage& shape, const settings::Settings& settings, FurNumber what, const geometry::SurfacePoint& at, float value,
                           const Vec3& bend) {
  const groom::GroomSurface skin = groomSurface(shape);
  if (before_) {
    if (what == FurNumber::Comb) groom_.comb = before_->comb;
    else groom_.map.restore(before_->map.texels());
  }
  const auto set = [&](const geometry::SurfacePoint& point, const Vec3& to) {
    groom::Brush brush = brushAt(settings, positionAt(skin.surface, point), normalAt(skin.surface, point));
    brush.strength = 1;
    switch (what) {
      case FurNumber::Length: groom::setLength(groom_, skin, brush, value); break;
      case FurNumber::Type: groom::paintType(groom_, skin, brush, static_cast<int>(value)); break;
      case FurNumber::Comb: groom::setComb(groom_, skin, brush, to, nearestVertexOf(skin, point)); break;
      case FurNumber::Wetness: break;
    }
  };
  set(at, bend);
  if (const auto other = mirrored(settings, shape, at)) set(*other, mirrored(settings, bend));
  touch();
}

void GroomStage::setWhisker(std::size_t index, const groom::Whisker& to) {
  if (index >= groom_.whiskers.size()) return;
  groom::Whisker sound = to;
  if (groom::makeSound(sound)) groom_.whiskers[index] = sound;
  touch();
}

void GroomStage::removeWhisker(std::size_t index) {
  if (index < groom_.whiskers.size()) groom_.whiskers.erase(groom_.whiskers.begin() + static_cast<std::ptrdiff_t>(index));
  touch();
}

Vec3 GroomStage::aimed(const ShapeStage& shape, const groom::Whisker& whisker, const Vec3& origin, const Vec3& direction) const {
  const auto at = groom::rootOf(whisker, shape.query());
  if (!at) return whisker.direction;
  return groom::pulledDirection(normalAt(shape.surface(), *at), whisker.length, pullAt(whisker.root, origin, direction));
}

}  // namespace fur::app
