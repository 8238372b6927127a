// Lists of settings as text, "field=text field=text", for the tables of presets and light rigs.
#pragma once

#include <string_view>
#include <vector>

#include "settings/Settings.h"

namespace fur::settings {

struct FieldValue {
  std::string_view field, text;
};

std::vector<FieldValue> valuesOf(std::string_view values);
// Asserts that all values are valid.
void setValues(Settings& settings, std::string_view values);

}  // namespace fur::settings
