// The settings table as rows of widgets: a header per group, a row per field. Nothing here knows
// a field by name except the light's direction, which can also be dragged, and the animation, which has names.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "editor/Frequent.h"
#include "settings/Settings.h"

namespace fur::editor {

// The groups in the order of their first field.
std::vector<std::string_view> fieldGroups();

// Whether label, name or group contains `filter`, ignoring case. An empty filter matches all.
bool matchesFilter(const settings::Field& field, std::string_view filter);

// Draws every group that has a match into the current window and applies what the person does to
// `settings`. `animations`: names of what the model can play. Returns how many rows were drawn or would be in an open group.
int drawFields(settings::Settings& settings, Frequent& frequent, std::string_view filter, bool tooltips,
               std::span<const std::string> animations = {});

// One row of any table: name, widget, and what takes it back to its default. The new value where the person has changed it, not
// clamped yet. `tooltip`: "" for none.
std::optional<double> drawValue(const settings::FieldRow& field, double value, const char* tooltip);

// The section of the fields that are used frequently; they are in their groups, too. In either place a row's menu, by the
// right button or a finger that is held on its name, adds it to the section and takes it out.
void drawFrequent(settings::Settings& settings, Frequent& frequent, bool tooltips);

}  // namespace fur::editor
