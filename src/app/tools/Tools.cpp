#include "app/tools/Tools.h"

#include "app/tools/RowNamed.h"

namespace fur::app {

namespace {

constexpr ToolTraits kTraits[] = {
#define FUR_TOOL(id, name, program, on, drag, held, reach, ...) {name, WorksOn::on, Drag::drag, Held::held, reach},
#include "app/tools/Tools.inc"
#undef FUR_TOOL
};

}  // namespace

const ToolTraits& traitsOf(Tool tool) { return kTraits[static_cast<std::size_t>(tool)]; }

std::optional<Tool> toolNamed(std::string_view name) { return rowNamed<Tool>(kTraits, name); }

const ToolWords& wordsOf(Tool tool) {
#define FUR_TOOL(id, name, program, on, drag, held, reach, label, inverse, row, place, icon, keys, tooltip) {label, inverse, row, icon, tooltip},
  static constexpr ToolWords kWords[] = {
#include "app/tools/Tools.inc"
  };
#undef FUR_TOOL
  return kWords[static_cast<std::size_t>(tool)];
}

}  // namespace fur::app
