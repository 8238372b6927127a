#include "hair/HairFields.h"

namespace fur::hair {

const std::array<HairField, kHairFieldCount>& hairFields() {
  static constexpr std::array<HairField, kHairFieldCount> table = {{
#define FUR_FIELDS "hair/HairFields.inc"
#define FUR_VALUES HairValues
#include "settings/fields/Rows.inc"
#undef FUR_FIELDS
#undef FUR_VALUES
  }};
  return table;
}

const HairField* findHairField(std::string_view name) {
  for (const HairField& field : hairFields())
    if (name == field.name) return &field;
  return nullptr;
}

std::string writeHairValues(const HairValues& values, bool all) {
  const HairValues standard;
  std::string out = "{";
  for (const HairField& field : hairFields()) {
    if (!all && field.get(values) == field.get(standard)) continue;
    if (out.size() > 1) out += ',';
    out.append("\"").append(field.name).append("\":").append(settings::fieldJson(values, field));
  }
  return out + '}';
}

HairValues readHairValues(const Json& object, Warnings& warnings) {
  HairValues values;
  for (const Json& key : object) {
    const std::string name = key.text();
    const HairField* field = findHairField(name);
    if (!field) {
      warnings.push_back("unknown value of hair \"" + name.substr(0, 64) + '"');
      continue;
    }
    const Json& value = key.value();
    if (value.isNumber())
      settings::setField(values, *field, value.number(), warnings);
    else
      settings::setFieldText(values, *field, value.isString() ? value.text() : std::string(value.source()), warnings);
  }
  return values;
}

}  // namespace fur::hair
