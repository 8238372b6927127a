#include <cstdio>

#include "geometry/Weld.h"
#include "scene/FoModel.h"
#include "scene/import/CornerMesh.h"

namespace fur::scene {

namespace {

// Nine digits tell every float from its neighbours.
void appendNumber(std::string& text, float value) {
  char digits[32];
  std::snprintf(digits, sizeof digits, " %.9g", static_cast<double>(value));
  for (char* c = digits; *c; ++c)
    if (*c == ',') *c = '.';  // a host program may have set a locale that prints numbers so
  text += digits;
}

}  // namespace

std::vector<std::uint8_t> writeFo(const FoModel& fo) {
  std::string text;
  for (std::size_t i = 0; i < fo.positions.size(); ++i) {
    const Vec3 &p = fo.positions[i], &n = fo.normals[i];
    text += 'v';
    for (const float value : {p.x, p.y, p.z, n.x, n.y, n.z, fo.length[i]}) appendNumber(text, value);
    text += ' ' + std::to_string(fo.furType[i]) + '\n';
  }
  for (const FoModel::Texcoord& t : fo.texcoords) {
    text += 't';
    for (const float value : {t.colour.x, t.colour.y, t.fur.x, t.fur.y}) appendNumber(text, value);
    text += '\n';
  }
  for (const auto& face : fo.faces) {
    text += 'p';
    for (const FoModel::Corner& corner : face)
      text += ' ' + std::to_string(corner.vertex + 1) + '/' + std::to_string(corner.texcoord + 1);
    text += '\n';
  }
  return {text.begin(), text.end()};
}

FoModel foFromSurface(const geometry::Surface& surface, float repeat) {
  std::vector<Vec3> positions, normals;
  for (const geometry::SurfaceVertex& v : surface.vertices) {
    positions.push_back(v.position);
    normals.push_back(v.normal);
  }
  const geometry::Weld position = geometry::weldPositions(positions), normal = geometry::weldPositions(normals);
  std::vector<Corner> pairs;
  for (std::size_t i = 0; i < positions.size(); ++i) pairs.push_back({position.idOf[i], normal.idOf[i], 0});
  const CornerWeld weld = weldCorners(pairs, {position.count, normal.count, 0});

  FoModel fo;
  for (const std::uint32_t vertex : weld.cornerOf) {
    fo.positions.push_back(positions[vertex]);
    fo.normals.push_back(normals[vertex]);
  }
  fo.length.assign(fo.positions.size(), 1.0f);
  fo.furType.assign(fo.positions.size(), 0);
  for (const geometry::SurfaceVertex& v : surface.vertices)
    fo.texcoords.push_back({{v.uv.x, 1.0f - v.uv.y}, v.fur * repeat});
  for (std::size_t t = 0; t < surface.triangleCount(); ++t) {
    const std::uint32_t* corner = &surface.indices[3 * t];
    fo.faces.push_back({{{weld.vertexOf[corner[0]], corner[0]},
                         {weld.vertexOf[corner[1]], corner[1]},
                         {weld.vertexOf[corner[2]], corner[2]}}});
  }
  return fo;
}

}  // namespace fur::scene
