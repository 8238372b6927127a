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

constexpr std::string_view kGroups[] = {"Fur", "Shape", "Colour"};
constexpr std::string_view kNotOfThem[] = {"layers", "tileSize", "furMapping", "fins", "seed", "textureAmount"};
constexpr std::string_view kBeyond[] = {"strandShadow", "occlusion", "specular", "shininess", "gravity", "stiffness"};

template <std::size_t n>
bool isOneOf(std::string_view text, const std::string_view (&list)[n]) {
  return std::find(std::begin(list), std::end(list), text) != std::end(list);
}

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

void copyCoat(const Settings& from, Settings& to) {
  for (const Field& field : fields())
    if (belongsToCoat(field)) field.set(to, field.get(from));
}

}  // namespace

std::span<const Preset> presets() { return kPresets; }

const Preset* findPreset(std::string_view name) {
  for (const Preset& preset : kPresets)
    if (name == preset.name) return &preset;
  return nullptr;
}

bool belongsToCoat(const Field& field) {
  return isOneOf(field.group, kGroups) ? !isOneOf(field.name, kNotOfThem) : isOneOf(field.name, kBeyond);
}

std::optional<Settings> applyPreset(const Settings& settings, std::string_view name) {
  const Preset* preset = findPreset(name);
  if (!preset) return {};
  const Settings& coat = coats()[static_cast<std::size_t>(preset - kPresets)];
  Settings out = settings;
  copyCoat(coat, out);
  return out;
}

Settings typeCoat(const Settings& settings, int type) {
  if (type == 0) return settings;
  const int chosen = type == 1 ? settings.type2 : type == 2 ? settings.type3 : settings.type4;
  Settings out = settings;
  if (chosen == 0) out.density = 0;
  else copyCoat(coats()[static_cast<std::size_t>(chosen - 1)], out);
  return out;
}

int baldType(const Settings& settings) {
  const int types[] = {settings.type4, settings.type3, settings.type2};
  for (int i = 0; i < 3; ++i)
    if (types[i] == 0) return 4 - i;
  return 0;
}

float typeHeight(const Settings& settings, int type) {
  if (type == 0) return 1;
  const Settings coat = typeCoat(settings, type);
  return coat.density > 0 ? std::min(coat.furLength / std::max(settings.furLength, 1e-6f), 1.0f) : 0;
}

const Preset* presetOf(const Settings& settings) {
  for (const Preset& preset : kPresets) {
    const Settings& coat = coats()[static_cast<std::size_t>(&preset - kPresets)];
    const auto differs = [&](const Field& field) { return belongsToCoat(field) && field.get(settings) != field.get(coat); };
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
