#include "settings/LightRigs.h"

#include <algorithm>
#include <iterator>

#include "settings/FieldValues.h"

namespace fur::settings {

namespace {

constexpr LightRig kRigs[] = {
    {"daylight", "Daylight", ""},
    {"studio", "Studio",
     "lightFollowsCamera=1 lightYaw=-1 lightPitch=0.6 lightIntensity=0.9 fillLight=0.15 rimLight=0.8 ambient=0.12 backgroundTop=#44474c "
     "backgroundBottom=#85878a"},
    {"sunset", "Sunset",
     "lightYaw=-1.3 lightPitch=0.25 lightIntensity=1.4 keyColor=#ff9c4a rimLight=0.8 rimColor=#ff9858 skyColor=#a8a4d8 "
     "groundColor=#e0a080 backgroundTop=#4f5f8f backgroundBottom=#f2a86b"},
    {"overcast", "Overcast", "lightPitch=1.3 lightIntensity=0.35 keyColor=#e8f0ff ambient=0.8 backgroundTop=#a8b0b8 backgroundBottom=#d6d8d8"},
    {"backlit", "Backlit",
     "lightFollowsCamera=1 lightYaw=2.8 lightPitch=0.5 lightIntensity=0.9 fillLight=0.3 rimLight=1.6 rimColor=#fff0d8 ambient=0.25 "
     "backgroundTop=#2b3138 backgroundBottom=#5a5f63"},
    {"night", "Night",
     "lightYaw=0.9 lightPitch=0.8 lightIntensity=0.5 keyColor=#9db8ff rimLight=0.7 rimColor=#8fb0ff ambient=0.4 skyColor=#6f86c8 "
     "groundColor=#4a5070 backgroundTop=#0b1020 backgroundBottom=#1f2a44"},
};

// Each over the defaults.
Settings lightOf(const LightRig& rig) {
  Settings out;
  setValues(out, rig.values);
  return out;
}

}  // namespace

std::span<const LightRig> lightRigs() { return kRigs; }

bool belongsToLight(const Field& field) {
  constexpr std::string_view kFields[] = {"lightYaw", "lightPitch", "lightIntensity", "keyColor", "lightFollowsCamera", "fillLight", "rimLight",
                                          "rimColor", "ambient", "skyColor", "groundColor", "exposure", "backgroundTop", "backgroundBottom"};
  return std::find(std::begin(kFields), std::end(kFields), field.name) != std::end(kFields);
}

bool applyLightRig(Settings& settings, std::string_view name, Warnings& warnings) {
  std::string names;
  for (const LightRig& rig : kRigs) {
    names.append(" ").append(rig.name);
    if (name != rig.name) continue;
    const Settings light = lightOf(rig);
    for (const Field& field : fields())
      if (belongsToLight(field)) field.set(settings, field.get(light));
    return true;
  }
  warnings.push_back("lightRig: \"" + std::string(name.substr(0, 64)) + "\" is not one of" + names);
  return false;
}

const LightRig* lightRigOf(const Settings& settings) {
  for (const LightRig& rig : kRigs) {
    const Settings light = lightOf(rig);
    const auto differs = [&](const Field& field) { return belongsToLight(field) && field.get(settings) != field.get(light); };
    if (std::none_of(fields().begin(), fields().end(), differs)) return &rig;
  }
  return nullptr;
}

}  // namespace fur::settings
