#include "scene/import/GltfFur.h"

#include <algorithm>
#include <cmath>

#include "core/NumberText.h"
#include "scene/MapPlanes.h"
#include "scene/Model.h"
#include "scene/StateJson.h"
#include "scene/import/GltfHair.h"
#include "scene/import/ImageHeader.h"
#include "scene/WetnessPlanes.h"

namespace fur::scene {

namespace {

// Reads the square map that `map` describes: `unpack(bytes, texels)` says whether the bytes hold that many. Returns its side.
template <class Unpack>
int readSquare(const GltfFile& file, const Json& map, const std::string& where, int least, int most, const Unpack& unpack,
               const char* view = "bufferView") {
  if (!map.isObject()) file.bad("%s is not an object", where.c_str());
  const Whole size = file.whole(map, "size", where);
  if (size > static_cast<Whole>(most)) file.fail(ErrorId::TooLarge, "%s.size is %llu; the limit is %d", where.c_str(), size, most);
  if (size < static_cast<Whole>(least)) file.bad("%s.size is %llu; the least is %d", where.c_str(), size, least);
  if (!unpack(file.bufferView(file.whole(map, view, where)).bytes, static_cast<std::size_t>(size * size)))
    file.bad("%s does not hold a map of %llu x %llu texels", where.c_str(), size, size);
  return static_cast<int>(size);
}

void readMap(const GltfFile& file, const Json& groom, const char* view, FurData& fur, std::vector<groom::GroomMap::Texel>& map) {
  fur.mapSize = readSquare(file, groom, "WETFUR_fur.groom", groom::GroomMap::kLeastSize, groom::GroomMap::kMostSize,
                           [&](Bytes bytes, std::size_t texels) {
                             map.resize(texels);
                             return unpackMap(bytes, map);
                           }, view);
}

void readWetness(const GltfFile& file, const Json& wetness, FurData& fur) {
  fur.wetnessSize = readSquare(file, wetness, "WETFUR_fur.wetness", kLeastWetness, kMostWetness,
                               [&](Bytes bytes, std::size_t texels) {
                                 fur.wetness.resize(texels);
                                 return unpackWetness(bytes, fur.wetness);
                               });
}

void readWhiskers(const GltfFile& file, const Json& whiskers, FurData& fur) {
  const char* where = "WETFUR_fur.whiskers";
  if (!whiskers.isObject()) file.bad("%s is not an object", where);
  const Bytes bytes = file.bufferView(file.whole(whiskers, "bufferView", where)).bytes;
  const bool whole = bytes.size() % groom::kWhiskerBytes == 0;
  if (!whole || bytes.size() > groom::kMostWhiskers * groom::kWhiskerBytes)
    file.fail(whole ? ErrorId::TooLarge : ErrorId::BadFile, "%s does not hold up to 512 of 52 bytes", where);
  fur.whiskers = groom::readWhiskers(bytes);
}

void readWater(const GltfFile& file, const Json& water, FurData& fur) {
  const char* where = "WETFUR_fur.water";
  if (!water.isObject()) file.bad("%s is not an object", where);
  const Whole bytes = file.whole(water, "bytes", where);
  if (bytes > kMostWaterBytes) file.fail(ErrorId::TooLarge, "%s.bytes is %llu; the limit is %zu", where, bytes, kMostWaterBytes);
  fur.water.resize(static_cast<std::size_t>(bytes));
  if (!unpackPlanes(file.bufferView(file.whole(water, "bufferView", where)).bytes, fur.water)) file.bad("%s does not hold %llu bytes", where, bytes);
}

void readTypeSet(const GltfFile& file, const Json& from, const std::string& where, TypeFiles& coat) {
  if (!from.find("typeSet")) return;
  const Bytes bytes = file.bufferView(file.whole(from, "typeSet", where)).bytes;
  coat.typeSet.assign(bytes.begin(), bytes.end());
}

void readPicture(const GltfFile& file, const Json& picture, const std::string& where, EncodedImage& out) {
  if (!picture.isObject()) file.bad("%s is not an object", where.c_str());
  const Bytes bytes = file.bufferView(file.whole(picture, "bufferView", where)).bytes;
  auto read = encodedImage({bytes.begin(), bytes.end()}, where);
  if (!read) file.fail(read.error().id, "%s", read.error().message.c_str());
  out = std::move(*read);
}

void readTypes(const GltfFile& file, const Json& types, FurData& fur) {
  if (!types.isArray()) file.bad("WETFUR_fur.types is not an array");
  if (types.count() > groom::kTypes) file.fail(ErrorId::TooLarge, "WETFUR_fur.types has %zu elements; the limit is %d", types.count(), groom::kTypes);
  std::size_t i = 0;
  for (const Json& type : types) {
    const std::string where = "WETFUR_fur.types[" + decimal(i) + "]";
    if (!type.isObject()) file.bad("%s is not an object", where.c_str());
    readTypeSet(file, type, where, fur.coats[i]);
    if (const Json* picture = type.find("picture")) readPicture(file, *picture, where + ".picture", fur.coats[i].picture);
    ++i;
  }
}

std::vector<int> readBare(const GltfFile& file, const Json& bare) {
  if (!bare.isArray()) file.bad("WETFUR_fur.bare is not an array");
  std::vector<int> out;
  for (const Json& one : bare) {
    const double index = one.isNumber() ? one.number() : -2;
    if (!(index >= -1 && index < static_cast<double>(file.count("materials"))) || index != std::floor(index))
      file.bad("WETFUR_fur.bare[%zu] is not the number of a material, of which there are %zu", out.size(), file.count("materials"));
    if (out.size() > file.count("materials")) file.fail(ErrorId::TooLarge, "WETFUR_fur.bare names more than the %zu materials", file.count("materials"));
    out.push_back(static_cast<int>(index));
  }
  return out;
}

// All maps lie in the same texture coordinates.
void noteAtlas(const GltfFile& file, const Json& part, const char* name, GltfFur& out) {
  if (!out.surface) {
    const Whole set = file.whole(part, "texCoord", name);
    if (out.hasMap && set != out.atlasSet) file.bad("%s has another texCoord than the maps before it", name);
    out.atlasSet = set;
  }
  out.hasMap = true;
}

}  // namespace

GltfFur readFur(const GltfFile& file, FurData& fur) {
  GltfFur out;
  const Json* extensions = file.json().find("extensions");
  const Json* found = extensions ? extensions->find("WETFUR_fur") : nullptr;
  if (!found) return out;
  if (!found->isObject()) file.bad("WETFUR_fur is not an object");
  const Whole version = file.whole(*found, "version", "WETFUR_fur");
  if (version > Whole{kFurVersion})
    file.fail(ErrorId::UnsupportedVersion, "WETFUR_fur has version %llu; this program reads up to %d", version, kFurVersion);
  out.present = true;
  out.surface = found->find("surface");
  if (const Json* state = found->find("state")) {
    fur.state = state->source();
    if (auto read = readState(fur.state); !read) file.fail(read.error().id, "WETFUR_fur: %s", read.error().message.c_str());
  }
  if (const Json* groom = found->find("groom")) {
    readMap(file, *groom, "bufferView", fur, fur.map);
    if (groom->find("paint")) readMap(file, *groom, "paint", fur, fur.paint);
    if (groom->find("mask")) readMap(file, *groom, "mask", fur, fur.mask);
    if (groom->find("shape")) readMap(file, *groom, "shape", fur, fur.shape);
    noteAtlas(file, *groom, "WETFUR_fur.groom", out);
  }
  if (const Json* wetness = found->find("wetness")) {
    readWetness(file, *wetness, fur);
    noteAtlas(file, *wetness, "WETFUR_fur.wetness", out);
  }
  if (const Json* water = found->find("water")) readWater(file, *water, fur);
  if (const Json* hair = found->find("hair")) {
    if (!hairReader()) file.fail(ErrorId::LargerProgram, "it has long hair, which this program does not grow");
    fur.hair = hairReader()->read(file, *hair, out.warnings);
    noteAtlas(file, *hair, "WETFUR_fur.hair", out);
  }
  readTypeSet(file, *found, "WETFUR_fur", fur.coats[0]);
  if (const Json* types = found->find("types")) readTypes(file, *types, fur);
  if (const Json* picture = found->find("skinPicture")) readPicture(file, *picture, "WETFUR_fur.skinPicture", fur.coats[groom::kTypes].picture);
  if (const Json* lie = found->find("lie")) fur.isLying = lie->isTrue();
  if (const Json* bare = found->find("bare")) out.bare = readBare(file, *bare);
  if (const Json* whiskers = found->find("whiskers")) readWhiskers(file, *whiskers, fur);
  return out;
}

}  // namespace fur::scene
