// The tools, and what is to know of each. Tools.inc is the only place that lists them: who wants to know what a tool is or
// does asks here, and nobody compares two of them by their order.
#pragma once

#include <cstddef>
#include <optional>
#include <string_view>

namespace fur::app {

enum class Tool {
#define FUR_TOOL(id, ...) id,
#include "app/tools/Tools.inc"
#undef FUR_TOOL
};
inline constexpr std::size_t kToolCount = 0
#define FUR_TOOL(...) +1
#include "app/tools/Tools.inc"
#undef FUR_TOOL
    ;

// What pointers that are down do. Of a tool: Paint, Touch, Grab or Orbit.
enum class Drag { None, Paint, Touch, Orbit, Grab, Spin, Light, Pinch, Look };
// What a tool changes of what is kept.
enum class WorksOn { Nothing, Water, Groom, Hair };
// What a tool does while it is held where it is. Works: it goes on all the time. Repeats: one dab follows the other.
enum class Held { Nothing, Works, Repeats };

struct ToolTraits {
  const char* name;
  WorksOn on;
  Drag drag;
  Held held;
  float reach;  // radius of its footprint in brush radii; 0: none is shown
};
const ToolTraits& traitsOf(Tool tool);

inline bool grooms(Tool tool) { return traitsOf(tool).on == WorksOn::Groom; }
inline bool worksOnHair(Tool tool) { return traitsOf(tool).on == WorksOn::Hair; }
inline bool worksOnWater(Tool tool) { return traitsOf(tool).on == WorksOn::Water; }
inline bool paints(Tool tool) { return traitsOf(tool).drag == Drag::Paint; }
inline bool goesOn(Tool tool) { return traitsOf(tool).held == Held::Works; }
inline bool repeats(Tool tool) { return traitsOf(tool).held == Held::Repeats; }

// Names of files, links and JavaScript; one that is none of them gives none.
inline std::string_view nameOf(Tool tool) { return traitsOf(tool).name; }
std::optional<Tool> toolNamed(std::string_view name);

// Words for panels, which the viewer's download is spared: it does not call this.
struct ToolWords {
  const char *label, *inverseLabel, *row, *icon, *tooltip;
};
const ToolWords& wordsOf(Tool tool);

}  // namespace fur::app
