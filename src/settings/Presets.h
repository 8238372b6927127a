// Named coats: each is a few settings over the defaults of the fields of a coat.
//
// These fields are kOfCoat (Fields.inc). A preset sets all of them, so that a name gives the same coat whatever was set before,
// and nothing else.
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

// nullptr when there is none.
const Preset* findPreset(std::string_view name);

// Copies the fields that are kOfCoat.
void copyCoat(const Values& from, Values& to);
// `settings` with the preset's coat; none when there is no such preset.
std::optional<Settings> applyPreset(const Settings& settings, std::string_view name);

// The preset whose values these settings have; nullptr when there is none.
const Preset* presetOf(const Settings& settings);

// The last of the types 2 to 4 that grows nothing, by which fur is thinned; 0: all of them grow something.
int baldType(const Settings& settings);

// The warning for an unknown name, which lists the known ones.
std::string unknownPreset(std::string_view name);

// [{name,label,description,settings:{field: number, or text as fieldText() gives it}}] for JavaScript.
std::string presetTableJson();

}  // namespace fur::settings
