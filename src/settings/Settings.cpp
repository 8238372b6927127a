#include "settings/Settings.h"

#include <charconv>
#include <cmath>

#include "core/Json.h"
#include "core/Math.h"
#include "core/NumberText.h"
#include "settings/LightRigs.h"
#include "settings/Presets.h"

namespace fur::settings {

namespace {

constexpr double kMaxColor = 0xffffff;

bool readColor(std::string_view text, double& value) {
  if (!text.empty() && text.front() == '#') text.remove_prefix(1);
  std::uint32_t rgb = 0;
  const auto result = std::from_chars(text.data(), text.data() + text.size(), rgb, 16);
  if (text.size() != 6 || result.ec != std::errc() || result.ptr != text.data() + text.size()) return false;
  value = rgb;
  return true;
}

bool readValue(const Field& field, std::string_view text, double& value) {
  switch (field.type) {
    case FieldType::Color: return readColor(text, value);
    case FieldType::Bool:
      if (text == "true" || text == "1") return value = 1, true;
      if (text == "false" || text == "0") return value = 0, true;
      return false;
    case FieldType::Choice: {
      const int index = optionIndex(field, text);
      if (index >= 0) return value = index, true;
      return false;
    }
    default: return readDecimal(text, value);
  }
}

const char* typeName(FieldType type) {
  switch (type) {
    case FieldType::Float: return "float";
    case FieldType::Int: return "int";
    case FieldType::Bool: return "bool";
    case FieldType::Color: return "color";
    case FieldType::Choice: return "choice";
  }
  return "float";
}

}  // namespace

const std::array<Field, kFieldCount>& fields() {
#define FUR_ACCESS(name, Type)                               \
  [](const Settings& s) { return static_cast<double>(s.name); }, \
      [](Settings& s, double v) { s.name = static_cast<Type>(v); }
#define FUR_FLOAT(name, label, group, value, low, high, unit, tip, ...) \
  {#name, label, group, FieldType::Float, value, low, high, unit, "", FUR_ACCESS(name, float), bool{__VA_ARGS__}},
#define FUR_INT(name, label, group, value, low, high, unit, tip, ...) \
  {#name, label, group, FieldType::Int, value, low, high, unit, "", FUR_ACCESS(name, int), bool{__VA_ARGS__}},
#define FUR_BOOL(name, label, group, value, tip, ...) \
  {#name, label, group, FieldType::Bool, value, 0, 1, "", "", FUR_ACCESS(name, bool), bool{__VA_ARGS__}},
#define FUR_COLOR(name, label, group, value, tip, ...) \
  {#name, label, group, FieldType::Color, value, 0, kMaxColor, "", "", FUR_ACCESS(name, std::uint32_t), bool{__VA_ARGS__}},
#define FUR_CHOICE(name, label, group, value, options, tip, ...)                              \
  {#name, label, group, FieldType::Choice, value, 0, kMaxColor, "", options, \
   FUR_ACCESS(name, int), bool{__VA_ARGS__}},
  static const std::array<Field, kFieldCount> table = [] {
    std::array<Field, kFieldCount> rows = {{
#include "settings/Fields.inc"
    }};
    for (Field& row : rows) {
      if (row.type != FieldType::Choice) continue;
      int last = 0;
      for (const char* c = row.options; *c; ++c) last += *c == '|';
      row.high = last;
    }
    return rows;
  }();
#undef FUR_FLOAT
#undef FUR_INT
#undef FUR_BOOL
#undef FUR_COLOR
#undef FUR_CHOICE
#undef FUR_ACCESS
  return table;
}

const Field* findField(std::string_view name) {
  for (const Field& field : fields())
    if (name == field.name) return &field;
  return nullptr;
}

void setField(Settings& settings, const Field& field, double value, Warnings& warnings) {
  const double given = value;
  if (std::isnan(value)) value = field.standard;
  // As the field holds it: the bound 3.1416f is a little less than the 3.1416 of a text.
  value = field.type == FieldType::Float ? static_cast<float>(glm::clamp(value, -1e30, 1e30)) : std::floor(value + 0.5);
  const double wanted = value;
  value = glm::clamp(value, field.low, field.high);
  if (std::isnan(given) || value != wanted)
    warnings.push_back(std::string(field.name) + ": " + shortDecimal(given) + " is outside " + shortDecimal(field.low) +
                       " to " + shortDecimal(field.high) + ", " + shortDecimal(value) + " is used");
  field.set(settings, value);
}

bool setField(Settings& settings, std::string_view name, std::string_view text, Warnings& warnings) {
  if (name == "lightRig") return applyLightRig(settings, text, warnings);
  const Field* field = findField(name);
  if (!field) {
    warnings.push_back("unknown setting \"" + std::string(name.substr(0, 64)) + '"');
    return false;
  }
  double value = 0;
  if (!readValue(*field, text, value)) {
    warnings.push_back(std::string(field->name) + ": \"" + std::string(text.substr(0, 64)) + "\" is not a " +
                       (field->type == FieldType::Choice ? std::string("choice of ") + field->options
                                                         : std::string(typeName(field->type))));
    return false;
  }
  setField(settings, *field, value, warnings);
  return true;
}

std::string fieldText(const Settings& settings, const Field& field) {
  const double value = field.get(settings);
  switch (field.type) {
    case FieldType::Bool: return value != 0 ? "true" : "false";
    case FieldType::Choice: return std::string(optionName(field, static_cast<int>(value)));
    case FieldType::Color: return '#' + hexadecimal(static_cast<std::uint64_t>(value), 6);
    case FieldType::Int: return std::to_string(static_cast<int>(value));
    case FieldType::Float: return shortDecimal(value);
  }
  return {};
}

std::string fieldJson(const Settings& settings, const Field& field) {
  const std::string text = fieldText(settings, field);
  return field.type == FieldType::Color || field.type == FieldType::Choice ? jsonString(text) : text;
}

int optionIndex(const Field& field, std::string_view option) {
  for (int index = 0; !optionName(field, index).empty(); ++index)
    if (optionName(field, index) == option) return index;
  return -1;
}

std::string_view optionName(const Field& field, int index) {
  std::string_view rest = field.options;
  for (;;) {
    const std::size_t bar = rest.find('|');
    if (index == 0) return rest.substr(0, bar);
    if (bar == std::string_view::npos || index < 0) return {};
    rest.remove_prefix(bar + 1);
    --index;
  }
}

namespace {
const char* (*describe)(const Field&) = nullptr;
}

void describeFieldsWith(const char* (*tooltip)(const Field&)) { describe = tooltip; }

std::string fieldTableJson() {
  std::string out = "[";
  for (const Field& field : fields()) {
    const Settings standard;
    if (out.size() > 1) out += ',';
    out += "{\"name\":" + jsonString(field.name) + ",\"label\":" + jsonString(field.label) +
           ",\"group\":" + jsonString(field.group) + ",\"type\":" + jsonString(typeName(field.type)) +
           ",\"default\":" + fieldJson(standard, field) +
           ",\"min\":" + shortDecimal(field.low) + ",\"max\":" + shortDecimal(field.high) +
           ",\"unit\":" + jsonString(field.unit) + ",\"options\":" + jsonString(field.options) +
           (describe ? ",\"tooltip\":" + jsonString(describe(field)) : "") + ",\"coat\":" + (belongsToCoat(field) ? "true}" : "false}");
  }
  return out + ']';
}

}  // namespace fur::settings
