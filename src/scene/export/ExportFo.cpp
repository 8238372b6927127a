#include <cmath>
#include <cstdarg>
#include <cstdio>

#include "geometry/Weld.h"
#include "scene/FoModel.h"
#include "scene/import/CornerMesh.h"

namespace fur::scene {

namespace {

// A line of the file, as std::printf has it; %.9g tells every float from its neighbours.
[[gnu::format(printf, 2, 3)]] void appendLine(std::vector<std::uint8_t>& bytes, const char* format, ...) {
  char line[200];
  std::va_list arguments;
  va_start(arguments, format);
  const int length = std::vsnprintf(line, sizeof line, format, arguments);
  va_end(arguments);
  for (char* c = line; *c; ++c)
    if (*c == ',') *c = '.';  // a host program may have set a locale that prints numbers so
  bytes.insert(bytes.end(), line, line + length);
}

}  // namespace

std::vector<std::uint8_t> writeFo(const FoModel& fo) {
  std::vector<std::uint8_t> bytes;
  for (std::size_t i = 0; i < fo.positions.size(); ++i) {
    const glm::dvec3 p(fo.positions[i]), n(fo.normals[i]);
    appendLine(bytes, "v %.9g %.9g %.9g %.9g %.9g %.9g %.9g %d\n", p.x, p.y, p.z, n.x, n.y, n.z, double{fo.length[i]}, fo.furType[i]);
  }
  for (const FoModel::Texcoord& t : fo.texcoords) {
    const glm::dvec2 colour(t.colour), fur(t.fur);
    appendLine(bytes, "t %.9g %.9g %.9g %.9g\n", colour.x, colour.y, fur.x, fur.y);
  }
  for (const auto& [a, b, c] : fo.faces)
    appendLine(bytes, "p %u/%u %u/%u %u/%u\n", a.vertex + 1, a.texcoord + 1, b.vertex + 1, b.texcoord + 1, c.vertex + 1, c.texcoord + 1);
  return bytes;
}

namespace {

// From root to tip: an arc whose tip has turned by `bend` leans by half of that.
Vec3 hairDirection(const Vec3& normal, const Vec3& bend) {
  const float angle = glm::length(bend);
  return angle > 0 ? normal * std::cos(0.5f * angle) + bend * (std::sin(0.5f * angle) / angle) : normal;
}

}  // namespace

FoModel foFromSurface(const geometry::Surface& surface, float repeat, const FoFur& fur) {
  std::vector<Vec3> positions, normals;
  for (std::size_t i = 0; i < surface.vertices.size(); ++i) {
    const geometry::SurfaceVertex& v = surface.vertices[i];
    positions.push_back(v.position);
    normals.push_back(fur.bends.empty() ? v.normal : hairDirection(v.normal, fur.bends[i]));
  }
  const geometry::Weld position = geometry::weldPositions(positions), normal = geometry::weldPositions(normals);
  std::vector<Corner> pairs;
  for (std::size_t i = 0; i < positions.size(); ++i) pairs.push_back({position.idOf[i], normal.idOf[i], 0});
  const CornerWeld weld = weldCorners(pairs, {position.count, normal.count, 0});

  FoModel fo;
  for (const std::uint32_t vertex : weld.cornerOf) {
    fo.positions.push_back(positions[vertex]);
    fo.normals.push_back(normals[vertex]);
    fo.length.push_back(fur.lengths[vertex]);
    fo.furType.push_back(fur.types[vertex]);
  }
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
