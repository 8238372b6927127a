// Tables of fields: rows that describe the members of a struct of plain values, such as Settings. Every value is read and
// written as a double (bool 0/1, colour 0xRRGGBB, choice its index), which holds each type exactly. The files of settings/fields make
// struct, rows and tooltips of a list of fields.
#pragma once

#include <string>
#include <string_view>
#include <type_traits>

#include "core/Result.h"

namespace fur::settings {

// Marks of fields in the table: see settings/Fields.inc.
inline constexpr unsigned kFrequent = 1, kOfCoat = 2, kOfType = 4 | kOfCoat;

enum class FieldType { Float, Int, Bool, Color, Choice };

struct FieldRow {
  const char* name;   // the key in files, links and JavaScript
  const char* label;  // what the panel shows
  const char* group;
  FieldType type;
  double standard, low, high;
  const char* unit;
  const char* options;  // "a|b|c" of a choice, else ""
  unsigned marks;
  bool has(unsigned mark) const { return (marks & mark) == mark; }
};

// A row of the table of `Values`.
template <class Values>
struct FieldOf : FieldRow {
  double (*get)(const Values&);
  void (*set)(Values&, double);  // the value must already be in range: see setField()
};

// The index of an option in a choice's "a|b|c", or -1.
int optionIndex(const FieldRow& field, std::string_view option);
// The option with that index ("" when out of range).
std::string_view optionName(const FieldRow& field, int index);

// The value as the field can hold it; one outside its range (or NaN) is clamped (NaN: the default) and a warning appended.
// Int and choice round to the nearest whole number.
double soundValue(const FieldRow& field, double value, Warnings& warnings);
// The value that a text gives, as links and command lines do: numbers, true/false/1/0, #rrggbb or rrggbb, option names.
// False and a warning where it cannot be read.
bool readValue(const FieldRow& field, std::string_view text, double& value, Warnings& warnings);
// The inverse: readValue(field, valueText(field, value)) gives the value back. And the same as a JSON value: in quotes where it
// is no number and no bool.
std::string valueText(const FieldRow& field, double value);
std::string valueJson(const FieldRow& field, double value);
// {"name":..,"label":..,"group":..,"type":..,"default":..,"min":..,"max":..,"unit":..,"options":..  without the closing brace.
std::string rowJson(const FieldRow& field);

// Sets one field; see soundValue().
template <class Values>
void setField(std::type_identity_t<Values>& values, const FieldOf<Values>& field, double value, Warnings& warnings) {
  field.set(values, soundValue(field, value, warnings));
}
// The same from text; returns whether the field was set.
template <class Values>
bool setFieldText(std::type_identity_t<Values>& values, const FieldOf<Values>& field, std::string_view text, Warnings& warnings) {
  double value = 0;
  if (!readValue(field, text, value, warnings)) return false;
  setField(values, field, value, warnings);
  return true;
}
template <class Values>
std::string fieldText(const std::type_identity_t<Values>& values, const FieldOf<Values>& field) { return valueText(field, field.get(values)); }
template <class Values>
std::string fieldJson(const std::type_identity_t<Values>& values, const FieldOf<Values>& field) { return valueJson(field, field.get(values)); }

// The last of a choice's options is its greatest value.
constexpr double greatestOption(const char* options) {
  int last = 0;
  for (const char* c = options; *c; ++c) last += *c == '|';
  return last;
}

}  // namespace fur::settings
