#include "scene/import/GltfFur.h"

#include "scene/PackBits.h"
#include "scene/StateJson.h"

namespace fur::scene {

namespace {

void readMap(const GltfFile& file, const Json& groom, FurData& fur) {
  const std::string where = "WETFUR_fur.groom";
  if (!groom.is_object()) file.bad(where + " is not an object");
  const std::uint64_t size = file.whole(groom, "size", where);
  if (size > static_cast<std::uint64_t>(groom::GroomMap::kMostSize))
    file.fail(ErrorId::TooLarge, where + ".size is " + std::to_string(size) + "; the limit is " +
                                     std::to_string(groom::GroomMap::kMostSize));
  if (size < static_cast<std::uint64_t>(groom::GroomMap::kLeastSize))
    file.bad(where + ".size is " + std::to_string(size) + "; the least is " + std::to_string(groom::GroomMap::kLeastSize));
  const auto texels = static_cast<std::size_t>(size * size);
  std::vector<std::uint8_t> planes(4 * texels);
  if (!unpackBits(file.bufferView(file.whole(groom, "bufferView", where)).bytes, planes))
    file.bad(where + " does not hold a map of " + std::to_string(size) + " x " + std::to_string(size) + " texels");
  fur.mapSize = static_cast<int>(size);
  fur.map.resize(texels);
  for (std::size_t i = 0; i < texels; ++i)
    for (std::size_t k = 0; k < 4; ++k) fur.map[i][k] = planes[k * texels + i];
}

}  // namespace

GltfFur readFur(const GltfFile& file, FurData& fur) {
  GltfFur out;
  const auto extensions = file.json().find("extensions");
  if (extensions == file.json().end() || !extensions->is_object()) return out;
  const auto found = extensions->find("WETFUR_fur");
  if (found == extensions->end()) return out;
  if (!found->is_object()) file.bad("WETFUR_fur is not an object");
  const std::uint64_t version = file.whole(*found, "version", "WETFUR_fur");
  if (version > static_cast<std::uint64_t>(kFurVersion))
    file.fail(ErrorId::UnsupportedVersion, "WETFUR_fur has version " + std::to_string(version) +
                                               "; this program reads up to " + std::to_string(kFurVersion));
  out.present = true;
  if (const auto state = found->find("state"); state != found->end()) {
    fur.state = state->dump();
    if (auto read = readState(fur.state); !read) file.fail(read.error().id, "WETFUR_fur: " + read.error().message);
  }
  if (const auto groom = found->find("groom"); groom != found->end()) {
    readMap(file, *groom, fur);
    out.hasMap = true;
    out.atlasSet = file.whole(*groom, "texCoord", "WETFUR_fur.groom");
  }
  return out;
}

}  // namespace fur::scene
