#include "hair/HairFields.h"

namespace fur::hair {

namespace {

using settings::FieldType;
using settings::greatestOption;

constexpr double kMaxColor = 0xffffff;

}  // namespace

const std::array<HairField, kHairFieldCount>& hairFields() {
#define FUR_FLOAT(name, label, group, value, low, high, unit, tip, ...) \
  HairField{{#name, label, group, FieldType::Float, value, low, high, unit, "", bool{__VA_ARGS__}}, FUR_FIELD_ACCESS(HairValues, name, float)},
#define FUR_INT(name, label, group, value, low, high, unit, tip, ...) \
  HairField{{#name, label, group, FieldType::Int, value, low, high, unit, "", bool{__VA_ARGS__}}, FUR_FIELD_ACCESS(HairValues, name, int)},
#define FUR_BOOL(name, label, group, value, tip, ...) \
  HairField{{#name, label, group, FieldType::Bool, value, 0, 1, "", "", bool{__VA_ARGS__}}, FUR_FIELD_ACCESS(HairValues, name, bool)},
#define FUR_COLOR(name, label, group, value, tip, ...) \
  HairField{{#name, label, group, FieldType::Color, value, 0, kMaxColor, "", "", bool{__VA_ARGS__}}, \
            FUR_FIELD_ACCESS(HairValues, name, std::uint32_t)},
#define FUR_CHOICE(name, label, group, value, options, tip, ...) \
  HairField{{#name, label, group, FieldType::Choice, value, 0, greatestOption(options), "", options, bool{__VA_ARGS__}}, \
            FUR_FIELD_ACCESS(HairValues, name, int)},
  static const std::array<HairField, kHairFieldCount> table = {{
#include "hair/HairFields.inc"
  }};
#undef FUR_FLOAT
#undef FUR_INT
#undef FUR_BOOL
#undef FUR_COLOR
#undef FUR_CHOICE
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
