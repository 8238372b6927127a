#include "scene/import/GltfHair.h"

#include <algorithm>
#include <cmath>
#include <cstring>

#include "core/NumberText.h"
#include "hair/HairFields.h"
#include "scene/MapPlanes.h"
#include "scene/Model.h"

namespace fur::scene {

namespace {

constexpr std::size_t kBodyBytes = 28;  // ends and radius
constexpr float kMostBody = 1e3f;  // radius and place, in radii of the model

groom::GroomMap readScalpMap(const GltfFile& file, const Json& scalp, const std::string& where) {
  const Whole size = file.whole(scalp, "size", where);
  if (size < Whole{groom::GroomMap::kLeastSize} || size > Whole{groom::GroomMap::kMostSize})
    file.bad("%s.size is %llu; a map has %d to %d", where.c_str(), size, groom::GroomMap::kLeastSize, groom::GroomMap::kMostSize);
  const auto texels = static_cast<std::size_t>(size * size);
  std::vector<groom::GroomMap::Texel> map(texels);
  if (!unpackMap(file.bufferView(file.whole(scalp, "bufferView", where)).bytes, map))
    file.bad("%s does not hold a map of %llu x %llu texels", where.c_str(), size, size);
  groom::GroomMap out(static_cast<int>(size), groom::GroomMap::kBlank);
  out.restore(std::move(map));
  return out;
}

hair::Guides readGuides(const GltfFile& file, const Json& guides, const std::string& where) {
  if (!guides.isObject()) file.bad("%s is not an object", where.c_str());
  hair::Guides out;
  const Whole nodes = file.whole(guides, "nodes", where);
  if (nodes < Whole{hair::kLeastNodes} || nodes > Whole{hair::kMostNodes})
    file.bad("%s.nodes is %llu; a guide has %d to %d", where.c_str(), nodes, hair::kLeastNodes, hair::kMostNodes);
  out.nodes = static_cast<int>(nodes);
  const Bytes flags = file.bufferView(file.whole(guides, "flags", where)).bytes;
  const Bytes positions = file.bufferView(file.whole(guides, "positions", where)).bytes;
  if (flags.size() > hair::kMostGuides)
    file.fail(ErrorId::TooLarge, "%s has %zu guides; the limit is %zu", where.c_str(), flags.size(), hair::kMostGuides);
  if (positions.size() != flags.size() * static_cast<std::size_t>(nodes) * sizeof(Vec3))
    file.bad("%s.positions does not hold %zu guides of %llu nodes", where.c_str(), flags.size(), nodes);
  out.flags.assign(flags.begin(), flags.end());
  out.positions.resize(positions.size() / sizeof(Vec3));
  std::memcpy(out.positions.data(), positions.data(), positions.size());
  for (const Vec3& node : out.positions)
    if (!std::isfinite(node.x + node.y + node.z)) file.bad("%s.positions has a number that is not finite", where.c_str());
  return out;
}

std::vector<std::uint8_t> readHairWetness(const GltfFile& file, const Json& guides, std::size_t nodes, const std::string& where) {
  if (!guides.find("wetness")) return {};
  const Bytes wetness = file.bufferView(file.whole(guides, "wetness", where)).bytes;
  if (wetness.size() != nodes) file.bad("%s.wetness does not hold a byte for each of %zu nodes", where.c_str(), nodes);
  return {wetness.begin(), wetness.end()};
}

hair::Scalp readScalp(const GltfFile& file, const Json& scalp, const std::string& where, Warnings& warnings) {
  if (!scalp.isObject()) file.bad("%s is not an object", where.c_str());
  hair::Scalp out;
  if (const Json* name = scalp.find("name")) out.name = hair::soundName(name->text());
  if (const Json* values = scalp.find("values")) {
    if (!values->isObject()) file.bad("%s.values is not an object", where.c_str());
    out.values = hair::readHairValues(*values, warnings);
  }
  const Json* map = scalp.find("map");
  if (!map || !map->isObject()) file.bad("%s.map is not an object", where.c_str());
  out.map = readScalpMap(file, *map, where + ".map");
  if (const Json* guides = scalp.find("guides")) {
    out.guides = readGuides(file, *guides, where + ".guides");
    out.wetness = readHairWetness(file, *guides, out.guides.positions.size(), where + ".guides");
  }
  return out;
}

// The nodes of the file that bodies go with; -1: none.
void readBones(const GltfFile& file, const Json& bones, std::vector<hair::Body>& bodies) {
  if (!bones.isArray() || bones.count() != bodies.size()) file.bad("WETFUR_fur.hair.bones does not have %zu numbers", bodies.size());
  std::size_t i = 0;
  for (const Json& bone : bones) {
    const double number = bone.number();
    if (!(number >= -1 && number < static_cast<double>(file.count("nodes")) && number == std::floor(number)))
      file.bad("WETFUR_fur.hair.bones[%zu] is no node of the file", i);
    bodies[i++].bone = static_cast<std::int32_t>(number);
  }
}

std::vector<hair::Body> readBodies(const GltfFile& file, const Json& hair) {
  const Bytes bytes = file.bufferView(file.whole(hair, "bodies", "WETFUR_fur.hair")).bytes;
  const bool whole = bytes.size() % kBodyBytes == 0;
  if (!whole || bytes.size() > hair::kMostBodies * kBodyBytes)
    file.fail(whole ? ErrorId::TooLarge : ErrorId::BadFile, "WETFUR_fur.hair.bodies does not hold up to %zu bodies of 28 bytes", hair::kMostBodies);
  std::vector<hair::Body> bodies(bytes.size() / kBodyBytes);
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    float numbers[kBodyBytes / sizeof(float)];
    std::memcpy(numbers, bytes.data() + i * kBodyBytes, kBodyBytes);
    bodies[i] = {Vec3(numbers[0], numbers[1], numbers[2]), Vec3(numbers[3], numbers[4], numbers[5]), numbers[6]};
    const Vec3 sum = bodies[i].a + bodies[i].b;
    if (!std::isfinite(sum.x + sum.y + sum.z + bodies[i].radius) || !(bodies[i].radius > 0))
      file.bad("WETFUR_fur.hair.bodies[%zu] has a number that is not finite, or no radius", i);
  }
  if (const Json* bones = hair.find("bones")) readBones(file, *bones, bodies);
  return bodies;
}

hair::Hairstyle readHair(const GltfFile& file, const Json& hair, Warnings& warnings) {
  if (!hair.isObject()) file.bad("WETFUR_fur.hair is not an object");
  hair::Hairstyle out;
  const Json* scalps = hair.find("scalps");
  if (!scalps || !scalps->isArray()) file.bad("WETFUR_fur.hair.scalps is not an array");
  if (scalps->count() > hair::kMostScalps)
    file.fail(ErrorId::TooLarge, "WETFUR_fur.hair has %zu scalps; the limit is %zu", scalps->count(), hair::kMostScalps);
  for (const Json& scalp : *scalps)
    out.scalps.push_back(readScalp(file, scalp, "WETFUR_fur.hair.scalps[" + decimal(out.scalps.size()) + "]", warnings));
  if (hair.find("bodies")) out.bodies = readBodies(file, hair);
  return out;
}

void fitHair(const GltfFile& file, hair::Hairstyle& hair, const geometry::Fit& fit) {
  const auto within = [](const Vec3& p, float most) { return std::max({std::abs(p.x), std::abs(p.y), std::abs(p.z)}) <= most; };
  for (std::size_t i = 0; i < hair.scalps.size(); ++i) {
    for (Vec3& node : hair.scalps[i].guides.positions) node = fit.of(node);
    if (!hair::makeSound(hair.scalps[i].guides))
      file.bad("WETFUR_fur.hair.scalps[%zu].guides.positions leads farther from the model than %d times its radius", i, static_cast<int>(hair::kFarthestNode));
  }
  for (std::size_t i = 0; i < hair.bodies.size(); ++i) {
    hair::Body& body = hair.bodies[i];
    body = {fit.of(body.a), fit.of(body.b), static_cast<float>(double{body.radius} * fit.scale), body.bone};
    if (!within(body.a, kMostBody) || !within(body.b, kMostBody) || !(body.radius <= kMostBody))
      file.bad("WETFUR_fur.hair.bodies[%zu] is larger or farther from the model than %d times its radius", i, static_cast<int>(kMostBody));
  }
}

}  // namespace

void readLongHair() {
  static constexpr HairReader kReader{readHair, fitHair};
  readHairWith(&kReader);
}

}  // namespace fur::scene
