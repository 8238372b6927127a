// Everything a person can change, as plain values, and the table that describes each field.
// Fields.inc is the only place that lists them. No GL, no JSON: see StateJson in scene/.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <string_view>

#include "core/Result.h"

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

// A field's mark in the table.
inline constexpr bool kFrequent = true;

enum class FieldType { Float, Int, Bool, Color, Choice };

// One row of the table. Every value is read and written as a double (bool 0/1, colour 0xRRGGBB,
// choice its index), which holds each type exactly.
struct Field {
  const char* name;   // the key in files, links and JavaScript
  const char* label;  // what the panel shows
  const char* group;
  FieldType type;
  double standard, low, high;
  const char* unit;
  const char* options;  // "a|b|c" of a choice, else ""
  double (*get)(const Settings&);
  void (*set)(Settings&, double);  // the value must already be in range: see setField()
  bool frequent;  // artists change it often
};

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

// Sets one field; a value outside its range (or NaN) is clamped (NaN: the default) and a warning
// appended. Int and choice round to the nearest whole number.
void setField(Settings& settings, const Field& field, double value, Warnings& warnings);

// The same from text, as links and command lines give it: numbers, true/false/1/0, #rrggbb or
// rrggbb, option names. Unknown names and unreadable text change nothing and warn. Returns whether
// the field was set. "lightRig" is the name of a rig (LightRigs.h) that sets several.
bool setField(Settings& settings, std::string_view name, std::string_view text, Warnings& warnings);

// The inverse of the text form: setField(settings, name, fieldText(...)) gives the value back.
std::string fieldText(const Settings& settings, const Field& field);
// The same as a JSON value: in quotes where it is no number and no bool.
std::string fieldJson(const Settings& settings, const Field& field);

// The index of an option in a choice's "a|b|c", or -1.
int optionIndex(const Field& field, std::string_view option);
// The option with that index ("" when out of range).
std::string_view optionName(const Field& field, int index);

// What the field does, in a line. Words for panels, which the viewer's download is spared: it does not call this.
const char* tooltipOf(const Field& field);

// The table as JSON for JavaScript: [{name,label,group,type,default,min,max,unit,options,coat}], and with tooltipOf() tooltip.
std::string fieldTableJson();
void describeFieldsWith(const char* (*tooltip)(const Field&));


}  // namespace fur::settings
