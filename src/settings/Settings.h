// Everything a person can change, as plain values, and the table that describes each field.
// Fields.inc is the only place that lists them. No GL, no JSON: see StateJson in scene/.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <string_view>

#include "core/Result.h"
#include "settings/FieldTable.h"

namespace fur::settings {

struct Settings {
#define FUR_FIELDS "settings/Fields.inc"
#include "settings/fields/Members.inc"
#undef FUR_FIELDS
  bool operator==(const Settings&) const = default;
};

using Field = FieldOf<Settings>;

inline constexpr std::size_t kFieldCount = 0
#define FUR_FIELDS "settings/Fields.inc"
#include "settings/fields/Count.inc"
#undef FUR_FIELDS
    ;

const std::array<Field, kFieldCount>& fields();

// nullptr when no field has that name.
const Field* findField(std::string_view name);

// From text (FieldTable.h), by name; unknown names warn, too. "lightRig" is the name of a rig (LightRigs.h) that sets several.
bool setField(Settings& settings, std::string_view name, std::string_view text, Warnings& warnings);

// What the field does, in a line. Words for panels, which the viewer's download is spared: it does not call this.
const char* tooltipOf(const Field& field);

// The table as JSON for JavaScript: [{name,label,group,type,default,min,max,unit,options,coat}], and with tooltipOf() tooltip.
std::string fieldTableJson();
void describeFieldsWith(const char* (*tooltip)(const Field&));


}  // namespace fur::settings
