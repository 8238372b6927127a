#include "settings/FieldTable.h"

#include <charconv>
#include <cmath>
#include <cstdint>

#include "core/Json.h"
#include "core/Math.h"
#include "core/NumberText.h"

namespace fur::settings {

namespace {

bool readColor(std::string_view text, double& value) {
  if (!text.empty() && text.front() == '#') text.remove_prefix(1);
  std::uint32_t rgb = 0;
  const auto result = std::from_chars(text.data(), text.data() + text.size(), rgb, 16);
  if (text.size() != 6 || result.ec != std::errc() || result.ptr != text.data() + text.size()) return false;
  value = rgb;
  return true;
}

bool read(const FieldRow& field, std::string_view text, double& value) {
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

int optionIndex(const FieldRow& field, std::string_view option) {
  for (int index = 0; !optionName(field, index).empty(); ++index)
    if (optionName(field, index) == option) return index;
  return -1;
}

std::string_view optionName(const FieldRow& field, int index) {
  std::string_view rest = field.options;
  for (;;) {
    const std::size_t bar = rest.find('|');
    if (index == 0) return rest.substr(0, bar);
    if (bar == std::string_view::npos || index < 0) return {};
    rest.remove_prefix(bar + 1);
    --index;
  }
}

double soundValue(const FieldRow& field, double value, Warnings& warnings) {
  const double given = value;
  if (std::isnan(value)) value = field.standard;
  // As the field holds it: the bound 3.1416f is a little less than the 3.1416 of a text.
  value = field.type == FieldType::Float ? static_cast<float>(glm::clamp(value, -1e30, 1e30)) : std::floor(value + 0.5);
  const double wanted = value;
  value = glm::clamp(value, field.low, field.high);
  if (std::isnan(given) || value != wanted)
    warnings.push_back(std::string(field.name) + ": " + shortDecimal(given) + " is outside " + shortDecimal(field.low) +
                       " to " + shortDecimal(field.high) + ", " + shortDecimal(value) + " is used");
  return value;
}

bool readValue(const FieldRow& field, std::string_view text, double& value, Warnings& warnings) {
  if (read(field, text, value)) return true;
  warnings.push_back(std::string(field.name) + ": \"" + std::string(text.substr(0, 64)) + "\" is not a " +
                     (field.type == FieldType::Choice ? std::string("choice of ") + field.options : std::string(typeName(field.type))));
  return false;
}

std::string valueText(const FieldRow& field, double value) {
  switch (field.type) {
    case FieldType::Bool: return value != 0 ? "true" : "false";
    case FieldType::Choice: return std::string(optionName(field, static_cast<int>(value)));
    case FieldType::Color: return '#' + hexadecimal(static_cast<std::uint64_t>(value), 6);
    case FieldType::Int: return decimal(static_cast<int>(value));
    case FieldType::Float: return shortDecimal(value);
  }
  return {};
}

std::string valueJson(const FieldRow& field, double value) {
  const std::string text = valueText(field, value);
  return field.type == FieldType::Color || field.type == FieldType::Choice ? jsonString(text) : text;
}

std::string rowJson(const FieldRow& field) {
  return "{\"name\":" + jsonString(field.name) + ",\"label\":" + jsonString(field.label) + ",\"group\":" + jsonString(field.group) +
         ",\"type\":" + jsonString(typeName(field.type)) + ",\"default\":" + valueJson(field, field.standard) +
         ",\"min\":" + shortDecimal(field.low) + ",\"max\":" + shortDecimal(field.high) + ",\"unit\":" + jsonString(field.unit) +
         ",\"options\":" + jsonString(field.options);
}

}  // namespace fur::settings
