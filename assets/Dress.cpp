#include "assets/Dress.h"

#include <algorithm>
#include <cstdio>

#include "app/stages/GroomStage.h"
#include "app/stages/GrownHair.h"

using namespace fur;

namespace {

constexpr int kMapSize = 256;

class Dresser {
 public:
  Dresser(const geometry::Mesh& mesh, const geometry::Surface& surface) : atlas_(surface, kMapSize) {
    shape_.setModel(mesh, surface, {});
    groom_.comb.assign(shape_.points().count(), Vec3(0));
  }

  Status doStep(const std::string& step) {
    if (step.rfind("dab ", 0) == 0) return dab(step);
    if (step.rfind("shade ", 0) == 0) return shade(step);
    if (step.rfind("soften ", 0) == 0) return soften(step);
    if (step.rfind("whisker ", 0) == 0) return whisker(step);
    Warnings warnings;
    Status status = step.find('=') != std::string::npos ? setValue(step, warnings) : edit(step, warnings);
    return !status || warnings.empty() ? status : Error{ErrorId::BadFile, step + ": " + warnings[0]};
  }

  void takeOff(scene::FurData& out) const {
    out.hair = hair_.style();
    out.whiskers = groom_.whiskers;
    out.mapSize = kMapSize;
    if (!groom_.paint.isPlain()) out.map = groom_.map.texels(), out.paint = groom_.paint.texels();
  }

 private:
  static Error wrong(const std::string& step, const char* expected) { return {ErrorId::BadFile, step + ": expected " + expected}; }
  groom::GroomSurface skin() const { return {shape_.surface(), shape_.query(), atlas_, shape_.points()}; }

  Status dab(const std::string& step) {
    unsigned color = 0;
    groom::Brush brush;
    if (std::sscanf(step.c_str(), "dab #%6x %f %f %f %f %f", &color, &brush.strength, &brush.radius, &brush.centre.x, &brush.centre.y, &brush.centre.z) != 6)
      return wrong(step, "dab #RRGGBB STRENGTH RADIUS X Y Z");
    brush.normal = normalizeOr(brush.centre, Vec3(0, 0, 1));
    groom::paint(groom_, skin(), brush, color);
    return Done{};
  }

  Status shade(const std::string& step) {
    unsigned color = 0;
    float strength = 0;
    if (std::sscanf(step.c_str(), "shade #%6x %f", &color, &strength) != 2 || hair_.selected() >= hair_.style().scalps.size())
      return wrong(step, "shade #RRGGBB STRENGTH, and a scalp");
    const groom::GroomMap& map = hair_.style().scalps[hair_.selected()].map;
    for (std::uint32_t texel = 0; texel < map.texels().size(); ++texel) {
      const auto opacity = static_cast<std::uint8_t>(saturate(strength) * static_cast<float>(map.texels()[texel][0]) + 0.5f);
      const auto part = [&](unsigned shift) { return static_cast<std::uint8_t>(color >> shift & 255u); };
      if (opacity > groom_.paint.texels()[texel][3]) groom_.paint.set(texel, {part(16), part(8), part(0), opacity});
    }
    return Done{};
  }

  Status whisker(const std::string& step) {
    groom::Whisker one;
    Vec3 &at = one.root, &way = one.direction;
    unsigned color = 0;
    const int read = std::sscanf(step.c_str(), "whisker #%6x %f %f %f %f %f %f %f %f", &color, &one.length, &one.width, &at.x, &at.y, &at.z, &way.x, &way.y, &way.z);
    one.color = color;
    one.stiffness = 1;
    one.seed = static_cast<std::uint32_t>(groom_.whiskers.size()) + 1;
    const auto near = shape_.nearest(at);
    if (read != 9 || !near || !groom::makeSound(one)) return wrong(step, "whisker #RRGGBB LENGTH WIDTH X Y Z DX DY DZ, on the surface");
    at = positionAt(shape_.surface(), *near);
    groom_.whiskers.push_back(one);
    return Done{};
  }

  Status soften(const std::string& step) {
    float reach = 0;
    if (std::sscanf(step.c_str(), "soften %f", &reach) != 1 || reach <= 0 || hair_.selected() >= hair_.style().scalps.size())
      return wrong(step, "soften DISTANCE, and a scalp");
    hair::Hairstyle style = hair_.style();
    groom::GroomMap& map = style.scalps[hair_.selected()].map;
    std::vector<std::pair<std::uint32_t, Vec3>> covered;
    std::vector<Vec3> border;
    for (std::uint32_t t = 0; t < shape_.surface().triangleCount(); ++t)
      atlas_.forTexelsOf(shape_.surface(), t, [&](std::uint32_t texel, const Vec3& weights) {
        const Vec3 at = positionAt(shape_.surface(), geometry::SurfacePoint{t, weights, 0});
        const std::uint8_t density = map.texels()[texel][0];
        if (density > 0) covered.emplace_back(texel, at);
        if (density > 0 && density < 128) border.push_back(at);
      });
    for (const auto& [texel, at] : covered) {
      float far = reach;
      for (const Vec3& p : border) far = std::min(far, glm::distance(p, at));
      const float share = glm::smoothstep(0.0f, reach, far);
      const groom::GroomMap::Texel was = map.texels()[texel];
      const auto scaled = [&](std::uint8_t value) { return static_cast<std::uint8_t>(static_cast<float>(value) * share + 0.5f); };
      map.set(texel, {scaled(was[0]), scaled(was[1]), scaled(was[2]), was[3]});
    }
    map.fillGutter(atlas_, {0, 0, map.size(), map.size()});
    hair_.setStyle(std::move(style));
    return Done{};
  }

  Status setValue(const std::string& step, Warnings& warnings) {
    const std::size_t equals = step.find('=');
    return hair_.setValue(hair_.selected(), step.substr(0, equals), step.substr(equals + 1), warnings);
  }

  Status edit(const std::string& step, Warnings& warnings) {
    const std::size_t comma = std::min(step.find(','), step.size());
    const auto edit = app::hairEditNamed(step.substr(0, comma));
    float value = 1;
    Vec3 direction(0);
    const int numbers = comma < step.size() ? std::sscanf(step.c_str() + comma, ",%f,%f,%f,%f", &value, &direction.x, &direction.y, &direction.z) : 0;
    if (!edit || (numbers != 0 && numbers != 1 && numbers != 4)) return wrong(step, "EDIT, EDIT,VALUE or EDIT,VALUE,X,Y,Z");
    hair_.edit(shape_, skin(), {}, {*edit, value, direction}, warnings);
    return Done{};
  }

  app::ShapeStage shape_;
  geometry::AtlasTexels atlas_;
  groom::Groom groom_{groom::GroomMap(kMapSize), {}};
  app::GrownHair hair_;
};

}  // namespace

Status dress(const geometry::Mesh& mesh, const geometry::Surface& surface, const std::vector<std::string>& steps, scene::FurData& out) {
  Dresser dresser(mesh, surface);
  for (const std::string& step : steps)
    if (Status status = dresser.doStep(step); !status) return status;
  dresser.takeOff(out);
  return Done{};
}
