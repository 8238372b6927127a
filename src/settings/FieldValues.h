// "field=text field=text", as the tables of presets and light rigs have it.
#pragma once

#include <string_view>
#include <vector>

#include "settings/Settings.h"

namespace fur::settings {

struct FieldValue {
  std::string_view field, text;
};

std::vector<FieldValue> valuesOf(std::string_view values);
// An assertion where one does not fit its field.
void setValues(Settings& settings, std::string_view values);

}  // namespace fur::settings
