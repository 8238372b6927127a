// Coats by name: each a few settings over the defaults of the fields that make a coat.
//
// A coat is made by the groups Fur, Shape and Colour, and by strandShadow, occlusion, specular, shininess,
// gravity and stiffness. A preset decides about all of these, so that the same name gives the same coat
// whatever was there before. It leaves alone what is a choice of quality (layers, tileSize, fins) or of the
// model (furMapping), what
// makes one coat of many alike (seed), how much of the model's own picture shows (textureAmount), and
// everything else: light, water, wind, view.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "settings/Settings.h"

namespace fur::settings {

struct Preset {
  const char* name;         // the key in links, attributes and command lines
  const char* label;        // what a person sees
  const char* description;  // one line
  const char* values;       // "field=text field=text": as setField() reads them, only fields of a coat
};

std::span<const Preset> presets();

// nullptr when none has that name.
const Preset* findPreset(std::string_view name);

// Whether presets decide about this field.
bool belongsToCoat(const Field& field);

// `settings` with the preset's coat; none when there is no such preset.
std::optional<Settings> applyPreset(const Settings& settings, std::string_view name);

// The preset whose coat these settings have; nullptr when it is none of them.
const Preset* presetOf(const Settings& settings);

// The coat of a fur type, 0 to 3: the settings' own, or the presets that type2 to type4 name; density 0 for "bald".
Settings typeCoat(const Settings& settings, int type);
// The longest strand of that type as a share of the settings' furLength, no more than 1 (type 0: 1); 0: it is bald.
float typeHeight(const Settings& settings, int type);

// The warning for a name that is none: it lists those that are.
std::string unknownPreset(std::string_view name);

// [{name,label,description,settings:{field: number, or text as fieldText() gives it}}] for JavaScript.
std::string presetTableJson();

}  // namespace fur::settings
