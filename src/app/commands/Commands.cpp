#include "app/commands/Commands.h"

#include <iterator>

#include "app/tools/RowNamed.h"

namespace fur::app {

namespace {

enum class Kept { Undone, Recorded };

struct Row {
  const char* name;
  Kept kept;
  int number;
};
constexpr Row kRows[] = {
#define FUR_COMMAND(id, name, kept, number) {name, Kept::kept, number},
#include "app/commands/Commands.inc"
#undef FUR_COMMAND
};

}  // namespace

std::string_view nameOf(Command command) { return kRows[static_cast<std::size_t>(command)].name; }

bool isRecorded(Command command) { return kRows[static_cast<std::size_t>(command)].kept == Kept::Recorded; }

std::optional<Command> commandNamed(std::string_view name) { return rowNamed<Command>(kRows, name); }

std::optional<Command> commandNumbered(double number) {
  for (std::size_t i = 0; i < std::size(kRows); ++i)
    if (kRows[i].number >= 0 && number == kRows[i].number) return static_cast<Command>(i);
  return std::nullopt;
}

std::optional<Command> strokeOf(Tool tool) { return worksOnWater(tool) ? commandNamed(nameOf(tool)) : std::nullopt; }

Tool toolOf(Command command) {
  const auto tool = toolNamed(nameOf(command));
  return tool && worksOnWater(*tool) ? *tool : Tool::None;
}

}  // namespace fur::app
