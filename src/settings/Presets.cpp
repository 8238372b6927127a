#include "settings/Presets.h"

#include <algorithm>
#include <array>
#include <iterator>
#include <vector>

#include "settings/FieldValues.h"

namespace fur::settings {

namespace {

constexpr Preset kPresets[] = {
#define FUR_PRESET(name, label, tooltip, values) {name, label, tooltip, values},
#include "assets/Presets.inc"
#undef FUR_PRESET
};

using Coats = std::array<Settings, std::size(kPresets)>;

// Each preset over the defaults.
const Coats& coats() {
  static const Coats all = [] {
    Coats out;
    for (std::size_t i = 0; i < out.size(); ++i) setValues(out[i], kPresets[i].values);
    return out;
  }();
  return all;
}

}  // namespace

std::span<const Preset> presets() { return kPresets; }

const Preset* findPreset(std::string_view name) {
  for (const Preset& preset : kPresets)
    if (name == preset.name) return &preset;
  return nullptr;
}

void copyCoat(const Values& from, Values& to) {
  for (const Field& field : fields())
    if (field.has(kOfCoat)) field.set(to, field.get(from));
}

std::optional<Settings> applyPreset(const Settings& settings, std::string_view name) {
  const Preset* preset = findPreset(name);
  if (!preset) return {};
  const Settings& coat = coats()[static_cast<std::size_t>(preset - kPresets)];
  Settings out = settings;
  copyCoat(coat, out);
  return out;
}

int baldType(const Settings& settings) {
  const int types[] = {settings.type4, settings.type3, settings.type2};
  for (int i = 0; i < 3; ++i)
    if (types[i] == 0) return 4 - i;
  return 0;
}

const Preset* presetOf(const Settings& settings) {
  for (const Preset& preset : kPresets) {
    const Settings& coat = coats()[static_cast<std::size_t>(&preset - kPresets)];
    const auto differs = [&](const Field& field) { return field.has(kOfCoat) && field.get(settings) != field.get(coat); };
    if (std::none_of(fields().begin(), fields().end(), differs)) return &preset;
  }
  return nullptr;
}

std::string unknownPreset(std::string_view name) {
  std::string text = "preset: \"";
  text.append(name.substr(0, 64)).append("\" is not one of");
  for (const Preset& preset : kPresets) text.append(&preset == kPresets ? " " : ", ").append(preset.name);
  return text;
}

std::string presetTableJson() {
  // Nothing in this file needs escaping; the test reads it back.
  std::string out;
  for (const Preset& preset : kPresets) {
    out.append(out.empty() ? "[" : ",");
    out.append("{\"name\":\"").append(preset.name).append("\",\"label\":\"").append(preset.label);
    out.append("\",\"description\":\"").append(preset.description).append("\",\"settings\":");
    const char* before = "{\"";
    for (const FieldValue& value : valuesOf(preset.values)) {
      const char* quote = value.text.front() == '#' ? "\"" : "";
      out.append(before).append(value.field).append("\":").append(quote).append(value.text).append(quote);
      before = ",\"";
    }
    out.append("}}");
  }
  return out + ']';
}

}  // namespace fur::settings
