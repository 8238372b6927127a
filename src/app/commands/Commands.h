// What a person does that is undone, recorded or saved, by name (Commands.inc).
#pragma once

#include <cstddef>
#include <optional>
#include <string_view>

#include "app/tools/Tools.h"

namespace fur::app {

enum class Command {
#define FUR_COMMAND(id, ...) id,
#include "app/commands/Commands.inc"
#undef FUR_COMMAND
};

std::string_view nameOf(Command command);
bool isRecorded(Command command);  // it is a stroke of water
// One that is none of them gives none.
std::optional<Command> commandNamed(std::string_view name);
std::optional<Command> commandNumbered(double number);
// The stroke of a tool that works on water; none for others.
std::optional<Command> strokeOf(Tool tool);
// The way back: None for strokes of no tool.
Tool toolOf(Command command);

}  // namespace fur::app
