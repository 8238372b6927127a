// The table of a scalp's values (HairFields.inc): panels, files and JavaScript read and set them by name.
#pragma once

#include <array>

#include "core/Json.h"
#include "hair/HairValues.h"
#include "settings/FieldTable.h"

namespace fur::hair {

using HairField = settings::FieldOf<HairValues>;

inline constexpr std::size_t kHairFieldCount = 0
#define FUR_FIELDS "hair/HairFields.inc"
#include "settings/fields/Count.inc"
#undef FUR_FIELDS
    ;

const std::array<HairField, kHairFieldCount>& hairFields();
// What the field does, in a line: words for panels, which the viewer's download is spared.
const char* tooltipOf(const HairField& field);
// nullptr when no field has that name.
const HairField* findHairField(std::string_view name);

// Values as a JSON object, those that differ from the defaults, or `all`; and back: values that cannot be read are skipped with a
// warning, those outside their range clamped.
std::string writeHairValues(const HairValues& values, bool all = false);
HairValues readHairValues(const Json& object, Warnings& warnings);

}  // namespace fur::hair
