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

struct Values {
#define FUR_FIELDS "settings/Fields.inc"
#include "settings/fields/Members.inc"
#undef FUR_FIELDS
  bool operator==(const Values&) const = default;
};

inline constexpr int kFurTypes = 4;
// The skin has a place behind the types where pictures are told apart.
inline constexpr int kSkin = kFurTypes;
inline constexpr std::size_t kTypeNameBytes = 40;

// The values are those of the model and of fur type 1; what the other types have is read and set by FurTypes.h. Bytes can be
// copied as they are.
struct Settings : Values {
  // Of the types 2 to 4, of use where type2 to type4 are "own": the fields that are kOfType.
  std::array<Values, kFurTypes - 1> ownTypes{};
  std::array<std::array<char, kTypeNameBytes>, kFurTypes> typeNames{};  // UTF-8, ends with 0
  // Of what a type, or the skin, has from files, numbers (app/TypeShelf.h); 0: none. Colour maps; coats that take the place of
  // grown ones, of which the skin has none.
  std::array<std::uint32_t, kFurTypes + 1> typePictures{}, typeSets{};
  bool operator==(const Settings&) const = default;
};

using Field = FieldOf<Values>;

inline constexpr std::size_t kFieldCount = 0
#define FUR_FIELDS "settings/Fields.inc"
#include "settings/fields/Count.inc"
#undef FUR_FIELDS
    ;

const std::array<Field, kFieldCount>& fields();

// nullptr when no field has that name.
const Field* findField(std::string_view name);

// From text (FieldTable.h), by name; unknown names warn, too. "lightRig" is the name of a rig (LightRigs.h) that sets several;
// "type2.curl" is a value of a fur type, "skin.picture" the number of a colour map (FurTypes.h).
bool setField(Settings& settings, std::string_view name, std::string_view text, Warnings& warnings);

// Whether setField() knows the name; what it has been set to, "" where there is none; the rig whose light that is.
bool isSetting(std::string_view name);
std::string settingText(const Settings& settings, std::string_view name);

// What the field does, in a line. Words for panels, which the viewer's download is spared: it does not call this.
const char* tooltipOf(const Field& field);

// The table as JSON for JavaScript: [{name,label,group,type,default,min,max,unit,options,coat,ofType}], and with tooltipOf() tooltip.
std::string fieldTableJson();
void describeFieldsWith(const char* (*tooltip)(const Field&));

}  // namespace fur::settings
