#include "core/Json.h"
#include "core/NumberText.h"
#include "scene/Base64.h"
#include "scene/CoatFile.h"
#include "scene/TypeSet.h"

namespace fur::scene {

std::vector<std::uint8_t> writeCoat(const CoatFile& coat) {
  const settings::Values standard;
  std::string out = std::string("{\"") + kCoatVersionKey + "\":" + decimal(kCoatVersion) + ",\"name\":" + jsonString(coat.name) + ",\"settings\":{";
  const char* before = "\"";
  for (const settings::Field& field : settings::fields()) {
    if (!field.has(settings::kOfCoat) || field.get(coat.values) == field.get(standard)) continue;
    out.append(before).append(field.name).append("\":").append(settings::fieldJson(coat.values, field));
    before = ",\"";
  }
  out += "}";
  if (!coat.files.typeSet.empty()) out.append(",\"typeSet\":\"").append(base64Encoded(coat.files.typeSet)).append("\"");
  if (!coat.files.picture.bytes.empty()) out.append(",\"picture\":\"").append(base64Encoded(coat.files.picture.bytes)).append("\"");
  out += "}\n";
  if (out.size() == kTypeSetBytes) out += '\n';  // by which isCoatFile() knows a .fts
  return {out.begin(), out.end()};
}

}  // namespace fur::scene
