#include "settings/FieldValues.h"

#include <algorithm>

#include "core/Assert.h"

namespace fur::settings {

std::vector<FieldValue> valuesOf(std::string_view rest) {
  std::vector<FieldValue> values;
  while (!rest.empty()) {
    const std::string_view pair = rest.substr(0, rest.find(' '));
    rest.remove_prefix(std::min(rest.size(), pair.size() + 1));
    const std::size_t equals = pair.find('=');
    values.push_back({pair.substr(0, equals), pair.substr(equals + 1)});
  }
  return values;
}

void setValues(Settings& settings, std::string_view values) {
  Warnings warnings;
  for (const FieldValue& value : valuesOf(values)) setField(settings, value.field, value.text, warnings);
  FUR_ASSERT(warnings.empty(), "settings::setValues()", "values that fit their fields", warnings.front());
}

}  // namespace fur::settings
