// Named light rigs: each is a few settings over the defaults of the fields of light.
//
// These fields are the key light's direction, brightness and colour, fill and rim light, sky and ground, exposure, and the
// background, whose colours light the fur, too. A rig sets all of them, and no field of how the coat reflects light.
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
// Whether rigs set this field.
bool belongsToLight(const Field& field);
// False, with a warning that lists the names, when there is no such rig.
bool applyLightRig(Settings& settings, std::string_view name, Warnings& warnings);
// The rig whose values these settings have; nullptr when there is none.
const LightRig* lightRigOf(const Settings& settings);

}  // namespace fur::settings
