// The four fur types as coats. Type 0 here is type 1 for people: its coat are the settings' own values. Each of the others is bald,
// has strands and colours of a preset, or is a coat of its own with all fields that are kOfType.
//
// A preset that type2 to type4 name gives strands and colours alone: light, weight, skin and greatest length are those of
// type 1. loadType() makes the preset a type's own coat, whole.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "settings/Settings.h"

namespace fur::settings {

bool isOwn(const Settings& settings, int type);  // type 0 always is

// Settings whose values are the type's coat, as a panel shows them: a preset's whole; density 0 where it is bald.
Settings typeCoat(const Settings& settings, int type);
// The same as it is drawn: see above.
Settings drawnCoat(const Settings& settings, int type);
// Makes it the type's own coat: the fields of `coat` that are kOfType; of type 0 all that are kOfCoat.
void setTypeCoat(Settings& settings, int type, const Values& coat);
void makeBald(Settings& settings, int type);  // not of type 0
// What has been changed of typeCoat(settings, type), in a panel that shows it: the type's own values and all others.
void takeEdited(Settings& settings, int type, const Settings& edited);
// A preset becomes the type's own coat. False when there is none of that name.
bool loadType(Settings& settings, int type, std::string_view preset);

// The longest strand of those of `types` (a bit each; type 0 always counts).
float coatLength(const Settings& settings, unsigned types);
// That of the type as a share of `coatLength`, at most 1; 0: the type is bald.
float typeHeight(const Settings& settings, int type, float coatLength);

std::string_view typeName(const Settings& settings, int type);  // a person's; "" at first
// As many whole characters as fit.
void setTypeName(Settings& settings, int type, std::string_view name);

// Names such as "type2.curl", of the types 1 to 4. The last part is a field that is kOfType, "name", "preset", whose value
// is loaded, or "picture" or "typeSet", the number of a colour map or of a coat from a file, "" for none. A type that is set so becomes one of its own.
// "skin.picture" is the same of the skin: of type kSkin.
struct TypeField {
  int type;
  std::string_view name;
};
std::optional<TypeField> typeFieldOf(std::string_view name);
bool isTypeField(std::string_view name);
bool setTypeField(Settings& settings, const TypeField& of, std::string_view text, Warnings& warnings);
std::string typeFieldText(const Settings& settings, const TypeField& of);  // "": there is none of that name
// ,"type2.curl":0.3,... with all that `settings` say of types besides their fields: what is read back in that order is the same.
std::string typesJson(const Settings& settings);

}  // namespace fur::settings
