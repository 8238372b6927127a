// Light by name: each rig a few settings over the defaults of the fields that make the light of a scene.
//
// These are where the key light comes from, its brightness and colour, fill and rim light, sky and ground, exposure and the
// background, whose colours light the fur, too. A rig decides about all of them and leaves alone what the coat makes of light.
#pragma once

#include <span>
#include <string_view>

#include "settings/Settings.h"

namespace fur::settings {

struct LightRig {
  const char* name;    // the key in links, attributes and command lines
  const char* label;   // what a person sees
  const char* values;  // "field=text field=text", only fields of the light
};

std::span<const LightRig> lightRigs();
// Whether rigs decide about this field.
bool belongsToLight(const Field& field);
// False, and a warning that lists the names: there is none of that one.
bool applyLightRig(Settings& settings, std::string_view name, Warnings& warnings);
// The rig that these settings have; nullptr when it is none of them.
const LightRig* lightRigOf(const Settings& settings);

}  // namespace fur::settings
