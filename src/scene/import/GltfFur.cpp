#include "scene/import/GltfFur.h"

#include "scene/PackBits.h"
#include "scene/StateJson.h"

namespace fur::scene {

namespace {

void readMap(const GltfFile& file, const Json& groom, FurData& fur) {
  const std::string where = "WETFUR_fur.groom";
  if (!groom.isObject()) file.bad("%s is not an object", where.c_str());
  const Whole size = file.whole(groom, "size", where);
  constexpr int kLeast = groom::GroomMap::kLeastSize, kMost = groom::GroomMap::kMostSize;
  if (size > Whole{kMost}) file.fail(ErrorId::TooLarge, "%s.size is %llu; the limit is %d", where.c_str(), size, kMost);
  if (size < Whole{kLeast}) file.bad("%s.size is %llu; the least is %d", where.c_str(), size, kLeast);
  const auto texels = static_cast<std::size_t>(size * size);
  std::vector<std::uint8_t> planes(4 * texels);
  if (!unpackBits(file.bufferView(file.whole(groom, "bufferView", where)).bytes, planes))
    file.bad("%s does not hold a map of %llu x %llu texels", where.c_str(), size, size);
  fur.mapSize = static_cast<int>(size);
  fur.map.resize(texels);
  for (std::size_t i = 0; i < texels; ++i)
    for (std::size_t k = 0; k < 4; ++k) fur.map[i][k] = planes[k * texels + i];
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
  if (const Json* state = found->find("state")) {
    fur.state = state->source();
    if (auto read = readState(fur.state); !read) file.fail(read.error().id, "WETFUR_fur: %s", read.error().message.c_str());
  }
  if (const Json* groom = found->find("groom")) {
    readMap(file, *groom, fur);
    out.hasMap = true;
    out.atlasSet = file.whole(*groom, "texCoord", "WETFUR_fur.groom");
  }
  if (const Json* whiskers = found->find("whiskers")) readWhiskers(file, *whiskers, fur);
  return out;
}

}  // namespace fur::scene
