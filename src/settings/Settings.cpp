#include "settings/Settings.h"

#include "core/Json.h"
#include "settings/FurTypes.h"
#include "settings/LightRigs.h"

namespace fur::settings {

const std::array<Field, kFieldCount>& fields() {
  static constexpr std::array<Field, kFieldCount> table = {{
#define FUR_FIELDS "settings/Fields.inc"
#define FUR_VALUES Values
#include "settings/fields/Rows.inc"
#undef FUR_FIELDS
#undef FUR_VALUES
  }};
  return table;
}

const Field* findField(std::string_view name) {
  for (const Field& field : fields())
    if (name == field.name) return &field;
  return nullptr;
}

bool setField(Settings& settings, std::string_view name, std::string_view text, Warnings& warnings) {
  if (name == "lightRig") return applyLightRig(settings, text, warnings);
  if (const auto of = typeFieldOf(name)) return setTypeField(settings, *of, text, warnings);
  if (const Field* field = findField(name)) return setFieldText(settings, *field, text, warnings);
  warnings.push_back("unknown setting \"" + std::string(name.substr(0, 64)) + '"');
  return false;
}

bool isSetting(std::string_view name) {
  const auto of = typeFieldOf(name);
  return findField(name) || (of && isTypeField(of->name));
}

std::string settingText(const Settings& settings, std::string_view name) {
  if (name == "lightRig") {
    const LightRig* rig = lightRigOf(settings);
    return rig ? rig->name : "";
  }
  if (const auto of = typeFieldOf(name)) return typeFieldText(settings, *of);
  const Field* field = findField(name);
  return field ? fieldText(settings, *field) : std::string();
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
           (describe ? ",\"tooltip\":" + jsonString(describe(field)) : "") + ",\"coat\":" + (field.has(kOfCoat) ? "true" : "false") +
           ",\"ofType\":" + (field.has(kOfType) ? "true}" : "false}");
  }
  return out + ']';
}

}  // namespace fur::settings
