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
#define FUR_FLOAT(name, label, group, value, low, high, unit, tip, ...) float name = value;
#define FUR_INT(name, label, group, value, low, high, unit, tip, ...) int name = value;
#define FUR_BOOL(name, label, group, value, tip, ...) bool name = value;
#define FUR_COLOR(name, label, group, value, tip, ...) std::uint32_t name = value;  // 0xRRGGBB, sRGB
#define FUR_CHOICE(name, label, group, value, options, tip, ...) int name = value;
#include "settings/Fields.inc"
#undef FUR_FLOAT
#undef FUR_INT
#undef FUR_BOOL
#undef FUR_COLOR
#undef FUR_CHOICE
  bool operator==(const Settings&) const = default;
};

using Field = FieldOf<Settings>;

inline constexpr std::size_t kFieldCount = 0
#define FUR_FLOAT(...) +1
#define FUR_INT(...) +1
#define FUR_BOOL(...) +1
#define FUR_COLOR(...) +1
#define FUR_CHOICE(...) +1
#include "settings/Fields.inc"
#undef FUR_FLOAT
#undef FUR_INT
#undef FUR_BOOL
#undef FUR_COLOR
#undef FUR_CHOICE
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
