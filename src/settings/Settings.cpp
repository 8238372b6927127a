#include "settings/Settings.h"

#include "core/Json.h"
#include "settings/LightRigs.h"
#include "settings/Presets.h"

namespace fur::settings {

namespace {

constexpr double kMaxColor = 0xffffff;

}  // namespace

const std::array<Field, kFieldCount>& fields() {
#define FUR_FLOAT(name, label, group, value, low, high, unit, tip, ...) \
  Field{{#name, label, group, FieldType::Float, value, low, high, unit, "", bool{__VA_ARGS__}}, FUR_FIELD_ACCESS(Settings, name, float)},
#define FUR_INT(name, label, group, value, low, high, unit, tip, ...) \
  Field{{#name, label, group, FieldType::Int, value, low, high, unit, "", bool{__VA_ARGS__}}, FUR_FIELD_ACCESS(Settings, name, int)},
#define FUR_BOOL(name, label, group, value, tip, ...) \
  Field{{#name, label, group, FieldType::Bool, value, 0, 1, "", "", bool{__VA_ARGS__}}, FUR_FIELD_ACCESS(Settings, name, bool)},
#define FUR_COLOR(name, label, group, value, tip, ...) \
  Field{{#name, label, group, FieldType::Color, value, 0, kMaxColor, "", "", bool{__VA_ARGS__}}, FUR_FIELD_ACCESS(Settings, name, std::uint32_t)},
#define FUR_CHOICE(name, label, group, value, options, tip, ...) \
  Field{{#name, label, group, FieldType::Choice, value, 0, greatestOption(options), "", options, bool{__VA_ARGS__}}, \
        FUR_FIELD_ACCESS(Settings, name, int)},
  static const std::array<Field, kFieldCount> table = {{
#include "settings/Fields.inc"
  }};
#undef FUR_FLOAT
#undef FUR_INT
#undef FUR_BOOL
#undef FUR_COLOR
#undef FUR_CHOICE
  return table;
}

const Field* findField(std::string_view name) {
  for (const Field& field : fields())
    if (name == field.name) return &field;
  return nullptr;
}

bool setField(Settings& settings, std::string_view name, std::string_view text, Warnings& warnings) {
  if (name == "lightRig") return applyLightRig(settings, text, warnings);
  if (const Field* field = findField(name)) return setFieldText(settings, *field, text, warnings);
  warnings.push_back("unknown setting \"" + std::string(name.substr(0, 64)) + '"');
  return false;
}

namespace {
const char* (*describe)(const Field&) = nullptr;
}

void describeFieldsWith(const char* (*tooltip)(const Field&)) { describe = tooltip; }

std::string fieldTableJson() {
  std::string out = "[";
  for (const Field& field : fields()) {
    if (out.size() > 1) out += ',';
    out += rowJson(field) +
           (describe ? ",\"tooltip\":" + jsonString(describe(field)) : "") + ",\"coat\":" + (belongsToCoat(field) ? "true}" : "false}");
  }
  return out + ']';
}

}  // namespace fur::settings
