#include "settings/Presets.h"

#include <algorithm>
#include <array>
#include <iterator>
#include <vector>

#include "settings/FieldValues.h"

namespace fur::settings {

namespace {

// The first five are those of Sheppard 2004, 6.2.1, whose figures name thickness, density and curliness
// (chinchilla: 0.3, 1.0, 0.1, and a tile that repeats more often).
constexpr Preset kPresets[] = {
    {"rabbit", "Rabbit", "Soft agouti: slate at the root, sandy at the tip, over a woolly undercoat",
     "density=0.95 thickness=0.3 curl=0.15 furLength=0.11 repeat=5 undercoat=0.6 undercoatLength=0.6 "
     "rootColor=#57524f tipColor=#b89c78 skinColor=#8a6f66 variance=0.5 specular=0.3 gravity=0.15"},
    {"chinchilla", "Chinchilla", "The densest of all: fine silver-grey with dark roots and pale tips",
     "density=1 thickness=0.3 curl=0.1 lengthVariation=0.15 furLength=0.11 repeat=8 rootColor=#363a42 "
     "tipColor=#d9dce0 skinColor=#7c7478 variance=0.25 specular=0.15 occlusion=0.7 gravity=0.1"},
    {"curlyDog", "Curly dog", "Rolls of curls that fold back on themselves, over an undercoat",
     "density=1 thickness=0.6 curl=0 furLength=0.16 repeat=3 coil=0.55 clump=1 lockSize=0.7 stray=0.05 "
     "undercoat=0.7 undercoatLength=0.5 rootColor=#4a3020 tipColor=#b07d4c skinColor=#4a3020 variance=0.35 "
     "specular=0.35"},
    {"thickNylon", "Thick nylon", "A toy's fur: thick rolled locks, and threads that none of them holds",
     "density=0.9 thickness=0.3 taper=0.4 lengthVariation=0.15 curl=0.2 furLength=0.2 repeat=2.5 clump=1 "
     "roll=0.35 stray=0.06 rootColor=#7d1b4c tipColor=#e85c98 skinColor=#54203a variance=0.2 "
     "specular=0.8 shininess=120"},
    {"fineSparse", "Fine sparse", "Thin hair, through which the skin shows",
     "density=0.25 thickness=0.08 lengthVariation=0.5 curl=0.2 furLength=0.14 rootColor=#8f7056 "
     "tipColor=#cdb695 skinColor=#dcab94 strandShadow=0.2 occlusion=0.2 gravity=0.35"},
    {"otter", "Otter", "Dark glossy guard hairs over a dense undercoat",
     "density=1 thickness=0.25 lengthVariation=0.2 curl=0.08 furLength=0.07 repeat=6 undercoat=1 "
     "undercoatLength=0.5 rootColor=#2b1d15 tipColor=#5d4331 skinColor=#463129 specular=0.55 shininess=90 "
     "stiffness=0.7"},
    {"shortCat", "Shorthair", "A cat's short coat: sleek, ginger",
     "density=1 thickness=0.28 lengthVariation=0.2 curl=0.05 furLength=0.05 repeat=6 undercoat=0.3 "
     "rootColor=#8a5a30 tipColor=#dd9850 skinColor=#a4735c specular=0.7 shininess=80 stiffness=0.8"},
    {"persian", "Persian", "A cat's long coat: very fine and soft, in cream",
     "density=1 thickness=0.18 taper=0.7 curl=0.15 furLength=0.28 repeat=5 wave=0.35 clump=0.2 tipBreak=0.5 "
     "undercoat=0.4 rootColor=#c4b6a4 tipColor=#f7f1e8 skinColor=#c99f90 variance=0.25 gravity=0.4 "
     "stiffness=0.3"},
    {"shag", "Shag", "Long, thick and loose, as a carpet of the seventies",
     "density=0.7 thickness=0.55 furLength=0.32 repeat=3 wave=0.3 clump=0.5 lockSize=0.45 stray=0.25 "
     "tipBreak=0.3 rootColor=#6e3d12 tipColor=#dfa13e skinColor=#5a3a1c gravity=0.6 stiffness=0.2"},
    {"velvet", "Velvet", "A very short pile without variation",
     "density=1 thickness=0.6 lengthVariation=0 curl=0 taper=0 furLength=0.02 repeat=12 rootColor=#4a0713 "
     "tipColor=#a8172f skinColor=#3a0610 variance=0.1 specular=0.6 shininess=20 occlusion=0.8 gravity=0 "
     "stiffness=1"},
    {"wool", "Wool", "A fleece: frizzy coils, tight in their locks, in cream",
     "density=1 thickness=0.5 curl=0 furLength=0.11 repeat=5 coil=0.35 frizz=0.4 clump=0.9 lockSize=0.4 "
     "undercoat=0.6 tipBreak=0.2 rootColor=#cab892 tipColor=#f4ebd8 skinColor=#d2a898 variance=0.25 specular=0.15"},
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
